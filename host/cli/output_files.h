// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_OUTPUT_FILES_H
#define CAGEWRIGHT_HOST_CLI_OUTPUT_FILES_H

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "host/file/atomic_file.h"

namespace cagewright::host {

// Throws UsageError where an output would overwrite an input or another output, under whatever spelling.
void require_distinct(const std::vector<std::filesystem::path>& inputs,
                      const std::vector<std::filesystem::path>& outputs);

// The files that a run makes: all are wholly on disk under temporary names before the first gets its own, so that a
// run that fails leaves none.
class OutputFiles {
 public:
  // Throws FileError.
  void add(const std::filesystem::path& path, std::string bytes);
  // Throws FileError; files that already have their names keep them.
  void commit();

 private:
  struct Output {
    Output(const std::filesystem::path& path, std::string content) : bytes(std::move(content)), file(path, bytes) {}
    std::string bytes;
    AtomicFile file;
  };
  std::list<Output> outputs_;  // a list, as AtomicFile borrows the bytes
};

}  // namespace cagewright::host

#endif
