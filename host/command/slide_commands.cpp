// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/slide_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/command/utf8.h"
#include "host/file/file_error.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

const SceneSlide& slide_of(const SceneDocument& document, std::int64_t id) {
  const SceneSlide* slide = document.find_slide(id);
  if (slide == nullptr) throw CommandError("there is no slide with the id " + std::to_string(id));
  return *slide;
}

void check_name(const SceneDocument& document, int mesh_node, const std::string& name, std::int64_t except) {
  if (name.empty()) throw CommandError("a slide needs a name");
  if (!is_utf8(name)) throw CommandError("the slide name " + in_quotes(name) + " is not UTF-8: choose another name");
  const auto taken = [&](const SceneSlide& slide) {
    return slide.mesh_node == mesh_node && slide.id != except && slide.name == name;
  };
  if (std::any_of(document.slides().begin(), document.slides().end(), taken)) {
    throw CommandError("there is a slide " + in_quotes(name) + " under the same mesh already: choose another name");
  }
}

void check_ellipse(const std::string& name, const Slide::Ellipse& e) {
  const Eigen::Vector3d u = Eigen::Vector3d::Map(e.u.data()), v = Eigen::Vector3d::Map(e.v.data());
  const Eigen::Vector3d cross = u.cross(v);
  const bool is_good = Eigen::Vector3d::Map(e.center.data()).allFinite() && u.allFinite() && v.allFinite() &&
                       cross.allFinite() && cross.stableNorm() > 0 && decompose(slide_transform(e));
  if (!is_good) {
    throw CommandError("slide " + in_quotes(name) +
                       ": its ellipse needs a finite centre and two finite radii that are not parallel");
  }
}

void check_stroke(const std::string& name, const std::vector<Point3>& stroke) {
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    if (std::all_of(stroke[i].begin(), stroke[i].end(), [](double value) { return std::isfinite(value); })) continue;
    throw CommandError("slide " + in_quotes(name) + ": point " + std::to_string(i) +
                       " of its stroke is not finite: draw it again");
  }
}

// The last digits that a file will have: or the cage of a scene that is opened again is another one.
void round_as_stored(SceneSlide& slide) {
  slide.numbers.reset();
  const auto stored = as_stored(slide.ellipse);
  if (!stored) return;
  slide.numbers = stored->numbers;
  slide.ellipse = stored->ellipse;
}

}  // namespace

AddSlide::AddSlide(int mesh_node, std::string name, const Slide::Ellipse& ellipse, std::vector<Point3> stroke) {
  slide_.mesh_node = mesh_node;
  slide_.name = std::move(name);
  slide_.ellipse = ellipse;
  slide_.stroke = std::move(stroke);
}
std::string AddSlide::label() const { return "add slide " + in_quotes(slide_.name); }
void AddSlide::doIt(SceneDocument& document) {
  const auto& nodes = document.mesh_nodes();
  const auto is_it = [this](const SceneMeshNode& node) { return node.node == slide_.mesh_node; };
  if (std::none_of(nodes.begin(), nodes.end(), is_it)) {
    throw CommandError("node " + std::to_string(slide_.mesh_node) + " has no mesh to cut: choose one that has");
  }
  check_name(document, slide_.mesh_node, slide_.name, 0);
  check_ellipse(slide_.name, slide_.ellipse);
  check_stroke(slide_.name, slide_.stroke);
  round_as_stored(slide_);
  slide_.id = document.new_slide_id();
  redoIt(document);
}
void AddSlide::undoIt(SceneDocument& document) { document.remove_slide(slide_.id); }
void AddSlide::redoIt(SceneDocument& document) { document.insert_slide(document.slides().size(), slide_); }

ChangeSlide::ChangeSlide(std::int64_t id, const Slide::Ellipse& ellipse, std::vector<Point3> stroke)
    : id_(id), ellipse_(ellipse), stroke_(std::move(stroke)) {}
std::string ChangeSlide::label() const { return "change slide " + in_quotes(before_.name); }
void ChangeSlide::doIt(SceneDocument& document) {
  before_ = slide_of(document, id_);
  check_ellipse(before_.name, ellipse_);
  check_stroke(before_.name, stroke_);
  redoIt(document);
}
void ChangeSlide::undoIt(SceneDocument& document) { document.replace_slide(before_); }
void ChangeSlide::redoIt(SceneDocument& document) {
  SceneSlide after = before_;
  after.ellipse = ellipse_;
  after.stroke = stroke_;
  round_as_stored(after);
  document.replace_slide(std::move(after));
}

RenameSlide::RenameSlide(std::int64_t id, std::string name) : id_(id), name_(std::move(name)) {}
std::string RenameSlide::label() const { return "rename slide " + in_quotes(before_); }
void RenameSlide::doIt(SceneDocument& document) {
  const SceneSlide& slide = slide_of(document, id_);
  check_name(document, slide.mesh_node, name_, id_);
  before_ = slide.name;
  redoIt(document);
}
void RenameSlide::undoIt(SceneDocument& document) {
  SceneSlide slide = slide_of(document, id_);
  slide.name = before_;
  document.replace_slide(std::move(slide));
}
void RenameSlide::redoIt(SceneDocument& document) {
  SceneSlide slide = slide_of(document, id_);
  slide.name = name_;
  document.replace_slide(std::move(slide));
}

RemoveSlide::RemoveSlide(std::int64_t id) : id_(id) {}
std::string RemoveSlide::label() const { return "remove slide " + in_quotes(removed_.name); }
void RemoveSlide::doIt(SceneDocument& document) {
  removed_ = slide_of(document, id_);
  row_ = static_cast<std::size_t>(document.find_slide(id_) - document.slides().data());
  redoIt(document);
}
void RemoveSlide::undoIt(SceneDocument& document) { document.insert_slide(row_, removed_); }
void RemoveSlide::redoIt(SceneDocument& document) { document.remove_slide(id_); }

}  // namespace cagewright::host
