// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/find_plugin.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {

std::filesystem::path find_plugin(const std::optional<std::filesystem::path>& asked) {
  if (asked) return *asked;
  if (const char* path = std::getenv("CAGEWRIGHT_PLUGIN"); path != nullptr && *path != '\0') return path;

  std::error_code error;
  const std::filesystem::path program_folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<std::filesystem::path> folders;
  if (!program_folder.empty()) {
    const std::filesystem::path prefix = program_folder.parent_path();
    folders.push_back(program_folder);
    for (const char* library : {CAGEWRIGHT_LIBRARY_FOLDER, "lib", "lib64"}) {
      folders.push_back(prefix / library / "cagewright");
    }
  }
  folders.push_back(std::filesystem::path(CAGEWRIGHT_FULL_LIBRARY_FOLDER) / "cagewright");

  std::string looked;
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path plugin = folder / "cagewright_plugin.so";
    if (std::filesystem::exists(plugin, error)) return plugin;
    looked += (looked.empty() ? "" : ", ") + folder.string();
  }
  throw PluginLoadError("cagewright_plugin.so is in none of " + looked + "; say where it is with --plugin FILE.so");
}

}  // namespace cagewright::host
