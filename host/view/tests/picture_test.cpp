// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/picture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "host/file/file_error.h"
#include "host/view/tests/image.h"

namespace cagewright::host {
namespace {

namespace fs = std::filesystem;

// A box of half size s round the origin, outward.
struct Box {
  explicit Box(double s) {
    for (int i = 0; i < 8; ++i) {
      points.insert(points.end(), {(i & 1) != 0 ? s : -s, (i & 2) != 0 ? s : -s, (i & 4) != 0 ? s : -s});
    }
  }
  std::vector<double> points;
  std::vector<std::uint32_t> triangles{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
};

bool red(int r, int g, int b) { return r > 150 && g < 90 && b < 90; }
bool orange(int r, int g, int b) { return r > 170 && g > 90 && g < r - 40 && b < g - 60; }
bool green(int r, int g, int b) { return g > 100 && r < g - 70 && b < g - 50; }
bool blue(int r, int g, int b) { return b > 90 && r < b - 50 && g < b - 50; }
bool grey(int r, int g, int b) { return r < 225 && std::abs(r - g) < 12 && std::abs(g - b) < 12; }
bool white(int r, int g, int b) { return r == 255 && g == 255 && b == 255; }

class Picture : public testing::Test {
 protected:
  Picture() {
    std::string pattern = (fs::temp_directory_path() / "cagewright-picture-XXXXXX").string();
    folder = mkdtemp(pattern.data());
  }
  ~Picture() override { fs::remove_all(folder); }

