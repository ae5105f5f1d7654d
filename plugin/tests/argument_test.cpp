// SPDX-License-Identifier: BSD-3-Clause
//
// NULL pointers, and structs that are shorter or longer than the plug-in's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

#define EXPECT_REFUSED(call) EXPECT_EQ(call, CGW_ERROR_INVALID_ARGUMENT)

TEST(AbiNull, SessionIsRefusedByEveryFunction) {
  const cgw_api& a = api();
  const Mesh mesh = capsule();
  const cgw_mesh view = mesh.view();
  const cgw_slide_input input = plane("a", 1);
  const cgw_stream stream = CGW_STREAM_INIT;
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  cgw_slide_info slide = CGW_SLIDE_INFO_INIT;
  cgw_finding finding = CGW_FINDING_INIT;
  cgw_parts parts = CGW_PARTS_INIT;
  cgw_section section = CGW_SECTION_INIT;
  cgw_loop loop = CGW_LOOP_INIT;
  cgw_cage cage = CGW_CAGE_INIT;
  cgw_iteration iteration = CGW_ITERATION_INIT;
  cgw_summary summary = CGW_SUMMARY_INIT;
  double value = 0;
  std::uint64_t id = 0;
  EXPECT_REFUSED(a.set_mesh(nullptr, &view));
  EXPECT_REFUSED(a.mesh_report(nullptr, &report));
  EXPECT_REFUSED(a.set_parameter(nullptr, "orient.lambda", 1));
  EXPECT_REFUSED(a.set_parameter_text(nullptr, "orient.lambda", "1"));
  EXPECT_REFUSED(a.get_parameter(nullptr, "orient.lambda", &value));
  EXPECT_REFUSED(a.slide_add(nullptr, &input, &id));
  EXPECT_REFUSED(a.slide_change(nullptr, 1, &input));
  EXPECT_REFUSED(a.slide_remove(nullptr, 1));
  EXPECT_REFUSED(a.slide_info(nullptr, 0, &slide));
  EXPECT_REFUSED(a.slide_fit(nullptr, &input, &slide));
  EXPECT_REFUSED(a.get_finding(nullptr, 0, &finding));
  EXPECT_REFUSED(a.solve(nullptr, nullptr));
  EXPECT_REFUSED(a.get_parts(nullptr, &parts));
  EXPECT_REFUSED(a.get_section(nullptr, 0, &section));
  EXPECT_REFUSED(a.get_loop(nullptr, 0, &loop));
  EXPECT_REFUSED(a.get_cage(nullptr, &cage));
  EXPECT_REFUSED(a.get_iteration(nullptr, 0, &iteration));
  EXPECT_REFUSED(a.get_summary(nullptr, &summary));
  EXPECT_REFUSED(a.save_state(nullptr, &stream));
  EXPECT_REFUSED(a.load_state(nullptr, &stream));
  EXPECT_EQ(a.slide_count(nullptr), 0u);
  EXPECT_EQ(a.section_count(nullptr), 0u);
  EXPECT_EQ(a.iteration_count(nullptr), 0u);
  a.session_destroy(nullptr);
  EXPECT_NE(std::string(a.last_error(nullptr)).find("session is NULL"), std::string::npos);
}

