// SPDX-License-Identifier: BSD-3-Clause
//
// A host's functions that call back into the session that called them.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

// Runs `inside` in every function of the host and of the stream.
struct CallingBack {
  CallingBack() {
    host.user = stream.user = this;
    host.log = [](void* user, std::int32_t, const char*) { call(user); };
    host.progress = [](void* user, double, const char*) -> std::int32_t { return call(user); };
    stream.read = [](void* user, void*, std::uint64_t) -> std::uint64_t { return static_cast<unsigned>(call(user)); };
    stream.write = [](void* user, const void*, std::uint64_t count) {
      return count + static_cast<unsigned>(call(user));
    };
  }
  static int call(void* user) {
    auto& self = *static_cast<CallingBack*>(user);
    ++self.calls;
    if (self.inside) self.inside();
    return 0;
  }
  cgw_host host = CGW_HOST_INIT;
  cgw_stream stream = CGW_STREAM_INIT;
  std::function<void()> inside;
  int calls = 0;
};

void expect_refused(cgw_status status, const char* call) {
  EXPECT_EQ(status, CGW_ERROR_INVALID_ARGUMENT) << call;
  EXPECT_NE(std::string(api().last_error(nullptr)).find("another call"), std::string::npos) << call;
}

void expect_everything_refused(cgw_session* session) {
  const cgw_api& a = api();
  const Mesh mesh = torus();
  const cgw_mesh view = mesh.view();
  const cgw_slide_input input = plane("from inside", 3);
  cgw_slide_info slide = CGW_SLIDE_INFO_INIT;
  cgw_cage cage = CGW_CAGE_INIT;
  CallingBack nothing;
  std::uint64_t id = 4711;
  double value = 0;
  expect_refused(a.set_mesh(session, &view), "set_mesh");
  expect_refused(a.set_parameter(session, "refine.delta", 0.5), "set_parameter");
  expect_refused(a.get_parameter(session, "refine.delta", &value), "get_parameter");
  expect_refused(a.slide_add(session, &input, &id), "slide_add");
  expect_refused(a.slide_change(session, 1, &input), "slide_change");
  expect_refused(a.slide_remove(session, 1), "slide_remove");
  expect_refused(a.slide_info(session, 0, &slide), "slide_info");
  cgw_finding finding = CGW_FINDING_INIT;
  expect_refused(a.get_finding(session, 0, &finding), "get_finding");
  expect_refused(a.solve(session, nullptr), "solve");
  expect_refused(a.get_cage(session, &cage), "get_cage");
  expect_refused(a.save_state(session, &nothing.stream), "save_state");
  expect_refused(a.load_state(session, &nothing.stream), "load_state");
  EXPECT_EQ(nothing.calls, 0);
  EXPECT_EQ(a.slide_count(session), 0u);
  EXPECT_EQ(a.section_count(session), 0u);
  EXPECT_EQ(a.iteration_count(session), 0u);
  a.session_destroy(session);
}

TEST(AbiCallback, IntoTheSameSessionIsRefusedAndChangesNothing) {
  CallingBack calling;
  const Session session(&calling.host, turned_inside_out(capsule()));  // inside out, so that there is a log
  EXPECT_EQ(calling.calls, 1);
  const std::uint64_t id = add(session, plane("left", 1.01));
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  const Cage cage = cage_of(session);
  const Mesh again = turned_inside_out(capsule());
  const cgw_mesh view = again.view();

  calling.inside = [&] { expect_everything_refused(session); };
  calling.calls = 0;
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  EXPECT_GE(calling.calls, 3);
  EXPECT_EQ(cage_of(session), cage);
  ASSERT_EQ(api().slide_count(session), 1u);
  EXPECT_EQ(info(session, 0).id, id);
  EXPECT_EQ(session.error(), "") << "the refused calls' sentences are the thread's, not the session's";

  calling.calls = 0;
  ASSERT_EQ(api().set_mesh(session, &view), CGW_OK) << session.error();
  EXPECT_EQ(calling.calls, 1);
  EXPECT_EQ(api().save_state(session, &calling.stream), CGW_OK) << session.error();
  EXPECT_EQ(api().load_state(session, &calling.stream), CGW_ERROR_STREAM);
  EXPECT_EQ(calling.calls, 3);
  EXPECT_EQ(api().slide_count(session), 1u);
}

TEST(AbiCallback, LeavesTheSessionUsableWhereItThrows) {
  CallingBack calling;
  const Session session(&calling.host, capsule());
  calling.inside = [] { throw 1; };
  EXPECT_EQ(api().solve(session, nullptr), CGW_ERROR_INTERNAL);
  calling.inside = {};
  EXPECT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
}

TEST(AbiCallback, IntoAnotherSessionIsAllowed) {
  const SolvedCapsule other;
  CallingBack calling;
  const Session session(&calling.host, capsule());
  calling.inside = [&] {
    EXPECT_EQ(api().solve(other.session, nullptr), CGW_OK);
    EXPECT_EQ(api().slide_count(other.session), 3u);
    cgw_parameter parameter = CGW_PARAMETER_INIT;
    EXPECT_EQ(api().parameter_info(0, &parameter), CGW_OK);
  };
  EXPECT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  EXPECT_GE(calling.calls, 3);
}

}  // namespace
