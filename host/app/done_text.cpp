// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/done_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "host/workspace/tilted_plane.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

// Of a slide that is not in the plane that its stroke and the line of sight span.
std::string tilt_text(const json& command, const SceneSlide& slide) {
  const double tilt =
      tilt_of(slide.ellipse, command["stroke"].get<std::vector<Point3>>(), command["line_of_sight"].get<Point3>());
  constexpr double degree = std::numbers::pi / 180;
  if (tilt < degree) return {};
  return slide.name + " is tilted by " + std::to_string(std::lround(tilt / degree)) +
         " degrees: the plane of the stroke itself cuts along the body";
}

// Across a limb that runs along the stroke's plane the loop is the limb's length, not its girth.
std::string length_text(const json& stroke, const SceneSlide& slide) {
  constexpr double long_ratio = 3;  // a short stroke on a thick limb is usual
  const auto from = stroke.front().get<Point3>(), to = stroke.back().get<Point3>();
  const double drawn = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  const auto length = [](const Point3& radius) { return 2 * std::hypot(radius[0], radius[1], radius[2]); };
  const double ratio = std::max(length(slide.ellipse.u), length(slide.ellipse.v)) / drawn;
  if (!(ratio > long_ratio)) return {};
  char text[40];
  std::snprintf(text, sizeof text, "%.1f", ratio);
  return slide.name + " is " + text +
         " times as long as the stroke: if that is not meant, undo and draw right across the limb, or from another "
         "side";
}

}  // namespace

std::string done_text(const nlohmann::json& command, const Workspace& workspace) {
  const std::string name = command.value("command", "");
  const auto file = [&] { return std::filesystem::path(command.value("path", "")).filename().string(); };
  if (name == "save") return "Saved " + workspace.path().filename().string();
  if (name == "save_copy") return "Saved a copy as " + file();
  if (name == "export_cage") return "Exported the cage to " + file();
  if (name == "picture") return "Exported a picture to " + file();
  if (name == "turntable") return "Exported the frames of a turn to " + command.value("folder", "");
  if (name == "add_slide" && command.contains("line_of_sight") && !workspace.slides().empty()) {
    const SceneSlide& added = *workspace.slides().back();
    const std::string tilted = tilt_text(command, added);
    return tilted.empty() ? length_text(command["stroke"], added) : tilted;
  }
  return {};
}

}  // namespace cagewright::host
