// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace cagewright::testdata {

class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise as seen from outside
};

// Writes an ASCII .off file whose numbers read back to the same bits. The file appears whole or not at all.
// Throws FileError, naming the file.
void write_off(const std::filesystem::path& file, const TriangleMesh& mesh);

// Reads .off or .obj files as plain as the ones of this folder: triangles only, no normals, no colours; `#` starts a
// comment. Vertices stay as they are: none is welded or dropped. Throws FileError, naming the file.
TriangleMesh read_mesh(const std::filesystem::path& file);

}  // namespace cagewright::testdata