TEST(AbiNull, ArgumentIsRefusedByEveryFunctionAndNamed) {
  const cgw_api& a = api();
  const SolvedCapsule solved;
  const Session& s = solved.session;
  const Mesh mesh = capsule();
  const cgw_mesh view = mesh.view();
  const cgw_slide_input input = plane("a", 1);
  cgw_slide_info slide = CGW_SLIDE_INFO_INIT;
  cgw_finding finding = CGW_FINDING_INIT;
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  std::uint64_t id = 0;
  double value = 0;
  const cgw_stream without_functions = CGW_STREAM_INIT;
  EXPECT_REFUSED(a.parameter_info(0, nullptr));
  EXPECT_REFUSED(a.inspect_mesh(nullptr, &report));
  EXPECT_REFUSED(a.inspect_mesh(&view, nullptr));
  EXPECT_REFUSED(a.session_create(nullptr, nullptr));
  EXPECT_REFUSED(a.last_error_info(nullptr, nullptr));
  EXPECT_REFUSED(a.last_error_info(s, nullptr));
  EXPECT_REFUSED(a.set_mesh(s, nullptr));
  EXPECT_REFUSED(a.mesh_report(s, nullptr));
  EXPECT_REFUSED(a.set_parameter(s, nullptr, 1));
  EXPECT_REFUSED(a.set_parameter_text(s, nullptr, "1"));
  EXPECT_REFUSED(a.set_parameter_text(s, "orient.lambda", nullptr));
  EXPECT_REFUSED(a.get_parameter(s, nullptr, &value));
  EXPECT_REFUSED(a.get_parameter(s, "orient.lambda", nullptr));
  EXPECT_REFUSED(a.slide_add(s, nullptr, &id));
  EXPECT_REFUSED(a.slide_add(s, &input, nullptr));
  EXPECT_REFUSED(a.slide_change(s, solved.left, nullptr));
  EXPECT_REFUSED(a.slide_info(s, 0, nullptr));
  EXPECT_REFUSED(a.slide_fit(s, nullptr, &slide));
  EXPECT_REFUSED(a.slide_fit(s, &input, nullptr));
  EXPECT_REFUSED(a.get_finding(s, 0, nullptr));
  EXPECT_REFUSED(a.get_finding(s, 0, &finding)) << "there is none";
  EXPECT_REFUSED(a.get_parts(s, nullptr));
  EXPECT_REFUSED(a.get_section(s, 0, nullptr));
  EXPECT_REFUSED(a.get_loop(s, 0, nullptr));
  EXPECT_REFUSED(a.get_cage(s, nullptr));
  EXPECT_NE(s.error().find("cgw_cage is NULL"), std::string::npos) << s.error();
  EXPECT_REFUSED(a.get_iteration(s, 0, nullptr));
  EXPECT_REFUSED(a.get_summary(s, nullptr));
  EXPECT_REFUSED(a.save_state(s, nullptr));
  EXPECT_REFUSED(a.load_state(s, nullptr));
  EXPECT_REFUSED(a.save_state(s, &without_functions));
  EXPECT_REFUSED(a.load_state(s, &without_functions));
  EXPECT_EQ(a.slide_count(s), 3u);
}

TEST(AbiNull, BuffersInsideStructsAreRefused) {
  const Session session(capsule());
  cgw_mesh mesh = CGW_MESH_INIT;
  mesh.vertex_count = 3;
  EXPECT_REFUSED(api().set_mesh(session, &mesh));
  EXPECT_NE(session.error().find("vertices"), std::string::npos) << session.error();
  const double points[9] = {};
  mesh.vertices = points;
  mesh.triangle_count = 1;
  EXPECT_REFUSED(api().set_mesh(session, &mesh));
  EXPECT_NE(session.error().find("triangles"), std::string::npos) << session.error();
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  std::uint64_t id = 0;
  EXPECT_REFUSED(api().slide_add(session, &input, &id));
  EXPECT_NE(session.error().find("name"), std::string::npos) << session.error();
  input.name = "wrist";
  input.stroke_count = 12;
  EXPECT_REFUSED(api().slide_add(session, &input, &id));
  EXPECT_NE(session.error().find("stroke"), std::string::npos) << session.error();
}

