// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/output_files.h"

#include <system_error>
#include <utility>

#include "host/cli/input_error.h"

#include <utility>

namespace cagewright::host {
namespace {

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  const auto full = [&](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return full(a) == full(b);
}

}  // namespace

void require_distinct(const std::vector<std::filesystem::path>& inputs,
                      const std::vector<std::filesystem::path>& outputs) {
  std::vector<std::filesystem::path> taken = inputs;
  for (const std::filesystem::path& output : outputs) {
    for (const std::filesystem::path& other : taken) {
      if (same_file(output, other)) throw UsageError(output.string() + " is named twice; it would be overwritten");
    }
    taken.push_back(output);
  }
}

void OutputFiles::add(const std::filesystem::path& path, std::string bytes) {
  outputs_.emplace_back(path, std::move(bytes));
}

void OutputFiles::commit() {
  for (Output& output : outputs_) output.file.commit();
}

}  // namespace cagewright::host
