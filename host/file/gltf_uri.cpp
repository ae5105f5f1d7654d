// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_uri.h"

#include <charconv>
#include <string>

namespace cagewright::host {
namespace {

std::string percent_decoded(std::string_view uri) {
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

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<std::filesystem::path> relative_path(std::string_view uri) {
  if (is_data_uri(uri) || uri.find("://") != uri.npos) return {};
  std::string name = percent_decoded(uri);
  // The system's calls would take a name to end at a zero byte.
  if (name.empty() || name.front() == '/' || name.find('\0') != name.npos) return {};
  return name;
}

}  // namespace cagewright::host
