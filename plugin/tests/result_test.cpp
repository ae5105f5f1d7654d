// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

std::vector<std::string>& logged() {
  static std::vector<std::string> messages;
  return messages;
}

cgw_host logging() {
  logged().clear();
  cgw_host host = CGW_HOST_INIT;
  host.log = [](void*, std::int32_t level, const char* message) {
    logged().push_back(std::to_string(level) + " " + message);
  };
  return host;
}

// Each is refused with that status and a sentence that has `culprit` in it; the model before stays.
void expect_refused(const Mesh& mesh, cgw_status status, const std::string& culprit) {
  const Session session(tetrahedron());
  const cgw_mesh view = mesh.view();
  EXPECT_EQ(api().set_mesh(session, &view), status) << session.error();
  EXPECT_NE(session.error().find(culprit), std::string::npos) << session.error();
  EXPECT_EQ(session.error_info().code, status);
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  EXPECT_EQ(api().mesh_report(session, &report), CGW_OK);
  EXPECT_EQ(report.triangles, 4u);
}

TEST(AbiMesh, ThatIsNoModelIsRefusedAndTheCulpritNamed) {
  Mesh mesh = tetrahedron();
  mesh.triangles.clear();
  expect_refused(mesh, CGW_ERROR_MESH_EMPTY, "triangle");
  mesh = tetrahedron();
  mesh.vertices[7] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(mesh, CGW_ERROR_MESH_NOT_FINITE, "vertex 2");
  mesh = tetrahedron();
  mesh.triangles[5] = 4;
  expect_refused(mesh, CGW_ERROR_MESH_INDEX, "triangle 1 names vertex 4");
  mesh = capsule();
  mesh.triangles.resize(mesh.triangles.size() - 3);
  expect_refused(mesh, CGW_ERROR_MESH_OPEN, "3 open edges");
  mesh = tetrahedron();  // and a second one on the other side of an edge
  mesh.vertices.insert(mesh.vertices.end(), {0, -1, 0, 0, 0, -1});
  mesh.triangles.insert(mesh.triangles.end(), {0, 1, 5, 0, 4, 1, 1, 4, 5, 0, 5, 4});
  expect_refused(mesh, CGW_ERROR_MESH_NON_MANIFOLD, "1 ");
  const Mesh projective_plane = {
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3, 3, 1, 2},
      {0, 1, 4, 0, 1, 5, 0, 2, 3, 0, 2, 5, 0, 3, 4, 1, 2, 3, 1, 2, 4, 1, 3, 5, 2, 4, 5, 3, 4, 5}};
  expect_refused(projective_plane, CGW_ERROR_MESH_NOT_ORIENTABLE, "orient");
}

TEST(AbiMesh, IsInspectedWithoutBeingRefused) {
  Mesh mesh = capsule();
  mesh.triangles.resize(mesh.triangles.size() - 3);
  const cgw_mesh view = mesh.view();
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  ASSERT_EQ(api().inspect_mesh(&view, &report), CGW_OK);
  EXPECT_EQ(report.closed, 0u);
  EXPECT_EQ(report.open_edges, 3u);
  EXPECT_EQ(report.genus, -1);
  EXPECT_DOUBLE_EQ(report.box_min[0], -1);
  EXPECT_DOUBLE_EQ(report.box_max[0], 7);
  const Mesh ring = torus();
  const cgw_mesh ring_view = ring.view();
  ASSERT_EQ(api().inspect_mesh(&ring_view, &report), CGW_OK);
  EXPECT_EQ(report.closed, 1u);
  EXPECT_EQ(report.genus, 1);
}

