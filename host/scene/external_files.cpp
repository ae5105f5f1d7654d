// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/external_files.h"

#include <set>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_uri.h"

namespace cagewright::host {
namespace {

std::set<std::filesystem::path> relative_names(const SceneDocument& scene) {
  std::set<std::filesystem::path> names;
  for (const std::string& uri : scene.external_files()) {
    if (const auto name = relative_path(uri)) names.insert(name->lexically_normal());
  }
  return names;
}

bool leads_outside(const std::filesystem::path& name) { return *name.begin() == ".."; }

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
  for (const std::filesystem::path& name : relative_names(scene)) {
    std::error_code error;
    if (leads_outside(name) || !std::filesystem::is_regular_file(from / name, error)) continue;
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

std::vector<std::string> missed_files(const SceneDocument& scene, const std::filesystem::path& out) {
  std::vector<std::string> sentences;
  const std::filesystem::path from = folder_of(scene.path());
  if (from == folder_of(out)) return sentences;
  for (const std::filesystem::path& name : relative_names(scene)) {
    std::error_code error;
    const bool is_there = std::filesystem::is_regular_file(from / name, error);
    if (is_there && !leads_outside(name)) continue;
    sentences.push_back(
        scene.path().string() + ": it names the file " + in_quotes(name.string()) +
        (is_there ? ", which is outside its folder and is not copied: put it beside " + out.string() + " as it is named"
                  : ", which is not there"));
  }
  return sentences;
}

}  // namespace cagewright::host
