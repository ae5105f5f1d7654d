// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/external_files.h"

#include <set>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_uri.h"

namespace cagewright::host {
namespace {

// The relative paths that do not lead out of the scene's folder.
std::set<std::filesystem::path> names_inside(const SceneDocument& scene) {
  std::set<std::filesystem::path> names;
  for (const std::string& uri : scene.external_files()) {
    const auto name = relative_path(uri);
    if (!name) continue;
    const std::filesystem::path clean = name->lexically_normal();
    if (*clean.begin() != "..") names.insert(clean);
  }
  return names;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error).parent_path(), error);
}

}  // namespace

std::vector<std::pair<std::filesystem::path, std::string>> external_copies(const SceneDocument& scene,
                                                                           const std::filesystem::path& out) {
  std::vector<std::pair<std::filesystem::path, std::string>> copies;
  const std::filesystem::path from = folder_of(scene.path()), to = folder_of(out);
  if (from == to) return copies;
  for (const std::filesystem::path& name : names_inside(scene)) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(from / name, error)) continue;
    std::string bytes = read_bytes(from / name);
    if (std::filesystem::exists(to / name, error)) {
      if (read_bytes(to / name) == bytes) continue;
      throw FileError(to / name, {},
                      "is another file than " + (from / name).string() + ", which " + out.string() +
                          " needs under this name: write the scene into another folder");
    }
    copies.emplace_back(to / name, std::move(bytes));
  }
  return copies;
}

}  // namespace cagewright::host