TEST(AbiSolve, ThatFallsShortOfEquation9SaysWhereInTheLog) {
  const cgw_host host = logging();
  const SolvedCapsule capsule(&host);
  EXPECT_TRUE(logged().empty()) << testing::PrintToString(logged());
  ASSERT_EQ(api().set_parameter_text(capsule.session, "enclose.mode", "off"), CGW_OK);
  ASSERT_EQ(api().set_parameter(capsule.session, "refine.iterations", 0), CGW_OK);
  ASSERT_EQ(api().set_parameter(capsule.session, "refine.delta", 0.1), CGW_OK);
  ASSERT_EQ(api().solve(capsule.session, nullptr), CGW_OK);
  ASSERT_EQ(logged().size(), 1u);
  EXPECT_EQ(logged()[0].find("2 the refinement ended before the cage bounds the model as asked: the vertex near ("), 0u)
      << logged()[0];

  logged().clear();
  ASSERT_EQ(api().set_parameter(capsule.session, "refine.editing_iterations", 0), CGW_OK);
  cgw_solve_options editing = CGW_SOLVE_OPTIONS_INIT;
  editing.editing = 1;
  ASSERT_EQ(api().solve(capsule.session, &editing), CGW_OK);
  EXPECT_TRUE(logged().empty()) << "while the mouse moves nobody expects the end of the refinement";
}

