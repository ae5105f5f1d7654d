// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/done_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace cagewright::host {
namespace {

using nlohmann::json;

constexpr char again[] = ": if that is not meant, undo (Ctrl+Z) and draw right across the limb, or from another side";

// Of one whose plane was tilted, by so many degrees.
std::string tilt_text(double degrees, const SceneSlide& slide) {
  return slide.name + " is tilted by " + std::to_string(std::lround(degrees)) +
         " degrees, for the plane of the stroke itself cuts along the body" + again;
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
  return slide.name + " is " + text + " times as long as the stroke" + again;
}

// What of the cage one would not expect in a file: empty where it is certified, and of the slides as they are.
std::string doubt_text(const Workspace& workspace) {
  const CageState& cage = workspace.cage();
  if (cage.cage.triangles.empty()) return {};
  if (cage.failed) return "the last good cage: the slides as they are now give none";
  if (workspace.plugin() && !cage.is_of_now) return "an older cage: that of the slides as they are now was not made";
  if (!workspace.plugin() && !workspace.stack().undo_label().empty())
    return "the cage that it had: without a plug-in that of the slides as they are now is not made";
  if (cage.certificate && !cage.certificate->encloses) return "a cage that is not certified";
  return {};
}

}  // namespace

std::string done_text(const json& command, const json& said, const Workspace& workspace) {
  const std::string name = command.value("command", "");
  const auto file = [&] { return std::filesystem::path(command.value("path", "")).filename().string(); };
  const auto with_doubt = [&](const std::string& done) {
    const std::string doubt = doubt_text(workspace);
    return doubt.empty() ? done : done + " with " + doubt;
  };
  if (name == "save") return with_doubt("Saved " + workspace.path().filename().string());
  if (name == "save_copy") return "Saved a copy as " + file();
  if (name == "export_cage") {
    const std::string doubt = doubt_text(workspace);
    return doubt.empty() ? "Exported the cage to " + file() : "Exported to " + file() + ": " + doubt;
  }
  if (name == "picture") return "Exported a picture to " + file();
  if (name == "turntable") return "Exported the frames of a turn to " + command.value("folder", "");
  const bool is_across = command.contains("line_of_sight") && command.value("complete", true);
  if (name == "add_slide" && is_across && !workspace.slides().empty()) {
    const SceneSlide& added = *workspace.slides().back();
    return said.contains("tilt") ? tilt_text(said["tilt"], added) : length_text(command["stroke"], added);
  }
  return {};
}

}  // namespace cagewright::host
