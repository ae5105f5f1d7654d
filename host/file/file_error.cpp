// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/file_error.h"

#include <utility>

namespace cagewright::host {
namespace {

std::string sentence(const std::filesystem::path& path, const FilePlace& place, const std::string& reason) {
  std::string where = path.string();
  if (const auto* line = std::get_if<Line>(&place)) {
    where += ", line " + std::to_string(line->number);
    if (line->column > 0) where += ", column " + std::to_string(line->column);
  }
  if (const auto* byte = std::get_if<Byte>(&place)) where += ", byte " + std::to_string(byte->offset);
  return where + ": " + reason;
}

}  // namespace

FileError::FileError(std::filesystem::path path, FilePlace place, const std::string& reason)
    : std::runtime_error(sentence(path, place, reason)), path_(std::move(path)), place_(place), reason_(reason) {}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

std::string counted(std::size_t count, std::string_view noun) {
  std::string result = std::to_string(count) + " ";
  result += noun;
  if (count == 1) return result;
  if (noun.ends_with("vertex")) return result.replace(result.size() - 2, 2, "ices");
  return result + (noun.ends_with("sh") ? "es" : "s");
}

}  // namespace cagewright::host
