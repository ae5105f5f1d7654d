// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/oracle/oracle.h"

#include <array>
#include <cstdio>
#include <stdexcept>

namespace cagewright {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

}  // namespace

nlohmann::json ask_oracle(const std::string& program, const std::filesystem::path& model,
                          const std::filesystem::path& cage) {
  const std::string command = quoted(program) + " " + quoted(model.string()) + " " + quoted(cage.string());
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the oracle does not start");
  std::string output;
  std::array<char, 4096> bytes;
  while (const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), pipe)) output.append(bytes.data(), got);
  if (::pclose(pipe) != 0) throw std::runtime_error("the oracle failed: " + command);
  return nlohmann::json::parse(output);
}

OracleVerdict::OracleVerdict(const nlohmann::json& answer)
    : closed(answer.at("closed").get<bool>()),
      self_intersecting(answer.at("self_intersecting_pairs").get<std::size_t>()),
      crossing(answer.at("model_triangles_crossing_cage").get<std::size_t>()),
      outside(answer.at("model_vertices_outside").get<std::size_t>()) {}

}  // namespace cagewright
