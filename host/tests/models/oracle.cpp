// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/models/oracle.h"

#include <array>
#include <cstdio>
#include <stdexcept>

namespace cagewright::host {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

}  // namespace

std::optional<std::string> why_no_oracle() {
  if (std::string(CAGEWRIGHT_ORACLE).empty()) {
    return "no oracle: configure with -DCAGEWRIGHT_ORACLE_SOURCE=FILE, with CGAL, Boost, GMP and MPFR installed";
  }
  return std::nullopt;
}

nlohmann::json ask_oracle(const std::filesystem::path& model, const std::filesystem::path& cage) {
  const std::string command = quoted(CAGEWRIGHT_ORACLE) + " " + quoted(model.string()) + " " + quoted(cage.string());
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the oracle does not start");
  std::string output;
  std::array<char, 4096> bytes;
  std::size_t got = 0;
  while ((got = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0) output.append(bytes.data(), got);
  if (::pclose(pipe) != 0) throw std::runtime_error("the oracle failed: " + command);
  return nlohmann::json::parse(output);
}

}  // namespace cagewright::host
