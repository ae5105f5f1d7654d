// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/file/file_bytes.h"
#include "host/plugin_client/find_plugin.h"
#include "host/plugin_client/plugin.h"
#include "host/plugin_client/plugin_error.h"
#include "host/plugin_client/session.h"
#include "host/tests/environment.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

std::shared_ptr<const Plugin> fake() { return Plugin::load(FAKE_PLUGIN); }

bool is_loaded() {
  void* library = ::dlopen(FAKE_PLUGIN, RTLD_NOW | RTLD_NOLOAD);
  if (library != nullptr) ::dlclose(library);
  return library != nullptr;
}

void expect_load_error(const std::filesystem::path& path, const std::vector<std::string>& parts) {
  try {
    Plugin::load(path);
    ADD_FAILURE() << "loaded " << path;
  } catch (const PluginLoadError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find(path.string()), 0u) << sentence;
    for (const std::string& part : parts)
      EXPECT_NE(sentence.find(part), std::string::npos) << part << " in " << sentence;
  }
}

TEST(FindPlugin, TakesWhatIsAskedForThenTheEnvironment) {
  const Environment environment("CAGEWRIGHT_PLUGIN", "/from/environment.so");
  EXPECT_EQ(find_plugin("asked.so"), "asked.so");
  EXPECT_EQ(find_plugin({}), "/from/environment.so");
}

TEST(Plugin, IsUnloadedWithItsLastOwner) {
  std::shared_ptr<const Plugin> plugin = fake();
  auto session = std::make_unique<Session>(plugin, SessionListener{});
  plugin.reset();
  EXPECT_TRUE(is_loaded());
  session.reset();
  EXPECT_FALSE(is_loaded());
}

TEST(Plugin, IsRefusedWithTheFileAndTheReason) {
  expect_load_error("missing.so", {"no such plug-in"});
  expect_load_error("/proc/self/maps", {"cannot be loaded"});
  expect_load_error("/lib/x86_64-linux-gnu/libm.so.6", {"no plug-in", CGW_ENTRY_POINT});
  const std::string other_major = "has ABI 2." + std::to_string(CGW_ABI_MINOR);
  const std::string not_served = "does not serve ABI 1." + std::to_string(CGW_ABI_MINOR);
  for (const auto& [what, reason] : {std::pair{"null_table", not_served.c_str()}, std::pair{"small_table", "bytes"},
                                     std::pair{"other_major", other_major.c_str()}, std::pair{"gaps", "has gaps"}}) {
    const Environment environment("CAGEWRIGHT_FAKE", what);
    expect_load_error(FAKE_PLUGIN, {"no plug-in for this program", reason});
    EXPECT_FALSE(is_loaded()) << what;
  }
}

// The loader would map it, and the program end where it reads what is not there.
TEST(Plugin, ThatIsCutShortAnywhereIsRefused) {
  const std::string whole = read_bytes(FAKE_PLUGIN);
  ASSERT_GT(whole.size(), 5000u);
  const TemporaryFolder folder;
  for (const std::size_t size :
       {std::size_t{64}, std::size_t{70}, std::size_t{700}, whole.size() / 4, whole.size() / 2}) {
    const std::filesystem::path cut = folder.write("cut.so", whole.substr(0, size));
    expect_load_error(cut.string(), {"cut.so", "cut short, after " + std::to_string(size) + " of "});
  }
  EXPECT_NO_THROW(Plugin::load(folder.write("copy.so", whole)));
}

TEST(Session, CertificateListsItsFindingsWhereThePluginDoes) {
  for (const bool is_older : {false, true}) {
    const Environment environment("CAGEWRIGHT_FAKE", is_older ? "older,crossing" : "crossing");
    Session session(fake(), {});
    session.set_mesh(unit_cube());
    session.solve(1);
    const Certificate certificate = session.certificate();
    EXPECT_EQ(certificate.message, "move slide 'a'");
    if (is_older) {
      EXPECT_TRUE(certificate.findings.empty());
      continue;
    }
    ASSERT_EQ(certificate.findings.size(), 2U);
    EXPECT_EQ(certificate.findings[0].sentence, "move slide 'a'");
    EXPECT_EQ(certificate.findings[0].slides, std::vector<std::uint64_t>{1});
    EXPECT_FALSE(certificate.findings[0].place);
    EXPECT_EQ(certificate.findings[1].sentence, "add one");
    EXPECT_TRUE(certificate.findings[1].slides.empty());
    EXPECT_EQ(certificate.findings[1].place, (std::array<double, 3>{0, 0, 2.5}));
  }
}

