// SPDX-License-Identifier: BSD-3-Clause
//
// What was released must not move: the numbers, and the layout of every struct of ABI 1.5 on 64-bit machines.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <regex>
#include <string>

#include "plugin/tests/loaded_plugin.h"

namespace {

using cagewright::plugin::test::api;

static_assert(CGW_ABI_MAJOR == 1 && CGW_ABI_MINOR == 5);
static_assert(CGW_OK == 0 && CGW_CANCELLED == 1 && CGW_SLIDE_UNSOLVED == 2);
static_assert(CGW_ERROR_INTERNAL == -1 && CGW_ERROR_INVALID_ARGUMENT == -2 && CGW_ERROR_OUT_OF_MEMORY == -3);
static_assert(CGW_ERROR_BUFFER_TOO_SMALL == -4 && CGW_ERROR_NOT_READY == -5 && CGW_ERROR_UNKNOWN_SLIDE == -6);
static_assert(CGW_ERROR_UNKNOWN_PARAMETER == -7 && CGW_ERROR_PARAMETER_OUT_OF_RANGE == -8 && CGW_ERROR_STREAM == -9);
static_assert(CGW_ERROR_MESH_EMPTY == -20 && CGW_ERROR_MESH_NOT_FINITE == -21 && CGW_ERROR_MESH_INDEX == -22);
static_assert(CGW_ERROR_MESH_OPEN == -23 && CGW_ERROR_MESH_NON_MANIFOLD == -24 && CGW_ERROR_MESH_NOT_ORIENTABLE == -25);
static_assert(CGW_ERROR_STROKE_TOO_SHORT == -40 && CGW_ERROR_STROKE_COLLINEAR == -41);
static_assert(CGW_ERROR_STROKE_NO_ELLIPSE == -42 && CGW_ERROR_SLIDE_NOT_FINITE == -43);
static_assert(CGW_ERROR_SLIDE_DEGENERATE == -44 && CGW_ERROR_SLIDE_MISSES_MODEL == -45);
static_assert(CGW_ERROR_SLIDE_NOT_ENCLOSED == -46 && CGW_ERROR_SLIDE_NAME == -47);
static_assert(CGW_ERROR_SLIDES_TOUCH == -60 && CGW_ERROR_PART_SEES_SLIDE_TWICE == -61);
static_assert(CGW_ERROR_SECTIONS_OVERLAP == -62 && CGW_ERROR_PARTS_SHARE_WALL == -63 &&
              CGW_ERROR_REFINE_DIVERGED == -64);
static_assert(CGW_ERROR_STATE_MAGIC == -80 && CGW_ERROR_STATE_VERSION == -81 && CGW_ERROR_STATE_CORRUPT == -82);
static_assert(CGW_ERROR_STATE_FINGERPRINT == -83);
static_assert(CGW_LOG_DEBUG == 0 && CGW_LOG_INFO == 1 && CGW_LOG_WARNING == 2 && CGW_LOG_ERROR == 3);
static_assert(CGW_PARAM_REAL == 0 && CGW_PARAM_INTEGER == 1 && CGW_PARAM_BOOLEAN == 2 && CGW_PARAM_CHOICE == 3);
static_assert(CGW_SLIDE_STROKE == 0 && CGW_SLIDE_POINT_NORMAL == 1 && CGW_SLIDE_ELLIPSE == 2);
static_assert(CGW_SLIDE_POINT == 3);
static_assert(CGW_PART_ENCLOSED == 1);
static_assert(CGW_STAGE_SEGMENT == 1 && CGW_STAGE_ORIENT == 2 && CGW_STAGE_MESHING == 3 && CGW_STAGE_REFINE == 4);
static_assert(CGW_STAGE_ENCLOSE == 5);
static_assert(CGW_EDITING_NONE == 0 && CGW_EDITING_ENCLOSE == 1 && CGW_EDITING_REFINE == 2);

// A later minor version may add at the end: sizes may grow past these, offsets may not change.
#define AT(type, field, offset) static_assert(offsetof(type, field) == (offset))
#define SIZE(type, size) static_assert(sizeof(type) == (size) && offsetof(type, struct_size) == 0)

SIZE(cgw_error_info, 72);
AT(cgw_error_info, code, 4);
AT(cgw_error_info, slide, 8);
AT(cgw_error_info, other_slide, 16);
AT(cgw_error_info, part, 24);
AT(cgw_error_info, element, 32);
AT(cgw_error_info, has_point, 40);
AT(cgw_error_info, reserved, 44);
AT(cgw_error_info, point, 48);
SIZE(cgw_host, 40);
AT(cgw_host, reserved, 4);
AT(cgw_host, user, 8);
AT(cgw_host, log, 16);
AT(cgw_host, progress, 24);
AT(cgw_host, get_extension, 32);
SIZE(cgw_parameter, 80);
AT(cgw_parameter, type, 4);
AT(cgw_parameter, id, 8);
AT(cgw_parameter, label, 16);
AT(cgw_parameter, doc, 24);
AT(cgw_parameter, unit, 32);
AT(cgw_parameter, default_value, 40);
AT(cgw_parameter, minimum, 48);
AT(cgw_parameter, maximum, 56);
AT(cgw_parameter, choices, 64);
AT(cgw_parameter, choice_count, 72);
AT(cgw_parameter, reserved, 76);
SIZE(cgw_mesh, 40);
AT(cgw_mesh, reserved, 4);
AT(cgw_mesh, vertices, 8);
AT(cgw_mesh, vertex_count, 16);
AT(cgw_mesh, triangles, 24);
AT(cgw_mesh, triangle_count, 32);
SIZE(cgw_mesh_report, 176);
AT(cgw_mesh_report, closed, 4);
AT(cgw_mesh_report, consistently_oriented, 8);
AT(cgw_mesh_report, inside_out, 12);
AT(cgw_mesh_report, vertices, 16);
AT(cgw_mesh_report, triangles, 24);
AT(cgw_mesh_report, welded_vertices, 32);
AT(cgw_mesh_report, degenerate_triangles, 40);
AT(cgw_mesh_report, unused_vertices, 48);
AT(cgw_mesh_report, open_edges, 56);
AT(cgw_mesh_report, non_manifold_edges, 64);
AT(cgw_mesh_report, inconsistent_edges, 72);
AT(cgw_mesh_report, bow_tie_vertices, 80);
AT(cgw_mesh_report, turned_triangles, 88);
AT(cgw_mesh_report, components, 96);
AT(cgw_mesh_report, genus, 104);
AT(cgw_mesh_report, signed_volume, 112);
AT(cgw_mesh_report, diagonal, 120);
AT(cgw_mesh_report, box_min, 128);
AT(cgw_mesh_report, box_max, 152);
SIZE(cgw_slide_input, 128);
AT(cgw_slide_input, kind, 4);
AT(cgw_slide_input, name, 8);
AT(cgw_slide_input, stroke, 16);
AT(cgw_slide_input, stroke_count, 24);
AT(cgw_slide_input, point, 32);
AT(cgw_slide_input, normal, 56);
AT(cgw_slide_input, u, 80);
AT(cgw_slide_input, v, 104);
SIZE(cgw_slide_info, 136);
AT(cgw_slide_info, kind, 4);
AT(cgw_slide_info, id, 8);
AT(cgw_slide_info, name, 16);
AT(cgw_slide_info, status, 24);
AT(cgw_slide_info, has_ellipse, 28);
AT(cgw_slide_info, message, 32);
AT(cgw_slide_info, center, 40);
AT(cgw_slide_info, normal, 64);
AT(cgw_slide_info, u, 88);
AT(cgw_slide_info, v, 112);
SIZE(cgw_solve_options, 16);
AT(cgw_solve_options, last_stage, 4);
AT(cgw_solve_options, editing, 8);
AT(cgw_solve_options, threads, 12);
SIZE(cgw_parts, 104);
AT(cgw_parts, reserved, 4);
AT(cgw_parts, part_count, 8);
AT(cgw_parts, vertex_count, 16);
AT(cgw_parts, triangle_count, 24);
AT(cgw_parts, vertices, 32);
AT(cgw_parts, vertex_capacity, 40);
AT(cgw_parts, triangles, 48);
AT(cgw_parts, triangle_part, 56);
AT(cgw_parts, triangle_capacity, 64);
AT(cgw_parts, section_count, 72);
AT(cgw_parts, part_capacity, 80);
AT(cgw_parts, part_flags, 88);
AT(cgw_parts, part_center, 96);
SIZE(cgw_loop, 32);
AT(cgw_loop, reserved, 4);
AT(cgw_loop, point_count, 8);
AT(cgw_loop, points, 16);
AT(cgw_loop, point_capacity, 24);
SIZE(cgw_section, 312);
AT(cgw_section, reserved, 4);
AT(cgw_section, slide, 8);
AT(cgw_section, part_behind, 16);
AT(cgw_section, part_ahead, 20);
AT(cgw_section, center, 24);
AT(cgw_section, p, 48);
AT(cgw_section, q, 72);
AT(cgw_section, x, 96);
AT(cgw_section, corners, 112);
AT(cgw_section, cage_vertex, 208);
AT(cgw_section, normal, 224);
AT(cgw_section, u, 248);
AT(cgw_section, v, 272);
AT(cgw_section, linear_x, 296);
SIZE(cgw_cage, 72);
AT(cgw_cage, reserved, 4);
AT(cgw_cage, vertex_count, 8);
AT(cgw_cage, triangle_count, 16);
AT(cgw_cage, vertices, 24);
AT(cgw_cage, vertex_section, 32);
AT(cgw_cage, vertex_capacity, 40);
AT(cgw_cage, triangles, 48);
AT(cgw_cage, triangle_part, 56);
AT(cgw_cage, triangle_capacity, 64);
SIZE(cgw_iteration, 120);
AT(cgw_iteration, reserved, 4);
AT(cgw_iteration, max_signed_distance, 8);
AT(cgw_iteration, vertex_count, 16);
AT(cgw_iteration, triangle_count, 24);
AT(cgw_iteration, vertices_before, 32);
AT(cgw_iteration, vertices_after, 40);
AT(cgw_iteration, damping, 48);
AT(cgw_iteration, plane_normal, 56);
AT(cgw_iteration, vertex_capacity, 64);
AT(cgw_iteration, normals, 72);
AT(cgw_iteration, anchors, 80);
AT(cgw_iteration, weights, 88);
AT(cgw_iteration, signed_distance, 96);
AT(cgw_iteration, outermost, 104);
AT(cgw_iteration, triangle_capacity, 112);
SIZE(cgw_summary, 104);
AT(cgw_summary, last_stage, 4);
AT(cgw_summary, iterations, 8);
AT(cgw_summary, converged, 16);
AT(cgw_summary, threads, 20);
AT(cgw_summary, max_signed_distance_over_diagonal, 24);
AT(cgw_summary, volume_ratio, 32);
AT(cgw_summary, cage_genus, 40);
AT(cgw_summary, segment_ms, 48);
AT(cgw_summary, orient_ms, 56);
AT(cgw_summary, meshing_ms, 64);
AT(cgw_summary, refine_ms, 72);
AT(cgw_summary, extent, 80);
AT(cgw_summary, enclose_ms, 88);
AT(cgw_summary, certified, 96);
AT(cgw_summary, merged, 100);
SIZE(cgw_certificate, 128);
AT(cgw_certificate, encloses, 4);
AT(cgw_certificate, closed, 8);
AT(cgw_certificate, keeps_distance, 12);
AT(cgw_certificate, degenerate_count, 16);
AT(cgw_certificate, self_intersection_count, 24);
AT(cgw_certificate, model_intersection_count, 32);
AT(cgw_certificate, outside_count, 40);
AT(cgw_certificate, degenerate_triangles, 48);
AT(cgw_certificate, degenerate_capacity, 56);
AT(cgw_certificate, self_intersections, 64);
AT(cgw_certificate, self_intersection_capacity, 72);
AT(cgw_certificate, model_intersections, 80);
AT(cgw_certificate, model_intersection_capacity, 88);
AT(cgw_certificate, outside_vertices, 96);
AT(cgw_certificate, outside_capacity, 104);
AT(cgw_certificate, message, 112);
AT(cgw_certificate, finding_count, 120);
SIZE(cgw_finding, 72);
AT(cgw_finding, has_point, 4);
AT(cgw_finding, point, 8);
AT(cgw_finding, message, 32);
AT(cgw_finding, slide_count, 40);
AT(cgw_finding, slides, 48);
AT(cgw_finding, slide_capacity, 56);
AT(cgw_finding, is_advice, 64);
SIZE(cgw_measures, 176);
AT(cgw_measures, reserved, 4);
AT(cgw_measures, volume_ratio, 8);
AT(cgw_measures, mean_gap, 16);
AT(cgw_measures, max_gap, 24);
AT(cgw_measures, coverage, 32);
AT(cgw_measures, clearance, 40);
AT(cgw_measures, least_dihedral, 48);
AT(cgw_measures, greatest_dihedral, 56);
AT(cgw_measures, greatest_aspect, 64);
AT(cgw_measures, mean_asymmetry, 72);
AT(cgw_measures, max_asymmetry, 80);
AT(cgw_measures, worst_squareness, 88);
AT(cgw_measures, worst_planarity, 96);
AT(cgw_measures, worst_twist, 104);
AT(cgw_measures, section_count, 112);
AT(cgw_measures, twist_count, 120);
AT(cgw_measures, squareness, 128);
AT(cgw_measures, planarity, 136);
AT(cgw_measures, section_capacity, 144);
AT(cgw_measures, twist, 152);
AT(cgw_measures, twist_between, 160);
AT(cgw_measures, twist_capacity, 168);
SIZE(cgw_stream, 32);
AT(cgw_stream, reserved, 4);
AT(cgw_stream, user, 8);
AT(cgw_stream, read, 16);
AT(cgw_stream, write, 24);
SIZE(cgw_api, 320);
AT(cgw_api, abi_major, 4);
AT(cgw_api, abi_minor, 8);
AT(cgw_api, parameter_count, 12);
AT(cgw_api, version, 16);
AT(cgw_api, status_name, 24);
AT(cgw_api, stage_name, 32);
AT(cgw_api, parameter_info, 40);
AT(cgw_api, inspect_mesh, 48);
AT(cgw_api, session_create, 56);
AT(cgw_api, session_destroy, 64);
AT(cgw_api, last_error, 72);
AT(cgw_api, last_error_info, 80);
AT(cgw_api, set_mesh, 88);
AT(cgw_api, mesh_report, 96);
AT(cgw_api, set_parameter, 104);
AT(cgw_api, set_parameter_text, 112);
AT(cgw_api, get_parameter, 120);
AT(cgw_api, slide_add, 128);
AT(cgw_api, slide_change, 136);
AT(cgw_api, slide_remove, 144);
AT(cgw_api, slide_count, 152);
AT(cgw_api, slide_info, 160);
AT(cgw_api, solve, 168);
AT(cgw_api, get_parts, 176);
AT(cgw_api, section_count, 184);
AT(cgw_api, get_section, 192);
AT(cgw_api, get_loop, 200);
AT(cgw_api, get_cage, 208);
AT(cgw_api, iteration_count, 216);
AT(cgw_api, get_iteration, 224);
AT(cgw_api, get_summary, 232);
AT(cgw_api, save_state, 240);
AT(cgw_api, load_state, 248);
AT(cgw_api, get_certificate, 256);
AT(cgw_api, get_measures, 264);
AT(cgw_api, evaluation_create, 272);
AT(cgw_api, evaluation_destroy, 280);
AT(cgw_api, evaluation_certificate, 288);
AT(cgw_api, evaluation_measures, 296);
AT(cgw_api, slide_fit, 304);
AT(cgw_api, get_finding, 312);

TEST(AbiTable, TellsItsSizeAndVersion) {
  EXPECT_EQ(api().struct_size, sizeof(cgw_api));
  EXPECT_EQ(api().abi_major, 1u);
  EXPECT_EQ(api().abi_minor, 5u);
  EXPECT_STREQ(api().version, CAGEWRIGHT_VERSION);
}

TEST(AbiTable, HasEveryFunction) {
  for (std::size_t at = offsetof(cgw_api, status_name); at < sizeof(cgw_api); at += sizeof(void*)) {
    void* function = nullptr;
    std::memcpy(&function, reinterpret_cast<const char*>(&api()) + at, sizeof function);
    EXPECT_NE(function, nullptr) << "at offset " << at;
  }
}

// What the _INIT macros leave out is 0, which is no default for these.
TEST(AbiStructs, BeginWithDefaultsToTheirEnd) {
  const cgw_parts parts = CGW_PARTS_INIT;
  EXPECT_EQ(parts.part_flags, nullptr);
  EXPECT_EQ(parts.part_center, nullptr);
  const cgw_section section = CGW_SECTION_INIT;
  EXPECT_EQ(section.part_ahead, -1);
  EXPECT_EQ(section.cage_vertex[3], -1);
  EXPECT_EQ(section.v[2], 0);
  EXPECT_EQ(section.linear_x[1], 0);
  const cgw_summary summary = CGW_SUMMARY_INIT;
  EXPECT_EQ(summary.cage_genus, -1);
  EXPECT_EQ(summary.extent, 0);
}

TEST(AbiTable, NamesEveryErrorOfTheHeaderAsTheHeaderDoes) {
  std::ifstream file(CAGEWRIGHT_ROOT "/plugin/include/cagewright/cagewright.h");
  const std::regex definition("#define CGW_ERROR_([A-Z_]+) \\((-[0-9]+)\\).*");
  int seen = 0;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (!std::regex_match(line, match, definition)) continue;
    std::string name = match[1];
    for (char& c : name) c = c == '_' ? c : static_cast<char>(c - 'A' + 'a');
    EXPECT_EQ(api().status_name(std::stoi(match[2])), name);
    ++seen;
  }
  EXPECT_EQ(seen, 32);
}

TEST(AbiTable, NamesStatusesAndStages) {
  EXPECT_STREQ(api().status_name(CGW_OK), "ok");
  EXPECT_STREQ(api().status_name(CGW_CANCELLED), "cancelled");
  EXPECT_STREQ(api().status_name(CGW_SLIDE_UNSOLVED), "unsolved");
  EXPECT_STREQ(api().status_name(-1000), "unknown");
  EXPECT_STREQ(api().status_name(3), "unknown");
  EXPECT_STREQ(api().stage_name(CGW_STAGE_SEGMENT), "segment");
  EXPECT_STREQ(api().stage_name(CGW_STAGE_REFINE), "refine");
  EXPECT_STREQ(api().stage_name(0), "unknown");
  EXPECT_STREQ(api().stage_name(CGW_STAGE_ENCLOSE), "enclose");
  EXPECT_STREQ(api().stage_name(6), "unknown");
}

}  // namespace
