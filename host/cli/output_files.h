// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_OUTPUT_FILES_H
#define CAGEWRIGHT_HOST_CLI_OUTPUT_FILES_H

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cagewright::host {

// Whether both name the same place, under whatever spelling.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// Throws UsageError where an output would overwrite an input or another output, under whatever spelling.
void require_distinct(const std::vector<std::filesystem::path>& inputs,
                      const std::vector<std::filesystem::path>& outputs);

// Ends what was printed on standard output so far. Throws InputError where it cannot be written: a full disk, a pipe
// that nobody reads. To be called before files get their names, so that a run fails as a whole.
void flush_standard_output();

// Writes the files that a run makes, in folders that are made where they are not there, and what `sum_up` prints on
// standard output: all files are wholly on disk under temporary names and the summary is out before the first file gets
// its own, so that a run that fails or is interrupted (host/cli/interrupt.h) leaves none. Afterwards interrupts are
// ignored. Throws UsageError where two files have the same place, FileError (files that already have their names keep
// them), InputError and Cancelled.
void write_files(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
                 const std::function<void()>& sum_up);

}  // namespace cagewright::host

#endif
