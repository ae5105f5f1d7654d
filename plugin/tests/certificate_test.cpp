// SPDX-License-Identifier: BSD-3-Clause
//
// Certificate and measures: of a session's cage, and of any other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

struct Evaluation {
  Evaluation(const Mesh& model, const Mesh& cage) {
    const cgw_mesh m = model.view(), c = cage.view();
    status = api().evaluation_create(&m, &c, 0, &handle);
  }
  ~Evaluation() { api().evaluation_destroy(handle); }
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;
  cgw_certificate certificate() const {
    cgw_certificate c = CGW_CERTIFICATE_INIT;
    EXPECT_EQ(api().evaluation_certificate(handle, &c), CGW_OK) << api().last_error(nullptr);
    return c;
  }
  cgw_measures measures() const {
    cgw_measures m = CGW_MEASURES_INIT;
    EXPECT_EQ(api().evaluation_measures(handle, &m), CGW_OK) << api().last_error(nullptr);
    return m;
  }
  cgw_evaluation* handle = nullptr;
  cgw_status status = CGW_OK;
};

// Edges of length `size` round the origin.
Mesh cube(double size) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) mesh.vertices.push_back(size * ((i >> axis & 1) - 0.5));
  }
  mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

TEST(AbiEvaluation, OfACubeInACubeIsWhatAnyoneCanWorkOut) {
  const Evaluation evaluation(cube(1), cube(2));
  ASSERT_EQ(evaluation.status, CGW_OK) << api().last_error(nullptr);
  const cgw_certificate c = evaluation.certificate();
  EXPECT_EQ(c.encloses, 1u);
  EXPECT_EQ(c.closed, 1u);
  EXPECT_EQ(c.degenerate_count + c.self_intersection_count + c.model_intersection_count + c.outside_count, 0u);
  EXPECT_STREQ(c.message, "");
  const cgw_measures m = evaluation.measures();
  EXPECT_NEAR(m.volume_ratio, 8, 1e-12);
  EXPECT_NEAR(m.clearance, 0.5 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(m.least_dihedral, std::acos(-1.0) / 2, 1e-12);
  EXPECT_NEAR(m.greatest_dihedral, std::acos(-1.0), 1e-12);
  EXPECT_EQ(m.coverage, 1);
  EXPECT_NEAR(m.mean_asymmetry, 0, 1e-9);
  EXPECT_TRUE(std::isnan(m.worst_squareness)) << "nobody knows its sections";
  EXPECT_EQ(m.section_count + m.twist_count, 0u);
}

TEST(AbiEvaluation, NamesRowsOfTheMeshesThatWereGiven) {
  Mesh model = cube(1), cage = cube(0.5);
  // Unused and doubled vertices in front, and triangles that are none.
  model.vertices.insert(model.vertices.begin(), {9, 9, 9, -0.5, -0.5, -0.5});
  for (std::uint32_t& corner : model.triangles) corner += 2;
  model.triangles.insert(model.triangles.begin(), {2, 2, 3});
  cage.triangles.insert(cage.triangles.begin(), {1, 1, 1});
  for (std::size_t i = 0; i < 24; i += 3) cage.vertices[i] += 0.5;  // half of it is out
  const Evaluation evaluation(model, cage);
  ASSERT_EQ(evaluation.status, CGW_OK);
  cgw_certificate c = evaluation.certificate();
  EXPECT_EQ(c.encloses, 0u);
  EXPECT_EQ(c.closed, 1u);
  ASSERT_EQ(c.degenerate_count, 1u);
  EXPECT_EQ(c.outside_count, 8u);
  ASSERT_GT(c.model_intersection_count, 0u);
  std::vector<std::uint32_t> degenerate(1), outside(8), meets(2 * c.model_intersection_count);
  c.degenerate_triangles = degenerate.data();
  c.degenerate_capacity = 1;
  c.outside_vertices = outside.data();
  c.outside_capacity = 7;
  c.model_intersections = meets.data();
  c.model_intersection_capacity = c.model_intersection_count;
  EXPECT_EQ(api().evaluation_certificate(evaluation.handle, &c), CGW_ERROR_BUFFER_TOO_SMALL);
  EXPECT_NE(std::string(api().last_error(nullptr)).find("vertices outside"), std::string::npos);
  c.outside_capacity = 8;
  ASSERT_EQ(api().evaluation_certificate(evaluation.handle, &c), CGW_OK);
  EXPECT_EQ(degenerate[0], 0u);
  EXPECT_EQ(outside, (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7, 8, 9}));
  for (std::size_t k = 0; k < meets.size(); k += 2) {
    EXPECT_GE(meets[k], 1u);
    EXPECT_LT(meets[k], 13u);
    EXPECT_GE(meets[k + 1], 1u);
    EXPECT_LT(meets[k + 1], 13u);
  }
}

