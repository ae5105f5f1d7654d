// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace cagewright {

// An independent judge of cages, a program `ORACLE MODEL CAGE` that prints one JSON object; empty where there is none.
inline const std::string oracle = CAGEWRIGHT_ORACLE;

inline constexpr const char* no_oracle =
    "no oracle: configure with -DCAGEWRIGHT_ORACLE_SOURCE=FILE, with CGAL, Boost, GMP and MPFR installed";

// Asks such a program. Throws std::runtime_error where it gives no verdict. Thread-safe.
nlohmann::json ask_oracle(const std::string& program, const std::filesystem::path& model,
                          const std::filesystem::path& cage);

// What it says of the certificate's conditions.
struct OracleVerdict {
  bool closed = false;
  std::size_t self_intersecting = 0;  // pairs of cage triangles, and every degenerate one with itself
  std::size_t crossing = 0;           // model triangles that meet the cage
  std::size_t outside = 0;            // model vertices

  explicit OracleVerdict(const nlohmann::json& answer);
  bool encloses() const { return closed && self_intersecting + crossing + outside == 0; }
};

}  // namespace cagewright
