// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/workspace/random_commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cagewright::host::test {
namespace {

using Json = nlohmann::json;

struct Box {
  std::array<double, 3> least{}, greatest{};
};

Box box_of(const TriangleMesh& mesh) {
  Box box;
  std::copy_n(mesh.points.begin(), 3, box.least.begin());
  box.greatest = box.least;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    box.least[i % 3] = std::min(box.least[i % 3], mesh.points[i]);
    box.greatest[i % 3] = std::max(box.greatest[i % 3], mesh.points[i]);
  }
  return box;
}

constexpr std::size_t many_slides = 5;  // with more of them most random sets cross one another and have no cage

}  // namespace

const std::set<std::string>& RandomCommands::changing() {
  static const std::set<std::string> names = {
      "add_slide",     "extend_stroke",    "rename_slide", "remove_slides", "duplicate_slides",
      "mirror_slides", "snap_slides",      "change_slide", "change_slides", "paste_slides",
      "set_parameter", "reset_parameters", "undo",         "redo"};
  return names;
}

const std::set<std::string>& RandomCommands::others() {
  static const std::set<std::string> names = {"select_mesh", "copy_slides", "select", "solve", "cancel",     "wait",
                                              "frame",       "look",        "up",     "show",  "projection", "colours"};
  return names;
}

Json RandomCommands::next() {
  static const std::vector<std::string> names = {"add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "add_slide",
                                                 "extend_stroke",
                                                 "extend_stroke",
                                                 "rename_slide",
                                                 "rename_slide",
                                                 "remove_slides",
                                                 "change_slide",
                                                 "duplicate_slides",
                                                 "mirror_slides",
                                                 "snap_slides",
                                                 "snap_slides",
                                                 "change_slide",
                                                 "change_slide",
                                                 "change_slides",
                                                 "change_slides",
                                                 "paste_slides",
                                                 "paste_slides",
                                                 "set_parameter",
                                                 "set_parameter",
                                                 "set_parameter",
                                                 "reset_parameters",
                                                 "undo",
                                                 "undo",
                                                 "redo",
                                                 "redo",
                                                 "select_mesh",
                                                 "copy_slides",
                                                 "select",
                                                 "solve",
                                                 "cancel",
                                                 "wait",
                                                 "frame",
                                                 "look",
                                                 "up",
                                                 "show",
                                                 "projection",
                                                 "colours"};
  std::string chosen = any(names);
  if (workspace_.slides().size() > many_slides && one_in(2)) chosen = "remove_slides";
  Json command = make(chosen);
  command["command"] = chosen;
  if (one_in(5)) spoil(command);
  return command;
}

Json RandomCommands::make(const std::string& chosen) {
  if (chosen == "add_slide") return add_slide();
  if (chosen == "extend_stroke") return extend_stroke();
  if (chosen == "rename_slide") {
    return {{"slide", name()}, {"name", one_in(4) ? name() : Json("renamed " + std::to_string(++names_given_))}};
  }
  if (chosen == "mirror_slides") {
    Json command = {{"slides", names()}, {"axis", any<std::string>({"x", "y", "z"})}};
    if (one_in(2)) command["at"] = number(-1, 1);
    return command;
  }
  if (chosen == "change_slide") return change_slide();
  if (chosen == "change_slides") return {{"slides", listed_ellipses()}, {"label", "move slides"}};
  if (chosen == "paste_slides") return one_in(2) ? Json::object() : Json{{"slides", listed_ellipses()}};
  if (chosen == "set_parameter") return set_parameter();
  if (chosen == "select_mesh") return select_mesh();
  if (chosen == "frame") return {{"what", any<std::string>({"all", "model", "selection"})}};
  if (chosen == "look") return {{"axis", any<std::string>({"front", "top", "perspective"})}};
  if (chosen == "up") return {{"axis", any<std::string>({"y", "z"})}};
  if (chosen == "show") return {{"what", any<std::string>({"cage", "slides"})}, {"on", one_in(2)}};
  if (chosen == "projection") return {{"orthographic", one_in(2)}};
  if (chosen == "colours") return {{"by", any<std::string>({"plain", "parts", "coverage"})}};
  static const std::set<std::string> of_slides = {"remove_slides", "duplicate_slides", "snap_slides", "copy_slides",
                                                  "select"};
  return of_slides.count(chosen) > 0 ? Json{{"slides", names()}} : Json::object();
}

void RandomCommands::spoil(Json& command) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : command.items()) {
    if (key != "command") keys.push_back(key);
  }
  if (keys.empty() || one_in(8)) {
    command["colour"] = "red";
    return;
  }
  Json& argument = command[any(keys)];
  switch (below(5)) {
    case 0:
      command.erase(any(keys));
      return;
    case 1:
      argument = nullptr;
      return;
    case 2:
      if (argument.is_array())
        argument.clear();
      else
        argument = "nobody";
      return;
    case 3:
      argument = argument.is_array() ? Json(Json::array_t(3, Json(1e308))) : Json("");
      return;
    default:
      if (argument.is_array() && !argument.empty() && argument[0].is_string())
        argument.push_back(argument[0]);
      else if (argument.is_array())
        argument = Json::array_t(argument.size(), Json(0.0));
      else
        argument = -1e9;
  }
}

