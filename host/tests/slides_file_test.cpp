// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/slides_file.h"

#include <random>

#include "host/tests/expect_file_error.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

std::vector<Slide> parse(const std::string& text) { return parse_slides("s.json", text); }

std::string with_slide(const std::string& slide) { return "{\"version\": 1, \"slides\": [" + slide + "]}"; }

TEST(SlidesFile, ReadsTheFourKindsInTheirOrder) {
  const auto slides = parse(R"({"version": 1, "slides": [
    {"name": "wrist", "stroke": [[1, 2, 3], [4.5, -5e-1, 6]]},
    {"name": "knee", "point": [1, 2, 3], "normal": [0, 0, 2]},
    {"name": "Hüfte", "center": [1, 2, 3], "u": [1, 0, 0], "v": [0, 1, 0]},
    {"name": "click", "point": [1, 2, 4]}]})");
  ASSERT_EQ(slides.size(), 4u);
  EXPECT_EQ(slides[0].name, "wrist");
  EXPECT_EQ(std::get<Slide::Stroke>(slides[0].shape).points, (std::vector<Point3>{{1, 2, 3}, {4.5, -0.5, 6}}));
  EXPECT_EQ(std::get<Slide::PointNormal>(slides[1].shape).normal, (Point3{0, 0, 2}));
  EXPECT_EQ(slides[2].name, "Hüfte");
  EXPECT_EQ(std::get<Slide::Ellipse>(slides[2].shape).v, (Point3{0, 1, 0}));
  EXPECT_EQ(std::get<Slide::Point>(slides[3].shape).point, (Point3{1, 2, 4}));
}

TEST(SlidesFile, VersionIsTheNumber1HoweverItIsWritten) {
  for (const std::string one : {"1", "1.0", "1e0", "10e-1"}) {
    EXPECT_TRUE(parse("{\"version\": " + one + ", \"slides\": []}").empty()) << one;
  }
}

TEST(SlidesFile, EveryNumberComesBackBitForBit) {
  std::mt19937 random(1);
  const auto number = [&] {
    return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), static_cast<int>(random() % 2000) - 1000);
  };
  const auto point = [&] { return Point3{number(), number(), number()}; };
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Slide> slides = {{"a \"quoted\" name\n", Slide::Stroke{{point(), point(), point()}}},
                                       {"b", Slide::PointNormal{point(), point()}},
                                       {"c", Slide::Ellipse{point(), point(), point()}},
                                       {"d", Slide::Point{point()}}};
    const auto copy = parse(slides_text("s.json", slides));
    EXPECT_EQ(copy, slides);
  }
}

TEST(SlidesFile, AcceptsNoSlides) { EXPECT_TRUE(parse(slides_text("s.json", {})).empty()); }

TEST(SlidesFile, NamesTheLineAndColumnOfWhatIsNotJson) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
    SCOPED_TRACE(text);
    expect_file_error([&] { parse(text); }, parts);
  };
  expect("", {"s.json, line 1, column 1", "is not JSON"});
  expect("{\"version\": 1,\n  oops}", {"s.json, line 2, column 3", "is not JSON"});
  expect("{\"version\": 1}\n}", {"s.json, line 2, column 1", "is not JSON"});
  expect(with_slide("{\"name\": \"a\", \"point\": [NaN, 0, 0]}"), {"s.json, line 1", "is not JSON"});
  expect("{\"version\": 1, \"slides\": [{\"name\": \"a\",\n\"stroke\": [[0, 0, 0], [0, 1e999, 0]]}]}",
         {"s.json, line 2", "slides[0].stroke[1][1]", "1e999"});
}

