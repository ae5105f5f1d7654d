// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/output_files.h"

#include <utility>

namespace cagewright::host {

void OutputFiles::add(const std::filesystem::path& path, std::string bytes) {
  outputs_.emplace_back(path, std::move(bytes));
}

void OutputFiles::commit() {
  for (Output& output : outputs_) output.file.commit();
}

}  // namespace cagewright::host
