// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "testdata/tests/slide_file.h"

namespace cagewright::testdata {
namespace {

std::vector<std::filesystem::path> slide_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CAGEWRIGHT_SLIDE_FILES))
    if (entry.path().string().ends_with(".slides.json")) files.push_back(entry.path());
  return files;
}

std::string complaint_about(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "cagewright_slides.json";
  std::ofstream(file) << text;
  try {
    read_slides(file);
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(SlideFiles, AreWellFormedWithUniqueNamesAndFiniteNumbers) {
  const std::vector<std::filesystem::path> files = slide_files();
  EXPECT_GE(files.size(), 5u);
  for (const std::filesystem::path& file : files) {
    std::vector<Slide> slides;
    EXPECT_NO_THROW(slides = read_slides(file)) << file;
    EXPECT_GE(slides.size(), 3u) << file;
  }
}

TEST(SlideFiles, OfOurOwnModelsUseEveryKindOfSlide) {
  for (const char* name : {"biped", "quadruped", "octopus", "genus3", "blob", "legs"}) {
    int count[3] = {0, 0, 0};
    for (const Slide& slide :
         read_slides(std::filesystem::path(CAGEWRIGHT_SLIDE_FILES) / (std::string(name) + ".slides.json")))
      ++count[static_cast<int>(slide.kind)];
    EXPECT_GT(count[0], 0) << name << " has no stroke";
    EXPECT_GT(count[1], 0) << name << " has no point and normal";
    EXPECT_GT(count[2], 0) << name << " has no center, u and v";
  }
}

TEST(SlideFiles, FaultsAreFoundAndTheSlideIsNamed) {
  const auto with = [](const std::string& slides) { return "{\"version\": 1, \"slides\": [" + slides + "]}"; };
  const std::string good = R"({"name": "a", "point": [0, 0, 0], "normal": [0, 0, 1]})";
  EXPECT_EQ(complaint_about(with(good)), "");
  EXPECT_NE(complaint_about("{"), "");
  EXPECT_EQ(complaint_about("{\"version\": 2, \"slides\": []}"), "the version is not 1");
  EXPECT_EQ(complaint_about(with(good + "," + good)), "slide a: another slide has that name");
  EXPECT_EQ(complaint_about(with(R"({"name": "b", "point": [0, 0, 0], "normal": [0, 0, 0]})")),
            "slide b: its plane has no normal");
  EXPECT_EQ(complaint_about(with(R"({"name": "b", "center": [0, 0, 0], "u": [1, 2, 0], "v": [2, 4, 0]})")),
            "slide b: its plane has no normal");
  EXPECT_EQ(complaint_about(with(R"({"name": "b", "point": [0, 0]})")),
            "slide b: it is neither a stroke, nor a point and a normal, nor a center, u and v");
  EXPECT_EQ(complaint_about(with(R"({"name": "b", "point": [0, 0], "normal": [0, 0, 1]})")),
            "slide b: a point is not three numbers");
  EXPECT_EQ(complaint_about(with(R"({"name": "b", "stroke": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]})")),
            "slide b: the stroke has fewer than 5 points");
  EXPECT_EQ(
      complaint_about(with(R"({"name": "b", "stroke": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0]]})")),
      "slide b: the stroke runs along a line");
}

}  // namespace
}  // namespace cagewright::testdata