// Calls with every struct_size that ends between two fields, and with a longer one, as a newer host's would be: bytes
// past struct_size, and past what this version knows, stay as they were; bytes before are those of the full call.
template <class T, class Call>
void expect_only_common_bytes_written(const T& init, Call call) {
  struct Guarded {
    T value;
    std::array<unsigned char, 64> guard;
  };
  T whole = init;
  ASSERT_EQ(call(&whole), CGW_OK);
  for (std::size_t size = 8; size <= sizeof(Guarded); size += alignof(T)) {
    Guarded given;
    std::memset(&given, 0xA5, sizeof given);
    std::memcpy(&given, &init, std::min(size, sizeof init));
    given.value.struct_size = static_cast<std::uint32_t>(size);
    Guarded expected = given;
    std::memcpy(&expected, &whole, std::min(size, sizeof whole));
    expected.value.struct_size = given.value.struct_size;
    ASSERT_EQ(call(&given.value), CGW_OK) << "struct_size " << size;
    EXPECT_EQ(std::memcmp(&given, &expected, sizeof given), 0) << "struct_size " << size;
  }
  for (const std::uint32_t size : {0u, 4u, 7u}) {
    T small = init;
    small.struct_size = size;
    EXPECT_REFUSED(call(&small)) << "struct_size " << size;
  }
}

TEST(AbiStructSize, BoundsWhatResultsWrite) {
  const SolvedCapsule solved;
  cgw_session* s = solved.session;
  const cgw_api& a = api();
  expect_only_common_bytes_written<cgw_parameter>(CGW_PARAMETER_INIT,
                                                  [&](cgw_parameter* out) { return a.parameter_info(4, out); });
  expect_only_common_bytes_written<cgw_mesh_report>(CGW_MESH_REPORT_INIT,
                                                    [&](cgw_mesh_report* out) { return a.mesh_report(s, out); });
  expect_only_common_bytes_written<cgw_slide_info>(CGW_SLIDE_INFO_INIT,
                                                   [&](cgw_slide_info* out) { return a.slide_info(s, 1, out); });
  expect_only_common_bytes_written<cgw_parts>(CGW_PARTS_INIT, [&](cgw_parts* out) { return a.get_parts(s, out); });
  expect_only_common_bytes_written<cgw_loop>(CGW_LOOP_INIT, [&](cgw_loop* out) { return a.get_loop(s, 1, out); });
  expect_only_common_bytes_written<cgw_section>(CGW_SECTION_INIT,
                                                [&](cgw_section* out) { return a.get_section(s, 1, out); });
  expect_only_common_bytes_written<cgw_cage>(CGW_CAGE_INIT, [&](cgw_cage* out) { return a.get_cage(s, out); });
  expect_only_common_bytes_written<cgw_summary>(CGW_SUMMARY_INIT,
                                                [&](cgw_summary* out) { return a.get_summary(s, out); });
  ASSERT_EQ(a.slide_remove(s, 99), CGW_ERROR_UNKNOWN_SLIDE);
  expect_only_common_bytes_written<cgw_error_info>(
      CGW_ERROR_INFO_INIT, [](cgw_error_info* out) { return api().last_error_info(nullptr, out); });
}

TEST(AbiStructSize, BoundsWhatIterationsWrite) {
  const SolvedCapsule solved;
  ASSERT_EQ(api().set_parameter_text(solved.session, "enclose.mode", "off"), CGW_OK);
  ASSERT_EQ(api().set_parameter(solved.session, "refine.delta", 0.01), CGW_OK);
  ASSERT_EQ(api().solve(solved.session, nullptr), CGW_OK);
  expect_only_common_bytes_written<cgw_iteration>(
      CGW_ITERATION_INIT, [&](cgw_iteration* out) { return api().get_iteration(solved.session, 0, out); });
}

TEST(AbiStructSize, ThatEndsInsideAPointerDoesNotTearIt) {
  const SolvedCapsule solved;
  std::vector<double> points(3000);
  cgw_loop loop = CGW_LOOP_INIT;
  loop.points = points.data();
  loop.point_capacity = 1000;
  loop.struct_size = offsetof(cgw_loop, points) + 4;
  EXPECT_EQ(api().get_loop(solved.session, 0, &loop), CGW_OK);
  EXPECT_GT(loop.point_count, 0u);
  EXPECT_EQ(points, std::vector<double>(3000));
}

