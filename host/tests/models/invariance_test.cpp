// SPDX-License-Identifier: BSD-3-Clause
//
// What must not change a cage: where the model lies, how large it is, in which order its file lists things, how many
// threads work on it.
#include <gtest/gtest.h>

#include <fstream>

#include "host/tests/models/model_cage.h"
#include "host/tests/models/same_cage.h"
#include "host/tests/models/similarity.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

constexpr double tolerance = 1e-9;  // over the model's diagonal

class Invariance : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    if (const auto why = GetParam().why_missing()) GTEST_SKIP() << *why;
    model = read_off(GetParam().file());
  }

  void make_first(const std::vector<std::string>& options) {
    first = make_cage(folder, GetParam().file(), GetParam().slides_file(), options);
    ASSERT_EQ(first.run.exit_code, 0) << first.run.errors;
  }

  json slides() const {
    std::ifstream file(GetParam().slides_file());
    return json::parse(file);
  }

  TemporaryFolder folder;
  Surface model;
  CageRun first;
};

// The paper's stages turn with the model. Enclosing rounds to floats, which do not, and goes by what is in the way.
const std::vector<std::string> paper = {"--set", "enclose.mode=off"};

TEST_P(Invariance, OfMotionAndScale) {
  make_first(paper);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Similarity motion = random_similarity(seed, diagonal(model));
    const auto file = folder.write("moved.off", off_text(moved(model, motion)));
    const auto slides_file = folder.write("moved.json", moved_slides(slides(), motion).dump());
    const CageRun second = make_cage(folder, file, slides_file, paper);
    ASSERT_EQ(second.run.exit_code, 0) << second.run.errors;
    EXPECT_EQ(difference(moved(first.cage, motion), second.cage, tolerance * motion.scale * diagonal(model)), "")
        << "seed " << seed << ", scale " << motion.scale;
  }
}

TEST_P(Invariance, OfTheNumberOfThreads) {
  make_first({});
  for (const char* threads : {"1", "2", "5"}) {
    const CageRun second = make_cage(folder, GetParam().file(), GetParam().slides_file(), {"--threads", threads});
    ASSERT_EQ(second.run.exit_code, 0) << second.run.errors;
    EXPECT_TRUE(second.cage_bytes == first.cage_bytes) << threads << " threads";
  }
}

TEST_P(Invariance, OfTheOrderOfVerticesAndTriangles) {
  make_first(paper);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const auto file = folder.write("shuffled.off", off_text(shuffled(model, seed)));
    const CageRun second = make_cage(folder, file, GetParam().slides_file(), paper);
    ASSERT_EQ(second.run.exit_code, 0) << second.run.errors;
    EXPECT_EQ(second.report()["parts"], first.report()["parts"]);
    EXPECT_EQ(difference_in_any_order(first.cage, second.cage, tolerance * diagonal(model)), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Invariance, testing::ValuesIn(all_models()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cagewright::host
