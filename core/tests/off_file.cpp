// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/off_file.h"

#include <unistd.h>

#include <fstream>
#include <iomanip>
#include <stdexcept>

namespace cagewright {

IndexedMesh read_off(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string magic;
  Eigen::Index points = 0, triangles = 0, corners = 0;
  if (!(file >> magic >> points >> triangles >> corners) || magic != "OFF")
    throw std::runtime_error(path.string() + " is no OFF file that can be read");
  IndexedMesh mesh{Points(points, 3), Triangles(triangles, 3)};
  for (Eigen::Index i = 0; i < mesh.points.size(); ++i) file >> mesh.points.data()[i];
  for (Eigen::Index t = 0; t < triangles; ++t) {
    file >> corners >> mesh.triangles(t, 0) >> mesh.triangles(t, 1) >> mesh.triangles(t, 2);
    if (corners != 3) throw std::runtime_error(path.string() + ": face " + std::to_string(t) + " is no triangle");
  }
  if (!file) throw std::runtime_error(path.string() + " ends early");
  return mesh;
}

void write_off(const IndexedMesh& mesh, const std::filesystem::path& path) {
  std::ofstream file(path);
  file << "OFF\n" << mesh.points.rows() << ' ' << mesh.triangles.rows() << " 0\n" << std::setprecision(17);
  for (const auto& p : mesh.points.rowwise()) file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : mesh.triangles.rowwise()) file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  file.close();
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
}

TemporaryOff::TemporaryOff(const IndexedMesh& mesh, const std::string& name)
    : path_(std::filesystem::temp_directory_path() /
            ("cagewright_" + std::to_string(::getpid()) + "_" + name + ".off")) {
  write_off(mesh, path_);
}

TemporaryOff::~TemporaryOff() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace cagewright