  Image draw(const PictureInput& input, const PictureOptions& options = {320, 240, {View{}}}) const {
    write_picture(input, options, folder / "out.png");
    return read_png(folder / "out.png");
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  PictureInput everything() const {
    return {model.points, model.triangles, cage.points, cage.triangles, {slide}, {section}};
  }

  fs::path folder;
  Box model{1};
  Box cage{1.4};
  SlideMark slide{{0, 0, 0}, {1.2, 0, 0}, {0, 0, 1.2}, false};
  std::array<double, 12> section{1.4, 0.5, 1.4, -1.4, 0.5, 1.4, -1.4, 0.5, -1.4, 1.4, 0.5, -1.4};
};

std::string sentence_of(PictureFault fault, const std::function<void()>& work) {
  try {
    work();
  } catch (const PictureError& error) {
    EXPECT_EQ(error.fault(), fault) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

void expect_mentions(const std::string& sentence, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' is not in: " << sentence;
  }
}

class DisplayVariable {  // for the life of the object
 public:
  explicit DisplayVariable(const char* value) {
    const char* now = std::getenv("DISPLAY");
    had_ = now != nullptr;
    before_ = had_ ? now : "";
    value != nullptr ? setenv("DISPLAY", value, 1) : unsetenv("DISPLAY");
  }
  ~DisplayVariable() { had_ ? setenv("DISPLAY", before_.c_str(), 1) : unsetenv("DISPLAY"); }
  DisplayVariable(const DisplayVariable&) = delete;
  DisplayVariable& operator=(const DisplayVariable&) = delete;

 private:
  bool had_ = false;
  std::string before_;
};

TEST_F(Picture, ShowsModelCageSlidesAndSectionsInTheirColours) {
  const Image image = draw(everything());
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 240);
  EXPECT_GT(image.count(grey), 2000);
  EXPECT_GT(image.count(blue), 500);
  EXPECT_GT(image.count(red), 200);
  EXPECT_GT(image.count(green), 200);
  EXPECT_GT(image.count(white), 10000);
  EXPECT_EQ(image.count(orange), 0);
}

TEST_F(Picture, ShowsNothingThatTheInputLacks) {
  PictureInput input = everything();
  input.slides.clear();
  EXPECT_EQ(draw(input).count(red), 0);
  input.sections.clear();
  EXPECT_EQ(draw(input).count(green), 0);
  input.cage_triangles = {};
  input.cage_points = {};
  const Image model_only = draw(input);
  EXPECT_EQ(model_only.count(blue), 0);
  EXPECT_GT(model_only.count(grey), 2000);
}

TEST_F(Picture, ShowsFailedSlidesInAnotherColour) {
  slide.failed = true;
  const Image image = draw(everything());
  EXPECT_EQ(image.count(red), 0);
  EXPECT_GT(image.count(orange), 200);
}

TEST_F(Picture, ShowsWhatIsInsideTheModel) {
  slide = {{0, 0, 0}, {0.5, 0, 0}, {0, 0, 0.5}, false};
  const auto reddish = [](int r, int g, int b) { return r > g + 30 && r > b + 30; };
  EXPECT_GT(draw(everything()).count(reddish), 100);
}

TEST_F(Picture, HoldsEverythingWhereverItLiesAndHoweverLargeItIs) {
  for (const double size : {1e-6, 1.0, 1e9}) {
    Box far(size);
    for (double& x : far.points) {
      x += 20 * size;
    }
    PictureInput input;
    input.cage_points = far.points;
    input.cage_triangles = far.triangles;
    const Image image = draw(input);
    EXPECT_GT(image.count(blue), 500) << size;
    EXPECT_EQ(image.count(blue, 0, 0.02), 0) << "the margin is not free at size " << size;
    EXPECT_EQ(image.count(blue, 0.98, 1), 0) << "the margin is not free at size " << size;
  }
}

TEST_F(Picture, PutsSeveralViewsSideBySide) {
  // Seen along the slide's plane the ellipse is a line, seen from above a circle.
  const PictureOptions options{480, 240, {View{{0, 0, 1}, {0, 1, 0}}, View{{0, 1, 0}, {0, 0, -1}}}};
  PictureInput input;
  input.slides = {slide};
  input.model_points = model.points;
  input.model_triangles = model.triangles;
  const Image image = draw(input, options);
  const long edge_on = image.count(red, 0, 0.5);
  const long from_above = image.count(red, 0.5, 1);
  EXPECT_GT(edge_on, 50);
  EXPECT_GT(from_above, 2 * edge_on);
}

TEST_F(Picture, ShowsUpAsUpAndTheSideThatTheViewerIsAt) {
  // A mast, 8 high along z, on a board, 4 wide along x.
  PictureInput input;
  Box mast(1), board(1);
  for (std::size_t i = 0; i < mast.points.size(); i += 3) {
    mast.points[i] *= 0.1, mast.points[i + 1] *= 0.1, mast.points[i + 2] = 4 + 4 * mast.points[i + 2];
    board.points[i] *= 2, board.points[i + 1] *= 0.1, board.points[i + 2] *= 0.1;
  }
  input.model_points = mast.points;
  input.model_triangles = mast.triangles;
  input.cage_points = board.points;
  input.cage_triangles = board.triangles;
  const auto drawn = [](int r, int g, int b) { return !white(r, g, b); };
  const auto aspect = [&](const View& view) { return draw(input, {300, 300, {view}}).aspect(drawn); };
  EXPECT_NEAR(aspect({{0, -1, 0}, {0, 0, 1}}), 4 / 8.2, 0.05);
  EXPECT_NEAR(aspect({{0, -2e200, 0}, {0, 0, 3e-200}}), 4 / 8.2, 0.05) << "lengths are of no account";
  EXPECT_NEAR(aspect({{0, -1, 0}, {1, 0, 0}}), 8.2 / 4, 0.1);
  EXPECT_LT(aspect({{1, 0, 0}, {0, 0, 1}}), 0.1) << "the board is seen from its end";
  // Which end is up: the board is below the mast, and above it where -z is up.
  const auto board_height = [&](const View& view) { return draw(input, {300, 300, {view}}).mean_height(blue); };
  EXPECT_LT(board_height({{0, -1, 0}, {0, 0, 1}}), 0.2);
  EXPECT_GT(board_height({{0, -1, 0}, {0, 0, -1}}), 0.8);
}

TEST_F(Picture, DefaultViewTurnsWithUp) {
  const auto near = [](const View& view, const std::array<double, 3>& toward) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(view.toward_viewer[i], toward[i], 1e-12);
  };
  near(default_view({0, 1, 0}), View{}.toward_viewer);
  near(default_view({0, 0, 2}), {0.6, -1.0, 0.35});
  for (const std::array<double, 3> up : {std::array{0., -1., 0.}, {1., 0., 0.}, {-1., 2., 3.}, {0., 0., -1e-300}}) {
    EXPECT_TRUE(is_sound(default_view(up)));
    EXPECT_EQ(default_view(up).up, up);
  }
}

TEST_F(Picture, ViewIsSoundWhereBothDirectionsAreSomeAndNotAlongOneLine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_sound({}));
  EXPECT_TRUE(is_sound({{1e300, 0, 0}, {0, 1e-300, 0}}));
  EXPECT_FALSE(is_sound({{0, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(is_sound({{0, 0, 1}, {0, 0, 0}}));
  EXPECT_FALSE(is_sound({{0, 3, 0}, {0, -1, 0}}));
  EXPECT_FALSE(is_sound({{nan, 0, 1}, {0, 1, 0}}));
  EXPECT_FALSE(is_sound({{0, 0, 1}, {0, inf, 0}}));
}

TEST_F(Picture, IsTheSameBytesEveryTime) {
  const PictureOptions options{160, 120, {View{}}};
  EXPECT_EQ(render_picture(everything(), options), render_picture(everything(), options));
}

TEST_F(Picture, LeavesNoOtherFileBeside) {
  draw(everything());
  EXPECT_EQ(files(), std::vector<std::string>{"out.png"});
}

TEST_F(Picture, NamesTheFileThatItCannotWriteAndLeavesNothing) {
  const PictureOptions options{64, 48, {View{}}};
  fs::create_directory(folder / "taken.png");
  for (const fs::path& path : {folder / "no such folder" / "a.png", folder / "taken.png"}) {
    try {
      write_picture(everything(), options, path);
      ADD_FAILURE() << "nothing was thrown for " << path;
    } catch (const FileError& error) {
      expect_mentions(error.what(), {path.string()});
    }
  }
  EXPECT_EQ(files(), std::vector<std::string>{"taken.png"});
}

TEST_F(Picture, SaysWhatIsMissingWhereThereIsNoDisplay) {
  const DisplayVariable none(nullptr);
  expect_mentions(sentence_of(PictureFault::no_display, [&] { draw(everything()); }),
                  {"DISPLAY is not set", "xvfb-run"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Picture, SaysWhichDisplayDoesNotAnswer) {
  const DisplayVariable stale(":64999");
  expect_mentions(sentence_of(PictureFault::no_display, [&] { draw(everything()); }), {":64999", "xvfb-run"});
  expect_mentions(sentence_of(PictureFault::no_display, [] { require_display(); }), {":64999"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Picture, NamesWhatIsWrongWithItsInput) {
  const auto sentence = [&](const PictureInput& input) {
    return sentence_of(PictureFault::bad_input, [&] { render_picture(input, {64, 48, {View{}}}); });
  };
  expect_mentions(sentence({}), {"nothing to draw"});

  PictureInput input = everything();
  const std::vector<std::uint32_t> wild{0, 1, 8};
  input.cage_triangles = wild;
  expect_mentions(sentence(input), {"cage", "vertex 8", "triangle 0", "8 vertices"});

  input = everything();
  model.points[7] = std::numeric_limits<double>::quiet_NaN();
  expect_mentions(sentence(input), {"model", "not finite", "vertex 2"});

  input = everything();
  input.model_points = input.model_points.first(7);
  expect_mentions(sentence(input), {"model", "rows of three"});

  model = Box{1};
  input = everything();
  input.slides[0].u[1] = std::numeric_limits<double>::infinity();
  expect_mentions(sentence(input), {"slide 0", "not finite"});

  input = everything();
  input.sections[0][3] = std::numeric_limits<double>::quiet_NaN();
  expect_mentions(sentence(input), {"section 0", "not finite"});

  input = {};
  input.slides = {SlideMark{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, false}};
  expect_mentions(sentence(input), {"one point"});
}

TEST_F(Picture, NamesWhatIsWrongWithItsOptions) {
  const auto sentence = [&](const PictureOptions& options) {
    return sentence_of(PictureFault::bad_input, [&] { render_picture(everything(), options); });
  };
  expect_mentions(sentence({0, 600, {View{}}}), {"0 x 600"});
  expect_mentions(sentence({600, 100000, {View{}}}), {"600 x 100000"});
  expect_mentions(sentence({600, 400, {}}), {"0 views"});
  expect_mentions(sentence({600, 400, {View{{0, 0, 0}, {0, 1, 0}}}}), {"view 0", "no direction"});
  expect_mentions(sentence({600, 400, {View{}, View{{0, 2, 0}, {0, 1, 0}}}}), {"view 1", "up"});
}

}  // namespace
}  // namespace cagewright::host
