// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/output_files.h"

#include <cerrno>
#include <iostream>
#include <system_error>
#include <utility>
#include <vector>

#include "host/cli/input_error.h"
#include "host/cli/interrupt.h"
#include "host/file/atomic_file.h"

namespace cagewright::host {

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  const auto full = [&](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return full(a) == full(b);
}

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

void flush_standard_output() {
  errno = 0;
  if (std::cout.flush()) return;
  const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  throw InputError("standard output cannot be written" + reason);
}

namespace {

// Folders that had to be made for files; gone again, if empty, where keep() was not called.
class NewFolders {
 public:
  NewFolders() = default;
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;
  ~NewFolders() {
    std::error_code error;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) std::filesystem::remove(*folder, error);
  }
  void make(const std::filesystem::path& folder) {
    std::error_code error;
    if (folder.empty() || std::filesystem::exists(folder, error)) return;
    make(folder.parent_path());
    if (std::filesystem::create_directory(folder, error)) made_.push_back(folder);
  }
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;
};

}  // namespace

void write_files(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
                 const std::function<void()>& sum_up) {
  std::vector<std::filesystem::path> paths;
  for (const auto& [path, bytes] : files) paths.push_back(path);
  require_distinct({}, paths);
  const HeededInterrupts heeded;
  NewFolders folders;
  std::vector<AtomicFile> outputs;
  for (const auto& [path, bytes] : files) {
    folders.make(path.parent_path());
    outputs.emplace_back(path, bytes);
  }
  sum_up();
  flush_standard_output();
  throw_if_interrupted();
  for (AtomicFile& output : outputs) output.commit();
  folders.keep();
  ignore_interrupts();
}

}  // namespace cagewright::host