TEST(AbiMesh, ThatHadToBeMendedIsLogged) {
  const cgw_host host = logging();
  const Session inside_out(&host, turned_inside_out(capsule()));
  ASSERT_EQ(logged().size(), 1u);
  EXPECT_EQ(logged()[0], "2 the model was inside out: 1,920 triangles turned");
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  ASSERT_EQ(api().mesh_report(inside_out, &report), CGW_OK);
  EXPECT_EQ(report.inside_out, 1u);
  EXPECT_EQ(report.turned_triangles, 1920u);
  EXPECT_LT(report.signed_volume, 0);

  logged().clear();
  Mesh mesh = tetrahedron();  // a second one that shares a corner, a vertex too many and a triangle without an area
  mesh.vertices.insert(mesh.vertices.end(), {-1, 0, 0, 0, -1, 0, 0, 0, -1, 9, 9, 9});
  mesh.triangles.insert(mesh.triangles.end(), {0, 4, 5, 0, 6, 4, 4, 6, 5, 0, 5, 6, 1, 1, 2});
  const Session bow_tie(&host, mesh);
  const auto has = [](const char* text) {
    for (const std::string& message : logged()) {
      if (message.find(text) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(has("1 vertex joins several fans")) << testing::PrintToString(logged());
  EXPECT_TRUE(has("1 triangle names a position twice"));
  EXPECT_TRUE(has("1 vertex is used by no triangle"));

  logged().clear();
  const Session sound(&host, capsule());
  EXPECT_TRUE(logged().empty()) << testing::PrintToString(logged());
}

TEST(AbiMesh, StaysAwayWhereTheHostsLogThrows) {
  cgw_host host = CGW_HOST_INIT;
  host.log = [](void*, std::int32_t, const char*) { throw 1; };
  const Session session(&host);
  const Mesh mesh = turned_inside_out(capsule());
  const cgw_mesh view = mesh.view();
  EXPECT_EQ(api().set_mesh(session, &view), CGW_ERROR_INTERNAL);
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  EXPECT_EQ(api().mesh_report(session, &report), CGW_ERROR_NOT_READY);
}

TEST(AbiResults, AreNotReadyBeforeASolveAndGoWithTheModel) {
  const auto expect_none = [](const Session& s) {
    cgw_parts parts = CGW_PARTS_INIT;
    cgw_section section = CGW_SECTION_INIT;
    cgw_loop loop = CGW_LOOP_INIT;
    cgw_cage cage = CGW_CAGE_INIT;
    cgw_iteration iteration = CGW_ITERATION_INIT;
    cgw_summary summary = CGW_SUMMARY_INIT;
    EXPECT_EQ(api().get_parts(s, &parts), CGW_ERROR_NOT_READY);
    EXPECT_EQ(api().get_section(s, 0, &section), CGW_ERROR_NOT_READY);
    EXPECT_EQ(api().get_loop(s, 0, &loop), CGW_ERROR_NOT_READY);
    EXPECT_EQ(api().get_iteration(s, 0, &iteration), CGW_ERROR_NOT_READY);
    EXPECT_EQ(api().get_summary(s, &summary), CGW_ERROR_NOT_READY);
    EXPECT_EQ(api().get_cage(s, &cage), CGW_ERROR_NOT_READY);
    EXPECT_NE(s.error().find("cage"), std::string::npos) << s.error();
    EXPECT_EQ(api().section_count(s), 0u);
    EXPECT_EQ(api().iteration_count(s), 0u);
  };
  const Session session(capsule());
  expect_none(session);
  const SolvedCapsule solved;
  const Mesh other = torus();
  const cgw_mesh view = other.view();
  ASSERT_EQ(api().set_mesh(solved.session, &view), CGW_OK);
  expect_none(solved.session);
}

TEST(AbiResults, PartsCoverTheCutModel) {
  const SolvedCapsule solved;
  cgw_parts parts = CGW_PARTS_INIT;
  ASSERT_EQ(api().get_parts(solved.session, &parts), CGW_OK);
  ASSERT_EQ(parts.part_count, 4u);
  std::vector<std::int32_t> triangle_part(parts.triangle_count, -1);
  std::vector<std::uint32_t> section_count(parts.part_count), triangles(3 * parts.triangle_count);
  parts.triangles = triangles.data();
  parts.triangle_part = triangle_part.data();
  parts.triangle_capacity = parts.triangle_count;
  parts.section_count = section_count.data();
  parts.part_capacity = parts.part_count;
  ASSERT_EQ(api().get_parts(solved.session, &parts), CGW_OK);
  EXPECT_EQ(std::set<std::int32_t>(triangle_part.begin(), triangle_part.end()), (std::set<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(std::multiset<std::uint32_t>(section_count.begin(), section_count.end()),
            (std::multiset<std::uint32_t>{1, 1, 2, 2}));
  for (const std::uint32_t vertex : triangles) ASSERT_LT(vertex, parts.vertex_count);
}

struct PartFigures {
  std::vector<std::uint32_t> sections, flags;
  std::vector<double> center;
};

PartFigures part_figures(const Session& session) {
  cgw_parts parts = CGW_PARTS_INIT;
  EXPECT_EQ(api().get_parts(session, &parts), CGW_OK) << session.error();
  const std::uint64_t count = parts.part_count;
  PartFigures figures{std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count, 99),
                      std::vector<double>(3 * count)};
  parts.section_count = figures.sections.data();
  parts.part_flags = figures.flags.data();
  parts.part_center = figures.center.data();
  parts.part_capacity = count - 1;
  EXPECT_EQ(api().get_parts(session, &parts), CGW_ERROR_BUFFER_TOO_SMALL);
  EXPECT_EQ(figures.flags, std::vector<std::uint32_t>(count, 99));
  parts.part_capacity = count;
  EXPECT_EQ(api().get_parts(session, &parts), CGW_OK) << session.error();
  return figures;
}

void solve_up_to(const Session& session, std::int32_t stage) {
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.last_stage = stage;
  ASSERT_EQ(api().solve(session, &options), CGW_OK) << session.error();
}

TEST(AbiResults, PartCentersSeeEveryTriangleOfTheirPartFromInside) {
  const SolvedCapsule solved;
  solve_up_to(solved.session, CGW_STAGE_ORIENT);
  for (const double x : part_figures(solved.session).center) EXPECT_TRUE(std::isnan(x));
  solve_up_to(solved.session, CGW_STAGE_MESHING);
  const PartFigures figures = part_figures(solved.session);
  EXPECT_EQ(figures.flags, std::vector<std::uint32_t>(4, 0));
  Cage cage = cage_of(solved.session);
  std::vector<std::int32_t> part(cage.triangles.size() / 3);
  cgw_cage view = CGW_CAGE_INIT;
  view.triangle_part = part.data();
  view.triangle_capacity = part.size();
  ASSERT_EQ(api().get_cage(solved.session, &view), CGW_OK);
  std::vector<int> behind(4), ahead(4);  // corners of the part on either side of its centre, along the capsule
  for (std::size_t t = 0; t < part.size(); ++t) {
    double edge[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        edge[i][c] = cage.vertices[3 * cage.triangles[3 * t + i] + c] -
                     figures.center[3 * static_cast<std::size_t>(part[t]) + c];
      }
    }
    for (const auto& corner : edge) ++(corner[0] < 0 ? behind : ahead)[static_cast<std::size_t>(part[t])];
    const auto& [a, b, c] = edge;
    EXPECT_GT(
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]), 0)
        << "triangle " << t;
  }
  for (std::size_t p = 0; p < 4; ++p) EXPECT_TRUE(behind[p] > 0 && ahead[p] > 0) << "it is the centre of another part";
}

// A tetrahedron of size 0.3 with its right angle at (x, y, 0) as a component of its own.
void add_tetrahedron(Mesh& mesh, double x, double y) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
  const Mesh small = tetrahedron();
  for (std::size_t k = 0; k < small.vertices.size(); ++k)
    mesh.vertices.push_back(0.3 * small.vertices[k] + (k % 3 == 0 ? x : k % 3 == 1 ? y : 0));
  for (const std::uint32_t vertex : small.triangles) mesh.triangles.push_back(first + vertex);
}