Json RandomCommands::vertex() {
  const std::vector<double>& points = workspace_.mesh().points;
  const std::size_t row = 3 * below(points.size() / 3);
  return {points[row], points[row + 1], points[row + 2]};
}

Json RandomCommands::height() {
  const Box box = box_of(workspace_.mesh());
  const double share = number(0.1, 0.9);
  return {(box.least[0] + box.greatest[0]) / 2, box.least[1] + share * (box.greatest[1] - box.least[1]),
          (box.least[2] + box.greatest[2]) / 2};
}

// u and v across the limb.
Json RandomCommands::radii(double by) {
  const Box box = box_of(workspace_.mesh());
  const double u = by * (box.greatest[0] - box.least[0]) / 2, v = by * (box.greatest[2] - box.least[2]) / 2;
  return {{"u", {u, number(-0.1, 0.1) * u, 0}}, {"v", {0, 0, -v}}};
}

Json RandomCommands::ring(std::size_t count) {
  const Json middle = height(), axes = radii(1);
  const double first = number(0, 2 * std::numbers::pi);
  Json points = Json::array();
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = first + 5.0 * static_cast<double>(k) / static_cast<double>(count);
    Json point = middle;
    for (const std::size_t i : {0, 1, 2}) {
      point[i] = middle[i].get<double>() + std::cos(angle) * axes["u"][i].get<double>() +
                 std::sin(angle) * axes["v"][i].get<double>();
    }
    points.push_back(std::move(point));
  }
  return points;
}

Json RandomCommands::name() {
  const std::vector<const SceneSlide*> slides = workspace_.slides();
  return slides.empty() ? Json("nobody") : Json(any(slides)->name);
}

Json RandomCommands::names() {
  std::vector<const SceneSlide*> slides = workspace_.slides();
  std::shuffle(slides.begin(), slides.end(), random_);
  if (!slides.empty()) slides.resize(1 + below(std::min<std::size_t>(slides.size(), 3)));
  if (slides.size() == 1 && one_in(2)) return slides.front()->name;
  Json names = Json::array();
  for (const SceneSlide* slide : slides) names.push_back(slide->name);
  return names;
}

Json RandomCommands::ellipse() {
  Json given = radii(number(0.9, 1.2));
  given["center"] = height();
  return given;
}

Json RandomCommands::add_slide() {
  Json command;
  switch (below(5)) {
    case 0:
      command = ellipse();
      break;
    case 1:
      command = {{"point", vertex()}, {"normal", {number(-0.2, 0.2), 1, number(-0.2, 0.2)}}};
      break;
    case 2:
      command = {{"point", vertex()}};
      break;
    case 3:
      command = {{"stroke", ring(12)}, {"line_of_sight", {0, 0, -1}}};
      command["stroke"] = {command["stroke"][0], command["stroke"][1]};
      break;
    default:
      command = {{"stroke", ring(4 + below(9))}, {"complete", false}};
  }
  if (one_in(2)) command["name"] = one_in(8) ? name() : Json("cut " + std::to_string(++names_given_));
  return command;
}

// Mostly of a slide that has a stroke.
Json RandomCommands::extend_stroke() {
  std::vector<const SceneSlide*> slides = workspace_.slides();
  std::erase_if(slides, [](const SceneSlide* slide) { return slide->stroke.empty(); });
  const Json slide = slides.empty() || one_in(4) ? name() : Json(any(slides)->name);
  return {{"slide", slide}, {"points", ring(1 + below(3))}};
}

Json RandomCommands::change_slide() {
  Json command = {{"slide", name()}};
  switch (below(5)) {
    case 0:
      command.update(ellipse());
      return command;
    case 1:
      command["move"] = {number(-0.05, 0.05), number(-0.3, 0.3), 0};
      return command;
    case 2:
      command["scale"] = one_in(2) ? Json(number(0.5, 1.5)) : Json{number(0.5, 1.5), number(0.5, 1.5)};
      return command;
    case 3:
      command["turn"] = number(-30, 30);
      command["axis"] = any<Json>({"u", "v", "normal", {1, 0, 1}});
      return command;
    default:
      command["slide"] = names();
      command["move"] = {0, number(-0.1, 0.1), 0};
      command["label"] = "move slides";
      return command;
  }
}

Json RandomCommands::listed_ellipses() {
  Json listed = Json::array();
  Json who = names();
  if (who.is_string()) who = Json::array({who});
  for (const Json& it : who) {
    listed.push_back(ellipse());
    listed.back()["name"] = it;
  }
  return listed;
}

Json RandomCommands::set_parameter() {
  const std::vector<Parameter> parameters = workspace_.plugin()->parameters();
  const Parameter& parameter = any(parameters);
  if (!parameter.choices.empty()) return {{"id", parameter.id}, {"value", any(parameter.choices)}};
  if (parameter.type == CGW_PARAM_REAL) {
    // Not far from where it is, or a random session is one of slow cages.
    return {{"id", parameter.id},
            {"value", parameter.id == "refine.delta" ? number(0, 0.01) : parameter.default_value * number(0.5, 2)}};
  }
  return {{"id", parameter.id}, {"value", std::floor(number(0, std::min(parameter.maximum + 1, 30.0)))}};
}

Json RandomCommands::select_mesh() {
  const SceneMeshNode& node = any(workspace_.document().mesh_nodes());
  return {{"node", one_in(3) ? Json(node.name) : Json(node.node)}};
}

}  // namespace cagewright::host::test
