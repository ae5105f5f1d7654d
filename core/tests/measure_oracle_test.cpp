// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "core/measure/tightness.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

// The figures against an independent judge, a program `ORACLE MODEL CAGE` that prints one JSON object.
// CAGEWRIGHT_ORACLE and CAGEWRIGHT_MVC_CAGES come from CMake and may be empty.
namespace cagewright {
namespace {

const std::string oracle = CAGEWRIGHT_ORACLE;
const std::filesystem::path mvc_cages = CAGEWRIGHT_MVC_CAGES;
const char* const no_oracle =
    "no oracle: configure with -DCAGEWRIGHT_ORACLE_SOURCE=FILE and the host, with CGAL, Boost, GMP and MPFR installed";

std::filesystem::path write_off(const IndexedMesh& mesh, const std::string& name) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("cagewright_measure_" + name + ".off");
  std::ofstream file(path);
  file << "OFF\n" << mesh.points.rows() << ' ' << mesh.triangles.rows() << " 0\n" << std::setprecision(17);
  for (const auto& point : mesh.points.rowwise()) file << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  for (const auto& t : mesh.triangles.rowwise()) file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return path;
}

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

nlohmann::json ask_oracle(const std::filesystem::path& model, const std::filesystem::path& cage) {
  const std::string command = "'" + oracle + "' '" + model.string() + "' '" + cage.string() + "'";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the oracle does not start");
  std::string output;
  std::array<char, 4096> bytes;
  while (const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), pipe)) output.append(bytes.data(), got);
  if (::pclose(pipe) != 0) throw std::runtime_error("the oracle failed: " + command);
  return nlohmann::json::parse(output);
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
                     ask_oracle(mvc_cages / model, mvc_cages / cage));
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
      const auto model_file = write_off(body.mesh, "model"), cage_file = write_off(cage, "cage");
      const nlohmann::json verdict = ask_oracle(model_file, cage_file);
      std::filesystem::remove(model_file);
      std::filesystem::remove(cage_file);
      expect_as_oracle(body.mesh, cage, verdict);
    }
  }
}

}  // namespace
}  // namespace cagewright