TEST(AbiResults, TellWhichPartIsEnclosedAndHasNoCage) {
  Mesh mesh = capsule();
  add_tetrahedron(mesh, 2, 0);   // inside
  add_tetrahedron(mesh, 2, 10);  // far outside
  const Session session(mesh);
  add(session, plane("a", 5.01));
  solve_up_to(session, CGW_STAGE_MESHING);
  const PartFigures figures = part_figures(session);
  ASSERT_EQ(figures.flags.size(), 4u);
  int leaves = 0, boxes = 0, enclosed = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double* center = &figures.center[3 * k];
    leaves += figures.sections[k] == 1 && figures.flags[k] == 0 && std::abs(center[1]) < 1;
    boxes += figures.sections[k] == 0 && figures.flags[k] == 0 && std::abs(center[1] - 10.15) < 1e-9;
    enclosed += figures.sections[k] == 0 && figures.flags[k] == CGW_PART_ENCLOSED && std::isnan(center[1]);
  }
  EXPECT_EQ(leaves, 2);
  EXPECT_EQ(boxes, 1);
  EXPECT_EQ(enclosed, 1);
}

TEST(AbiResults, SectionsAreRectanglesOfTheCage) {
  const SolvedCapsule solved;
  const Cage cage = cage_of(solved.session);
  ASSERT_EQ(api().section_count(solved.session), 3u);
  const std::uint64_t ids[] = {solved.left, solved.middle, solved.right};
  for (std::uint64_t k = 0; k < 3; ++k) {
    cgw_section section = CGW_SECTION_INIT;
    ASSERT_EQ(api().get_section(solved.session, k, &section), CGW_OK);
    EXPECT_EQ(section.slide, ids[k]);
    EXPECT_NE(section.part_ahead, section.part_behind);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(section.corners[3 * i + c], cage.vertices[3 * static_cast<std::size_t>(section.cage_vertex[i]) + c]);
      }
    }
    EXPECT_NEAR(section.p[0] * section.q[0] + section.p[1] * section.q[1] + section.p[2] * section.q[2], 0, 1e-9);
  }
}