TEST(AbiStructSize, ShortInputsMeanDefaults) {
  const SolvedCapsule solved;
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.struct_size = 8;
  options.last_stage = CGW_STAGE_ORIENT;
  options.editing = 77;  // beyond struct_size: must not be looked at
  EXPECT_EQ(api().solve(solved.session, &options), CGW_OK) << solved.session.error();
  cgw_summary summary = CGW_SUMMARY_INIT;
  EXPECT_EQ(api().get_summary(solved.session, &summary), CGW_OK);
  EXPECT_EQ(summary.last_stage, CGW_STAGE_ORIENT);

  cgw_host host = CGW_HOST_INIT;
  host.struct_size = 16;
  host.progress = [](void*, double, const char*) -> std::int32_t { return 1; };  // not seen, so it cannot cancel
  EXPECT_NO_THROW(SolvedCapsule{&host});
}

TEST(AbiStructSize, TooSmallIsRefusedInInputs) {
  const Session session(capsule());
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.struct_size = 4;
  EXPECT_REFUSED(api().solve(session, &options));
  EXPECT_NE(session.error().find("struct_size of cgw_solve_options is 4"), std::string::npos) << session.error();
  const Mesh mesh = capsule();
  cgw_mesh view = mesh.view();
  view.struct_size = 0;
  EXPECT_REFUSED(api().set_mesh(session, &view));
  cgw_slide_input input = plane("a", 1);
  input.struct_size = 7;
  std::uint64_t id = 0;
  EXPECT_REFUSED(api().slide_add(session, &input, &id));
  cgw_host host = CGW_HOST_INIT;
  host.struct_size = 3;
  cgw_session* made = nullptr;
  EXPECT_REFUSED(api().session_create(&host, &made));
  EXPECT_EQ(made, nullptr);
}

TEST(AbiArgument, ThatIsNoneOfItsKindIsRefusedAndTold) {
  const SolvedCapsule solved;
  const Session& s = solved.session;
  cgw_slide_input input = plane("odd", 1);
  input.kind = 4;
  std::uint64_t id = 0;
  EXPECT_REFUSED(api().slide_add(s, &input, &id));
  EXPECT_NE(s.error().find("'odd': kind 4"), std::string::npos) << s.error();
  input = plane("bad \xC3\x28 name", 1);
  EXPECT_REFUSED(api().slide_add(s, &input, &id));
  EXPECT_NE(s.error().find("UTF-8 from its byte 4"), std::string::npos) << s.error();
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.last_stage = 6;
  EXPECT_REFUSED(api().solve(s, &options));
  EXPECT_NE(s.error().find("last_stage is 6"), std::string::npos) << s.error();
  options = CGW_SOLVE_OPTIONS_INIT;
  options.editing = 3;
  EXPECT_REFUSED(api().solve(s, &options));
  EXPECT_NE(s.error().find("editing is 3, which is none of CGW_EDITING_*"), std::string::npos) << s.error();
  cgw_section section = CGW_SECTION_INIT;
  EXPECT_REFUSED(api().get_section(s, 3, &section));
  EXPECT_NE(s.error().find("index 3"), std::string::npos) << s.error();
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  EXPECT_REFUSED(api().slide_info(s, 3, &info));
  EXPECT_NE(s.error().find("index 3"), std::string::npos) << s.error();
}

TEST(AbiArgument, MeshWithMoreRowsThanIndicesReachIsRefused) {
  const Mesh mesh = tetrahedron();
  cgw_mesh view = mesh.view();
  view.vertex_count = std::uint64_t{1} << 40;
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  EXPECT_REFUSED(api().inspect_mesh(&view, &report));
  EXPECT_NE(std::string(api().last_error(nullptr)).find("1099511627776"), std::string::npos);
}

}  // namespace
