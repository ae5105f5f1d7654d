// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/done_text.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace cagewright::host {

std::string done_text(const nlohmann::json& command, const Workspace& workspace) {
  const std::string name = command.value("command", "");
  const auto file = [&] { return std::filesystem::path(command.value("path", "")).filename().string(); };
  if (name == "save") return "Saved " + workspace.path().filename().string();
  if (name == "save_copy") return "Saved a copy as " + file();
  if (name == "export_cage") return "Exported the cage to " + file();
  if (name == "picture") return "Exported a picture to " + file();
  if (name == "turntable") return "Exported the frames of a turn to " + command.value("folder", "");
  return {};
}

}  // namespace cagewright::host