double dot(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// What a host needs to judge equation (1) by itself: the frame that x is in.
TEST(AbiResults, SectionsSolveEquation1InTheirOwnFrame) {
  const Session session(capsule());
  for (const auto& [name, x, turn] : {std::tuple{"a", 1.0, 0.3}, {"b", 3.0, 0.9}, {"c", 5.0, -0.2}}) {
    cgw_slide_input input = ellipse(name, x, 1);
    const double u[] = {0, 1.5 * std::cos(turn), 1.5 * std::sin(turn)}, v[] = {0, -std::sin(turn), std::cos(turn)};
    std::copy_n(u, 3, input.u);
    std::copy_n(v, 3, input.v);
    add(session, input);
  }
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  for (std::uint64_t k = 0; k < 3; ++k) {
    cgw_section section = CGW_SECTION_INIT;
    ASSERT_EQ(api().get_section(session, k, &section), CGW_OK);
    const double lu = std::sqrt(dot(section.u, section.u)), lv = std::sqrt(dot(section.v, section.v));
    EXPECT_NEAR(lu, 1.5, 1e-9);
    EXPECT_NEAR(lv, 1, 1e-9);
    const double four_angles = 4 * std::atan2(dot(section.p, section.v) / lv, dot(section.p, section.u) / lu);
    const double length = std::hypot(section.x[0], section.x[1]);
    EXPECT_GT(std::abs(section.x[1]), 1e-3 * length) << "a frame that tells something";
    EXPECT_NEAR(std::cos(four_angles), section.x[0] / length, 1e-9);
    EXPECT_NEAR(std::sin(four_angles), section.x[1] / length, 1e-9);
    EXPECT_LT(length, 1) << "slides that do not agree";
    EXPECT_EQ(section.x[0], section.linear_x[0]);
    EXPECT_EQ(section.x[1], section.linear_x[1]);
  }
  ASSERT_EQ(api().set_parameter_text(session, "orient.minimum", "angles"), CGW_OK);
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  for (std::uint64_t k = 0; k < 3; ++k) {
    cgw_section section = CGW_SECTION_INIT;
    ASSERT_EQ(api().get_section(session, k, &section), CGW_OK);
    EXPECT_NEAR(std::hypot(section.x[0], section.x[1]), 1, 1e-12);
    EXPECT_GT(section.x[0] * section.linear_x[0] + section.x[1] * section.linear_x[1], 0) << "x starts from there";
  }
}

TEST(AbiResults, SectionsKeepTheEllipseOfTheirSolve) {
  const Session session(capsule());
  const std::uint64_t id = add(session, ellipse("a", 3, 1));
  solve_up_to(session, CGW_STAGE_SEGMENT);
  const cgw_slide_info solved = info(session, 0);
  const cgw_slide_input moved = plane("a", 5, 1, 0.2);
  ASSERT_EQ(api().slide_change(session, id, &moved), CGW_OK);
  cgw_section section = CGW_SECTION_INIT;
  ASSERT_EQ(api().get_section(session, 0, &section), CGW_OK);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(section.center[c], solved.center[c]);
    EXPECT_EQ(section.normal[c], solved.normal[c]);
    EXPECT_EQ(section.u[c], solved.u[c]);
    EXPECT_EQ(section.v[c], solved.v[c]);
    EXPECT_EQ(section.p[c], 0);
  }
  EXPECT_NEAR(dot(section.normal, section.normal), 1, 1e-12);
  EXPECT_NEAR(std::sqrt(dot(section.u, section.u)), 1.2, 1e-12);
}

TEST(AbiResults, LoopsLieInTheirSlidesPlane) {
  const SolvedCapsule solved;
  cgw_loop loop = CGW_LOOP_INIT;
  ASSERT_EQ(api().get_loop(solved.session, 1, &loop), CGW_OK);
  std::vector<double> points(3 * loop.point_count);
  loop.points = points.data();
  loop.point_capacity = loop.point_count;
  ASSERT_EQ(api().get_loop(solved.session, 1, &loop), CGW_OK);
  ASSERT_GE(loop.point_count, 24u);
  for (std::size_t k = 0; k < points.size(); k += 3) {
    EXPECT_NEAR(points[k], 3.02, 1e-9);
    EXPECT_NEAR(std::hypot(points[k + 1], points[k + 2]), 1, 0.02);
  }
}

TEST(AbiResults, KeepTheSlidesOfTheirSolve) {
  const SolvedCapsule solved;
  ASSERT_EQ(api().slide_remove(solved.session, solved.left), CGW_OK);
  EXPECT_EQ(api().section_count(solved.session), 3u);
  cgw_section section = CGW_SECTION_INIT;
  ASSERT_EQ(api().get_section(solved.session, 0, &section), CGW_OK);
  EXPECT_EQ(section.slide, solved.left);
}

TEST(AbiResults, BeforeTheirStageAreNotMadeUp) {
  const Session session(capsule());
  add(session, plane("a", 3.01));
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.last_stage = CGW_STAGE_SEGMENT;
  ASSERT_EQ(api().solve(session, &options), CGW_OK);
  cgw_section section = CGW_SECTION_INIT;
  ASSERT_EQ(api().get_section(session, 0, &section), CGW_OK);
  EXPECT_NE(section.part_ahead, section.part_behind);
  EXPECT_EQ(section.cage_vertex[0], -1);
  cgw_summary summary = CGW_SUMMARY_INIT;
  ASSERT_EQ(api().get_summary(session, &summary), CGW_OK);
  EXPECT_TRUE(std::isnan(summary.volume_ratio));
  EXPECT_TRUE(std::isnan(summary.max_signed_distance_over_diagonal));
  EXPECT_TRUE(std::isnan(summary.extent));
  EXPECT_TRUE(std::isnan(summary.orient_ms));
  EXPECT_FALSE(std::isnan(summary.segment_ms));
  EXPECT_EQ(summary.cage_genus, -1);
}