TEST(AbiEvaluation, ToTouchIsNotToEnclose) {
  const Evaluation same(cube(1), cube(1));
  EXPECT_EQ(same.certificate().encloses, 0u);
  EXPECT_EQ(same.certificate().outside_count, 8u);
  EXPECT_EQ(same.certificate().model_intersection_count, 12u);
  EXPECT_EQ(same.measures().clearance, 0);
}

TEST(AbiEvaluation, FindsCagesThatCrossThemselvesOrFaceInward) {
  Mesh crossing = cube(2);
  std::swap_ranges(crossing.vertices.begin(), crossing.vertices.begin() + 3, crossing.vertices.begin() + 21);
  EXPECT_GT(Evaluation(cube(1), crossing).certificate().self_intersection_count, 0u);
  EXPECT_EQ(Evaluation(cube(1), turned_inside_out(cube(2))).certificate().closed, 0u);
  Mesh open = cube(2);
  open.triangles.resize(33);
  EXPECT_EQ(Evaluation(cube(1), open).certificate().closed, 0u);
  EXPECT_TRUE(std::isnan(Evaluation(cube(1), open).measures().volume_ratio));
  EXPECT_EQ(Evaluation(turned_inside_out(cube(1)), cube(2)).certificate().encloses, 1u) << "models may face inward";
}

