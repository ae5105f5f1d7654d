// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/measure/tightness.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/off_file.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"
#include "testdata/oracle/oracle.h"

// The figures against an independent judge.
// CAGEWRIGHT_ORACLE and CAGEWRIGHT_MVC_CAGES come from CMake and may be empty.
namespace cagewright {
namespace {

const std::filesystem::path mvc_cages = CAGEWRIGHT_MVC_CAGES;

IndexedMesh read_obj(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<double> points;
  std::vector<int> triangles;
  for (std::string line, word; std::getline(file, line);) {
    std::istringstream words(line);
    words >> word;
    for (int i = 0; i < 3 && (word == "v" || word == "f"); ++i) {
      std::string number;
      words >> number;
      if (word == "v") points.push_back(std::stod(number));
      if (word == "f") triangles.push_back(std::stoi(number) - 1);
    }
  }
  if (points.empty()) throw std::runtime_error("no mesh in " + path.string());
  return {Eigen::Map<Points>(points.data(), static_cast<Eigen::Index>(points.size() / 3), 3),
          Eigen::Map<Triangles>(triangles.data(), static_cast<Eigen::Index>(triangles.size() / 3), 3)};
}

// The oracle prints 6 digits.
void expect_as_oracle(const IndexedMesh& model, const IndexedMesh& cage, const nlohmann::json& verdict) {
  const Tightness tightness = measure_tightness(MeasuredModel(model), cage, certify(model, cage));
  const auto expect_near = [&](double ours, const char* key) {
    const double theirs = verdict.at(key).get<double>();
    EXPECT_NEAR(ours, theirs, 1e-5 * std::abs(theirs)) << key;
  };
  ASSERT_TRUE(tightness.volume_ratio);
  EXPECT_NEAR(*tightness.volume_ratio, std::abs(verdict.at("volume_ratio").get<double>()), 2e-5);
  expect_near(tightness.mean_gap, "mean_gap_over_diagonal");
  expect_near(tightness.max_gap, "max_gap_over_diagonal");
  EXPECT_EQ(tightness.coverage == 1, verdict.at("model_vertices_outside") == 0);
  EXPECT_EQ(tightness.clearance == 0, verdict.at("model_triangles_crossing_cage") > 0);
}

TEST(MeasureOracle, AgreesOnCagesMadeByHand) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  if (mvc_cages.empty()) GTEST_SKIP() << "cages made by hand: configure with -DCAGEWRIGHT_MVC_CAGES=DIR";
  for (const auto& [model, cage] : {std::pair("armadillo/armadilloman.obj", "armadillo/bounding_mesh.obj"),
                                    std::pair("armadillo/armadilloman.obj", "armadillo/deformed_bounding_mesh1.obj"),
                                    std::pair("horse/horse.obj", "horse/bounding_meshb.obj"),
                                    std::pair("horse/horse.obj", "horse/deformed_bounding_mesh2b.obj")}) {
    SCOPED_TRACE(cage);
    expect_as_oracle(read_obj(mvc_cages / model), read_obj(mvc_cages / cage),
                     ask_oracle(oracle, mvc_cages / model, mvc_cages / cage));
  }
}

TEST(MeasureOracle, AgreesOnOurOwnCages) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  for (const shapes::SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Model model = prepare_model(body.mesh);
    const PipelineResult result = make_cage(model, body.slides, {});
    Random random(9);
    for (const double shaking : {0.0, 0.05}) {
      IndexedMesh cage{result.cage->points, result.cage->triangles};
      for (Eigen::Index v = 0; v < cage.points.rows(); ++v)
        cage.points.row(v) += shaking * model.diagonal * random.uniform(0, 1) * random.direction().transpose();
      const TemporaryOff model_file(body.mesh, "model"), cage_file(cage, "cage");
      expect_as_oracle(body.mesh, cage, ask_oracle(oracle, model_file.path(), cage_file.path()));
    }
  }
}

}  // namespace
}  // namespace cagewright