TEST(AbiResults, WriteNoArrayWhereOneIsTooSmallButSetTheCounts) {
  const SolvedCapsule solved;
  std::vector<double> vertices(60, -7);
  std::vector<std::uint32_t> triangles(3, 7);
  cgw_cage cage = CGW_CAGE_INIT;
  cage.vertices = vertices.data();
  cage.vertex_capacity = 20;
  cage.triangles = triangles.data();
  cage.triangle_capacity = 1;
  EXPECT_EQ(api().get_cage(solved.session, &cage), CGW_ERROR_BUFFER_TOO_SMALL);
  EXPECT_NE(solved.session.error().find("triangles has room for 1 rows"), std::string::npos) << solved.session.error();
  EXPECT_EQ(cage.vertex_count, 20u);
  EXPECT_EQ(cage.triangle_count, 36u);
  EXPECT_EQ(vertices, std::vector<double>(60, -7));
  EXPECT_EQ(triangles, std::vector<std::uint32_t>(3, 7));
}

TEST(AbiResults, LetTheHostJudgeEquation9) {
  const SolvedCapsule solved;
  ASSERT_EQ(api().set_parameter_text(solved.session, "enclose.mode", "off"), CGW_OK);
  const Session& s = solved.session;
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  ASSERT_EQ(api().mesh_report(s, &report), CGW_OK);
  std::set<std::uint32_t> seen;
  for (const double iterations : {0.0, 1.0, 30.0}) {
    ASSERT_EQ(api().set_parameter(s, "refine.iterations", iterations), CGW_OK);
    ASSERT_EQ(api().set_parameter(s, "refine.delta", 0.01), CGW_OK);
    ASSERT_EQ(api().solve(s, nullptr), CGW_OK) << s.error();
    cgw_summary summary = CGW_SUMMARY_INIT;
    ASSERT_EQ(api().get_summary(s, &summary), CGW_OK);
    EXPECT_NEAR(summary.extent, 8, 1e-9) << "from pole to pole";
    EXPECT_LE(summary.extent, report.diagonal);
    const double missing = std::abs(-summary.max_signed_distance_over_diagonal - 0.01) * report.diagonal;
    EXPECT_EQ(summary.converged, missing <= 0.001 * summary.extent ? 1u : 0u) << missing;
    seen.insert(summary.converged);
    for (std::uint64_t k = 0; k < api().iteration_count(s); ++k) {
      cgw_iteration iteration = CGW_ITERATION_INIT;
      ASSERT_EQ(api().get_iteration(s, k, &iteration), CGW_OK);
      EXPECT_GT(std::abs(-iteration.max_signed_distance - 0.01 * report.diagonal), 0.001 * summary.extent)
          << "step " << k << " was needed";
    }
  }
  EXPECT_EQ(seen.size(), 2u);
}

TEST(AbiResults, IterationsFollowEachOther) {
  const SolvedCapsule solved;
  const Session& s = solved.session;
  ASSERT_EQ(api().set_parameter(s, "refine.delta", 0.02), CGW_OK);
  ASSERT_EQ(api().set_parameter_text(s, "enclose.mode", "off"), CGW_OK);
  ASSERT_EQ(api().solve(s, nullptr), CGW_OK);
  const std::uint64_t count = api().iteration_count(s);
  ASSERT_GT(count, 1u);
  std::vector<double> before(60), after(60), previous;
  for (std::uint64_t k = 0; k < count; ++k) {
    cgw_iteration iteration = CGW_ITERATION_INIT;
    iteration.vertices_before = before.data();
    iteration.vertices_after = after.data();
    iteration.vertex_capacity = 20;
    ASSERT_EQ(api().get_iteration(s, k, &iteration), CGW_OK) << s.error();
    EXPECT_EQ(iteration.triangle_count, 36u);
    if (k > 0) {
      EXPECT_EQ(before, previous);
    }
    previous = after;
  }
  EXPECT_EQ(previous, cage_of(s).vertices);
  cgw_iteration past = CGW_ITERATION_INIT;
  EXPECT_EQ(api().get_iteration(s, count, &past), CGW_ERROR_INVALID_ARGUMENT);
}

}  // namespace