TEST(Plugin, OfAnEarlierVersionServesForAllButWhatItDoesNotHave) {
  const Environment environment("CAGEWRIGHT_FAKE", "older");
  Session session(fake(), {});
  session.set_mesh(unit_cube());
  session.add_slide({"a", Slide::PointNormal{}});
  session.solve(1);
  try {
    session.fit({"a", Slide::PointNormal{}});
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_INVALID_ARGUMENT);
    const std::string sentence = error.what();
    for (const char* part : {FAKE_PLUGIN, "has ABI 1.2", "needs 1.3", "newer plug-in"})
      EXPECT_NE(sentence.find(part), std::string::npos) << part << " in " << sentence;
  }
}

TEST(Plugin, DescribesItsParameters) {
  const std::vector<Parameter> parameters = fake()->parameters();
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(parameters[0].id, "orient.lambda");
  EXPECT_EQ(parameters[0].default_value, 4);
  EXPECT_EQ(parameters[2].choices, (std::vector<std::string>{"local", "part"}));
}

TEST(Plugin, ErrorsWithoutASessionCarryTheirSentence) {
  try {
    fake()->inspect({});
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_MESH_EMPTY);
    EXPECT_STREQ(error.what(), "the mesh has no triangles");
  }
}

TEST(Session, GivesTheCageAndItsFigures) {
  Session session(fake(), {});
  session.set_mesh(unit_cube());
  session.add_slide({"a", Slide::PointNormal{}});
  session.solve(1);
  EXPECT_EQ(session.cage().points, unit_cube().points);
  EXPECT_EQ(session.cage().triangle_count(), 12u);
  EXPECT_EQ(session.part_count(), 2u);
  EXPECT_EQ(session.sections().size(), 1u);
  EXPECT_EQ(session.max_signed_distances(), (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(session.summary().volume_ratio, 1.5);
  EXPECT_EQ(session.summary().extent, 1.75);
  ASSERT_EQ(session.slides().size(), 1u);
  EXPECT_EQ(session.slides()[0].name, "a");
}

TEST(Session, FiguresThatAnOlderPluginDoesNotKnowAreNotANumber) {
  const Environment environment("CAGEWRIGHT_FAKE", "short_summary");
  Session session(fake(), {});
  EXPECT_EQ(session.summary().max_signed_distance_over_diagonal, 0.0005);
  EXPECT_TRUE(std::isnan(session.summary().volume_ratio));
  EXPECT_TRUE(std::isnan(session.summary().refine_ms));
  EXPECT_TRUE(std::isnan(session.summary().extent));
}

TEST(Session, ErrorsCarryStatusSentenceAndBlame) {
  const Environment environment("CAGEWRIGHT_FAKE", "slides_touch");
  Session session(fake(), {});
  session.set_mesh(unit_cube());
  try {
    session.solve(0);
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_SLIDES_TOUCH);
    EXPECT_EQ(blame(error.status()), Blame::slides);
    EXPECT_STREQ(error.what(), "slides \"a\" and \"b\" touch");
  }
}

TEST(Session, SaysWhichCallFailedWhereThePluginGivesNoSentence) {
  const Environment environment("CAGEWRIGHT_FAKE", "internal,no_sentence");
  Session session(fake(), {});
  try {
    session.solve(0);
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_STREQ(error.what(), "the plug-in's solve failed (internal)");
  }
}

TEST(Session, IsCancelledByTheListener) {
  const Environment environment("CAGEWRIGHT_FAKE", "wait");
  int calls = 0;
  Session session(fake(), {.log = {}, .may_continue = [&calls](double, const std::string&) { return ++calls < 5; }});
  session.set_mesh(unit_cube());
  EXPECT_THROW(session.solve(0), Cancelled);
  EXPECT_EQ(calls, 5);
}

TEST(Blame, FollowsTheRangesOfTheHeader) {
  for (const cgw_status status : {CGW_ERROR_MESH_EMPTY, CGW_ERROR_MESH_NOT_ORIENTABLE}) {
    EXPECT_EQ(blame(status), Blame::model);
  }
  for (const cgw_status status :
       {CGW_ERROR_STROKE_TOO_SHORT, CGW_ERROR_SLIDE_NAME, CGW_ERROR_SLIDES_TOUCH, CGW_ERROR_REFINE_DIVERGED}) {
    EXPECT_EQ(blame(status), Blame::slides);
  }
  EXPECT_EQ(blame(CGW_ERROR_UNKNOWN_PARAMETER), Blame::parameter);
  for (const cgw_status status :
       {CGW_ERROR_INTERNAL, CGW_ERROR_OUT_OF_MEMORY, CGW_ERROR_STREAM, CGW_ERROR_STATE_MAGIC}) {
    EXPECT_EQ(blame(status), Blame::program);
  }
}

}  // namespace
}  // namespace cagewright::host
