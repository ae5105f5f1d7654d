// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_bytes.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

using Outcome = std::map<std::string, int>;  // how often what was done, so that the test cannot become empty

// Does commands to a document at random; every fourth is one that has to fail. Nothing but `seed` decides.
class RandomEditor {
 public:
  RandomEditor(SceneDocument& document, std::uint32_t seed, Outcome& outcome)
      : document_(document), stack_(document), random_(seed), outcome_(outcome) {}

  void edit() {
    for (std::uint32_t left = 5 + below(36); left > 0; --left) {
      switch (below(8)) {
        case 0:
          ++outcome_[stack_.undo() ? "undo" : "nothing to undo"];
          break;
        case 1:
          ++outcome_[stack_.redo() ? "redo" : "nothing to redo"];
          break;
        case 2:
        case 3:
          expect_refusal();
          break;
        default:
          do_something();
      }
    }
  }

  // The bytes before each command that was taken back, the last one's first.
  std::vector<std::string> undo_all() {
    std::vector<std::string> states;
    while (stack_.undo()) states.push_back(document_.bytes());
    return states;
  }
  // The bytes after each command.
  std::vector<std::string> redo_all() {
    std::vector<std::string> states;
    while (stack_.redo()) states.push_back(document_.bytes());
    return states;
  }

 private:
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_()) % count; }
  template <class Items>
  const auto& any(const Items& items) {
    return items[below(static_cast<std::uint32_t>(items.size()))];
  }

  Slide::Ellipse ellipse() { return some_ellipse(1 + below(1000)); }
  std::vector<Point3> stroke() {
    std::vector<Point3> points(below(5));
    for (Point3& point : points) point = {below(100) / 10.0, -1.0 * below(100), below(1000) / 7.0};
    return points;
  }
  std::string name() {
    const char* names[] = {"knee", "\xc3\xa9lbow", "a \"b\"", "\\", "waist", "\xe8\x86\x9d", "x\ny", "knee.2"};
    return names[below(8)] + std::to_string(below(4));
  }

  void run(const std::string& what, std::unique_ptr<Command> command) {
    try {
      stack_.run(std::move(command));
      ++outcome_[what];
    } catch (const CommandError&) {
      ++outcome_["refused"];  // a name that is taken
    }
  }

  void do_something() {
    const auto& nodes = document_.mesh_nodes();
    const auto& slides = document_.slides();
    const auto& cages = document_.cages();
    const std::uint32_t what = below(7);
    if (what == 1 && !slides.empty()) {
      run("change", std::make_unique<ChangeSlide>(any(slides).id, ellipse(), stroke()));
    } else if (what == 2 && !slides.empty()) {
      run("rename", std::make_unique<RenameSlide>(any(slides).id, name()));
    } else if (what == 3 && !slides.empty()) {
      run("remove slide", std::make_unique<RemoveSlide>(any(slides).id));
    } else if (what == 4 && !cages.empty()) {
      run("remove cage", std::make_unique<RemoveCage>(any(cages).mesh_node));
    } else if (what >= 5 && !nodes.empty()) {
      std::vector<std::int64_t> ids;
      for (const SceneSlide& slide : slides) ids.push_back(slide.id);
      run("set cage", std::make_unique<SetCage>(some_cage(any(nodes).node, ids, below(1000))));
    } else if (!nodes.empty()) {
      run("add", std::make_unique<AddSlide>(any(nodes).node, name(), ellipse(), stroke()));
    }
  }

  std::unique_ptr<Command> wrong_command() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const int node = document_.mesh_nodes().empty() ? 0 : any(document_.mesh_nodes()).node;
    const std::int64_t no_id = -static_cast<std::int64_t>(below(3));
    SceneCage cage = some_cage(node, {}, 1);
    switch (below(9)) {
      case 0:
        return std::make_unique<AddSlide>(-1, name(), ellipse());
      case 1:
        return std::make_unique<AddSlide>(node, "", ellipse());
      case 2:
        return std::make_unique<AddSlide>(node, "flat", Slide::Ellipse{{0, 0, 0}, {1, 0, 0}, {infinity, 0, 0}});
      case 3:
        return std::make_unique<ChangeSlide>(no_id, ellipse());
      case 4:
        return std::make_unique<RenameSlide>(no_id, name());
      case 5:
        return std::make_unique<RemoveSlide>(no_id);
      case 6:
        return std::make_unique<RemoveCage>(-7);
      case 7:
        cage.mesh.triangles.clear();
        return std::make_unique<SetCage>(std::move(cage));
      default:
        cage.mesh.points[2] = 1e300;
        return std::make_unique<SetCage>(std::move(cage));
    }
  }

  void expect_refusal() {
    const std::string before = document_.bytes();
    EXPECT_THROW(stack_.run(wrong_command()), CommandError);
    EXPECT_EQ(document_.bytes(), before);
    ++outcome_["wrong"];
  }

  SceneDocument& document_;
  CommandStack stack_;
  std::mt19937 random_;
  Outcome& outcome_;
};

