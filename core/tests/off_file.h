// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/mesh/types.h"

namespace cagewright {

// OFF files of triangles, for tests; points with 17 digits, so that they come back as they were. Both throw
// std::runtime_error, which names the file, where it cannot be read or written.
IndexedMesh read_off(const std::filesystem::path& path);
void write_off(const IndexedMesh& mesh, const std::filesystem::path& path);

// A file of the name in the folder for temporary files, which no other process uses; removed at the end.
class TemporaryOff {
 public:
  TemporaryOff(const IndexedMesh& mesh, const std::string& name);
  ~TemporaryOff();
  TemporaryOff(const TemporaryOff&) = delete;
  TemporaryOff& operator=(const TemporaryOff&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cagewright
