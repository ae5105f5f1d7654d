// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_FIND_PLUGIN_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_FIND_PLUGIN_H

#include <filesystem>
#include <optional>

namespace cagewright::host {

// Where the plug-in is: `asked` (--plugin); else $CAGEWRIGHT_PLUGIN; else the first cagewright_plugin.so that is there,
// beside this program, in ../lib*/cagewright relative to it, or in the library folder that the build was configured
// for. The first two are taken as they are, there or not: who asks for one plug-in must not get another. Throws
// PluginLoadError, naming the folders, where there is none.
std::filesystem::path find_plugin(const std::optional<std::filesystem::path>& asked);

}  // namespace cagewright::host

#endif