double distance(const Slide::Ellipse& a, const Slide::Ellipse& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += std::abs(a.center[i] - b.center[i]) + std::abs(a.u[i] - b.u[i]) + std::abs(a.v[i] - b.v[i]);
  }
  return sum;
}

double size(const Slide::Ellipse& a) { return distance(a, {}); }

void expect_same_slides(const SceneDocument& a, const SceneDocument& b) {
  ASSERT_EQ(a.slides().size(), b.slides().size());
  for (const SceneSlide& slide : a.slides()) {
    const SceneSlide* other = b.find_slide(slide.id);
    ASSERT_NE(other, nullptr) << slide.id;
    EXPECT_EQ(slide.name, other->name);
    EXPECT_EQ(slide.mesh_node, other->mesh_node);
    EXPECT_EQ(slide.stroke, other->stroke);
    EXPECT_LE(distance(slide.ellipse, other->ellipse), 1e-12 * size(slide.ellipse));
  }
}

void expect_same_cages(const SceneDocument& a, const SceneDocument& b) {
  ASSERT_EQ(a.cages().size(), b.cages().size());
  for (const SceneCage& cage : a.cages()) {
    const SceneCage* other = b.find_cage(cage.mesh_node);
    ASSERT_NE(other, nullptr) << cage.mesh_node;
    EXPECT_EQ(cage.name, other->name);
    EXPECT_EQ(cage.parameters, other->parameters);
    EXPECT_EQ(cage.slides, other->slides);
    EXPECT_EQ(cage.sections, other->sections);
    EXPECT_EQ(cage.certificate, other->certificate);
    EXPECT_EQ(cage.mesh.triangles, other->mesh.triangles);
    ASSERT_EQ(cage.mesh.points.size(), other->mesh.points.size());
    for (std::size_t i = 0; i < cage.mesh.points.size(); ++i) {
      EXPECT_EQ(static_cast<float>(cage.mesh.points[i]), static_cast<float>(other->mesh.points[i]));
    }
  }
}

void check_sequence(const std::filesystem::path& path, const std::string& file, std::uint32_t seed, Outcome& outcome) {
  SceneDocument document(path, file);
  RandomEditor editor(document, seed, outcome);
  editor.edit();
  editor.redo_all();
  const std::string after = document.bytes();
  const std::vector<std::string> backward = editor.undo_all();
  ASSERT_EQ(document.bytes(), file);
  EXPECT_FALSE(document.is_changed());
  std::vector<std::string> forward = editor.redo_all();
  ASSERT_EQ(document.bytes(), after);
  if (!backward.empty()) {
    forward.pop_back();
    EXPECT_TRUE(std::equal(forward.begin(), forward.end(), backward.rbegin() + 1, backward.rend()))
        << "a state on the way is another one";
  }
  const SceneDocument loaded(path, after);
  EXPECT_EQ(loaded.bytes(), after);
  expect_same_slides(document, loaded);
  expect_same_cages(document, loaded);
}

TEST(CommandSequences, UndoneAndRedoneLeadToTheSameBytes) {
  const auto paths = own_scenes();
  ASSERT_GT(paths.size(), 50u);
  std::vector<std::string> files;
  for (const auto& path : paths) files.push_back(read_bytes(path));
  Outcome outcome;
  for (std::uint32_t seed = 0; seed < 1000 && !HasFatalFailure(); ++seed) {
    const std::size_t row = seed % paths.size();
    SCOPED_TRACE(paths[row].string() + ", seed " + std::to_string(seed));
    check_sequence(paths[row], files[row], seed, outcome);
    if (HasFailure()) return;  // one is enough to look at
  }
  for (const char* what : {"add", "change", "rename", "remove slide", "set cage", "remove cage", "undo", "redo",
                           "wrong", "refused", "nothing to undo", "nothing to redo"}) {
    EXPECT_GT(outcome[what], 50) << what;
  }
}

}  // namespace
}  // namespace cagewright::host::test
