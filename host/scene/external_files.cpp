// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/external_files.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

// RFC 3986, 2.1: %20 for a space.
std::string percent_decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      text += static_cast<char>(value);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool is_inside(const std::filesystem::path& name) {
  if (name.empty() || name.is_absolute() || name.string().find("://") != std::string::npos) return false;
  const std::filesystem::path clean = name.lexically_normal();
  return clean.begin() != clean.end() && *clean.begin() != "..";
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
  std::vector<std::string> names = scene.external_files();
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& uri : names) {
    const std::filesystem::path name = percent_decoded(uri);
    std::error_code error;
    if (!is_inside(name) || !std::filesystem::is_regular_file(from / name, error)) continue;
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