TEST(AbiEvaluation, RefusesWhatIsNoMeshAndSaysWhichOne) {
  const auto sentence = [](const Mesh& model, const Mesh& cage, cgw_status expected) {
    const Evaluation evaluation(model, cage);
    EXPECT_EQ(evaluation.status, expected);
    EXPECT_EQ(evaluation.handle, nullptr);
    return std::string(api().last_error(nullptr));
  };
  Mesh empty;
  Mesh index = cube(1);
  index.triangles[0] = 8;
  Mesh flat = cube(1);
  for (std::size_t i = 0; i < 24; i += 3) flat.vertices[i] = 0;
  EXPECT_EQ(sentence(empty, cube(1), CGW_ERROR_MESH_EMPTY).find("the model: "), 0u);
  EXPECT_EQ(sentence(cube(1), empty, CGW_ERROR_MESH_EMPTY).find("the cage: "), 0u);
  EXPECT_EQ(sentence(cube(1), index, CGW_ERROR_MESH_INDEX).find("the cage: triangle 0"), 0u);
  EXPECT_NE(sentence(flat, cube(1), CGW_ERROR_MESH_EMPTY).find("no volume"), std::string::npos);
  const cgw_mesh mesh = cube(1).view();
  EXPECT_EQ(api().evaluation_create(&mesh, &mesh, 0, nullptr), CGW_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(api().evaluation_create(nullptr, &mesh, 0, nullptr), CGW_ERROR_INVALID_ARGUMENT);
  cgw_certificate certificate = CGW_CERTIFICATE_INIT;
  cgw_measures measures = CGW_MEASURES_INIT;
  EXPECT_EQ(api().evaluation_certificate(nullptr, &certificate), CGW_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(api().evaluation_measures(nullptr, &measures), CGW_ERROR_INVALID_ARGUMENT);
  api().evaluation_destroy(nullptr);
}

TEST(AbiCertificate, IsThatOfTheCageAsItIs) {
  const SolvedCapsule solved;
  cgw_certificate c = CGW_CERTIFICATE_INIT;
  ASSERT_EQ(api().get_certificate(solved.session, &c), CGW_OK) << solved.session.error();
  EXPECT_EQ(c.encloses, 1u);
  EXPECT_EQ(c.keeps_distance, 1u);
  cgw_summary summary = CGW_SUMMARY_INIT;
  ASSERT_EQ(api().get_summary(solved.session, &summary), CGW_OK);
  EXPECT_EQ(summary.last_stage, CGW_STAGE_ENCLOSE);
  EXPECT_EQ(summary.certified, 1u);
  EXPECT_GE(summary.enclose_ms, 0);
  const Cage cage = cage_of(solved.session);
  const Evaluation other(capsule(), {cage.vertices, cage.triangles});
  EXPECT_EQ(other.certificate().encloses, 1u);
  cgw_measures m = CGW_MEASURES_INIT;
  ASSERT_EQ(api().get_measures(solved.session, &m), CGW_OK);
  EXPECT_NEAR(m.volume_ratio, summary.volume_ratio, 1e-9);
  EXPECT_NEAR(m.volume_ratio, other.measures().volume_ratio, 1e-9);
  EXPECT_NEAR(m.mean_gap, other.measures().mean_gap, 1e-9);
  for (const double value : cage.vertices) EXPECT_EQ(value, static_cast<double>(static_cast<float>(value)));
}

// The hole of the torus is narrower than the distance that is asked for.
TEST(AbiFinding, IsASentenceOfTheMessageWithItsSlidesAndPlace) {
  const SolvedCapsule solved;
  cgw_certificate c = CGW_CERTIFICATE_INIT;
  ASSERT_EQ(api().get_certificate(solved.session, &c), CGW_OK);
  EXPECT_EQ(c.finding_count, 0u);
  cgw_finding finding = CGW_FINDING_INIT;
  EXPECT_EQ(api().get_finding(solved.session, 0, &finding), CGW_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(solved.session.error().find("there is no finding at index 0"), std::string::npos) << solved.session.error();

  const Session session(torus());
  const std::array<std::string, 3> names = {"one", "two", "three"};
  std::array<std::uint64_t, 3> ids{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = 2 + 2 * std::acos(-1.0) * static_cast<double>(k) / 3, x = std::cos(angle), y = std::sin(angle);
    cgw_slide_input slide = plane(names[k].c_str(), 3 * x, -y, x);
    slide.point[1] = 3 * y;
    ASSERT_EQ(api().slide_add(session, &slide, &ids[k]), CGW_OK);
  }
  ASSERT_EQ(api().set_parameter(session, "refine.delta", 0.25), CGW_OK);
  ASSERT_EQ(api().set_parameter(session, "enclose.merge", 0), CGW_OK);
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  ASSERT_EQ(api().get_certificate(session, &c), CGW_OK);
  ASSERT_GT(c.finding_count, 0u) << c.message;
  std::string sentences;
  for (std::uint64_t i = 0; i < c.finding_count; ++i) {
    finding = CGW_FINDING_INIT;
    ASSERT_EQ(api().get_finding(session, i, &finding), CGW_OK);
    sentences += (i == 0 ? "" : "; ") + std::string(finding.message);
    ASSERT_GT(finding.slide_count, 0u);
    std::vector<std::uint64_t> slides(finding.slide_count);
    finding.slides = slides.data();
    finding.slide_capacity = finding.slide_count - 1;
    EXPECT_EQ(api().get_finding(session, i, &finding), CGW_ERROR_BUFFER_TOO_SMALL);
    finding.slide_capacity = finding.slide_count;
    ASSERT_EQ(api().get_finding(session, i, &finding), CGW_OK);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(std::count(slides.begin(), slides.end(), ids[k]),
                std::string(finding.message).find("'" + names[k] + "'") != std::string::npos);
    const bool is_of_distance =
        std::string(finding.message).find("not with the distance asked for") != std::string::npos;
    EXPECT_EQ(finding.is_advice, is_of_distance ? 0u : 1u) << finding.message;
    if (i > 0) continue;
    EXPECT_TRUE(is_of_distance) << finding.message;
    ASSERT_EQ(finding.has_point, 1u);
    EXPECT_LT(std::hypot(finding.point[0], finding.point[1]), 3) << "it is in the hole";
  }
  EXPECT_EQ(sentences, c.message);
  EXPECT_EQ(api().get_finding(session, c.finding_count, &finding), CGW_ERROR_INVALID_ARGUMENT);
}

TEST(AbiMeasures, KnowTheSectionsOfASession) {
  const SolvedCapsule solved;
  cgw_measures m = CGW_MEASURES_INIT;
  ASSERT_EQ(api().get_measures(solved.session, &m), CGW_OK);
  ASSERT_EQ(m.section_count, 3u);
  ASSERT_EQ(m.twist_count, 2u);
  EXPECT_LT(m.worst_squareness, 15.1 * std::acos(-1.0) / 180);
  EXPECT_LT(m.worst_planarity, 1e-6) << "rounded to floats";
  std::vector<double> squareness(3), planarity(3), twist(2);
  std::vector<std::int32_t> between(4);
  m.squareness = squareness.data();
  m.planarity = planarity.data();
  m.section_capacity = 3;
  m.twist = twist.data();
  m.twist_between = between.data();
  m.twist_capacity = 1;
  EXPECT_EQ(api().get_measures(solved.session, &m), CGW_ERROR_BUFFER_TOO_SMALL);
  m.twist_capacity = 2;
  ASSERT_EQ(api().get_measures(solved.session, &m), CGW_OK);
  EXPECT_EQ(*std::max_element(squareness.begin(), squareness.end()), m.worst_squareness);
  EXPECT_EQ(*std::max_element(planarity.begin(), planarity.end()), m.worst_planarity);
  EXPECT_EQ(*std::max_element(twist.begin(), twist.end()), m.worst_twist);
  EXPECT_EQ(between, (std::vector<std::int32_t>{0, 1, 1, 2}));
}

TEST(AbiCertificate, IsNotEarnedWhereTheModeIsOff) {
  const Session session(capsule());
  add(session, plane("a", 3));
  EXPECT_EQ(api().set_parameter_text(session, "enclose.mode", "off"), CGW_OK);
  cgw_certificate c = CGW_CERTIFICATE_INIT;
  EXPECT_EQ(api().get_certificate(session, &c), CGW_ERROR_NOT_READY);
  cgw_measures m = CGW_MEASURES_INIT;
  EXPECT_EQ(api().get_measures(session, &m), CGW_ERROR_NOT_READY);
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK);
  cgw_summary summary = CGW_SUMMARY_INIT;
  ASSERT_EQ(api().get_summary(session, &summary), CGW_OK);
  EXPECT_EQ(summary.last_stage, CGW_STAGE_REFINE);
  EXPECT_EQ(summary.certified, 0u);
  ASSERT_EQ(api().get_certificate(session, &c), CGW_OK);
  EXPECT_EQ(c.closed, 1u);
  EXPECT_EQ(c.keeps_distance, 0u);
  const Cage cage = cage_of(session);
  EXPECT_EQ(c.encloses, Evaluation(capsule(), {cage.vertices, cage.triangles}).certificate().encloses);
}

TEST(AbiCertificate, KeepsTheDistanceThatIsAskedFor) {
  for (const double delta : {0.001, 0.01, 0.05}) {
    const Session session(capsule());
    add(session, plane("a", 2));
    add(session, plane("b", 5));
    EXPECT_EQ(api().set_parameter(session, "refine.delta", delta), CGW_OK);
    ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
    cgw_certificate c = CGW_CERTIFICATE_INIT;
    cgw_measures m = CGW_MEASURES_INIT;
    ASSERT_EQ(api().get_certificate(session, &c), CGW_OK);
    ASSERT_EQ(api().get_measures(session, &m), CGW_OK);
    EXPECT_EQ(c.encloses, 1u) << c.message;
    EXPECT_EQ(c.keeps_distance, 1u) << c.message;
    EXPECT_GE(m.clearance, delta);
    EXPECT_LE(m.clearance, 1.5 * delta);
  }
}

}  // namespace