TEST(SlidesFile, NamesTheSlideAndTheKeyAtFault) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
    SCOPED_TRACE(text);
    expect_file_error([&] { parse(text); }, parts);
  };
  expect("[]", {"s.json", "should be an object"});
  expect("{\"slides\": []}", {"s.json", "no \"version\""});
  expect("{\"version\": 2, \"slides\": []}", {"s.json", "version \"2\"", "reads version 1"});
  expect("{\"version\": 1.5, \"slides\": []}", {"s.json", "version \"1.5\"", "reads version 1"});
  expect("{\"version\": true, \"slides\": []}", {"s.json", "version \"true\"", "reads version 1"});
  expect("{\"version\": \"1\", \"slides\": []}", {"s.json", "version", "reads version 1"});
  expect("{\"version\": 1}", {"s.json", "no \"slides\""});
  expect("{\"version\": 1, \"slides\": {}}", {"s.json", "\"slides\" should be an array"});
  expect("{\"version\": 1, \"slides\": [], \"more\": 1}", {"s.json", "unknown key \"more\""});
  expect("{\"version\": 1, \"version\": 1, \"slides\": []}", {"s.json", "version", "twice"});
  expect(with_slide("7"), {"slide 0", "should be an object"});
  expect(with_slide("{\"stroke\": []}"), {"slide 0", "no \"name\""});
  expect(with_slide("{\"name\": 7, \"stroke\": []}"), {"slide 0", "\"name\" should be a string"});
  expect(with_slide("{\"name\": \"\", \"stroke\": []}"), {"slide 0", "\"name\" is empty"});
  expect(with_slide("{\"name\": \"a\\u0000b\", \"stroke\": []}"), {"slide 0", "\"name\"", "zero"});
  expect(with_slide("{\"name\": \"a\", \"stroke\": []}, {\"name\": \"a\", \"stroke\": []}"),
         {"slide 1 (\"a\")", "\"name\"", "slide 0"});
  expect(with_slide("{\"name\": \"a\"}"), {"slide 0 (\"a\")", "stroke", "point", "center"});
  expect(with_slide("{\"name\": \"a\", \"stroke\": [], \"colour\": 1}"), {"slide 0 (\"a\")", "unknown key \"colour\""});
  expect(with_slide("{\"name\": \"a\", \"stroke\": [], \"stroke\": []}"), {"slides[0].stroke", "twice"});
  expect(with_slide("{\"name\": \"a\", \"stroke\": [], \"point\": [0,0,0]}"),
         {"(\"a\")", "both \"stroke\" and \"point\""});
  expect(with_slide("{\"name\": \"a\", \"point\": [0,0,0], \"u\": [0,0,0]}"), {"(\"a\")", "both \"point\" and \"u\""});
  expect(with_slide("{\"name\": \"a\", \"stroke\": 7}"), {"(\"a\")", "\"stroke\" should be an array"});
  expect(with_slide("{\"name\": \"a\", \"stroke\": [[0,0,0],[1,2]]}"), {"(\"a\")", "point 1 of \"stroke\""});
  expect(with_slide("{\"name\": \"a\", \"point\": [0,0]}"), {"(\"a\")", "\"point\"", "three numbers"});
  expect(with_slide("{\"name\": \"a\", \"normal\": [0,0,0]}"), {"(\"a\")", "no \"point\""});
  expect(with_slide("{\"name\": \"a\", \"point\": [0,0,0,0], \"normal\": [0,0,1]}"),
         {"(\"a\")", "\"point\"", "three numbers"});
  expect(with_slide("{\"name\": \"a\", \"point\": [0,\"0\",0], \"normal\": [0,0,1]}"),
         {"(\"a\")", "\"point\"", "three numbers"});
  expect(with_slide("{\"name\": \"a\", \"center\": [0,0,0], \"u\": [0,0,0]}"), {"(\"a\")", "no \"v\""});
  expect(with_slide("{\"name\": \"a\", \"center\": [0,0,0], \"u\": null, \"v\": [0,0,0]}"),
         {"(\"a\")", "\"u\"", "three numbers"});
}

TEST(SlidesFile, WritesNoFileThatItWouldNotRead) {
  expect_file_error([] { slides_text("s.json", {{"", Slide::Stroke{}}}); }, {"s.json", "\"name\" is empty"});
  expect_file_error(
      [] {
        slides_text("s.json", {{"\xFF", Slide::Stroke{}}});
      },
      {"s.json", "cannot be written", "UTF-8"});
}

TEST(SlidesFile, NamesTheFileThatIsMissing) {
  const TemporaryFolder folder;
  expect_file_error([&] { read_slides(folder / "none.json"); }, {"none.json", "no such file"});
}

}  // namespace
}  // namespace cagewright::host
