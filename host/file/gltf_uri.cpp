// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_uri.h"

#include <algorithm>
#include <cctype>
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

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view scheme = "data:";
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return uri.size() >= scheme.size() &&
         std::equal(scheme.begin(), scheme.end(), uri.begin(), [&](char s, char u) { return same(u, s); });
}

std::optional<std::string_view> base64_of(std::string_view uri) {
  constexpr std::string_view mark = ";base64,";
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == uri.npos || comma + 1 < mark.size() + 5) return {};
  if (uri.substr(comma + 1 - mark.size(), mark.size()) != mark) return {};
  return uri.substr(comma + 1);
}

std::optional<std::filesystem::path> relative_path(std::string_view uri) {
  if (is_data_uri(uri) || uri.find("://") != uri.npos) return {};
  std::string name = percent_decoded(uri);
  // The system's calls would take a name to end at a zero byte.
  if (name.empty() || name.front() == '/' || name.find('\0') != name.npos) return {};
  return name;
}

}  // namespace cagewright::host
