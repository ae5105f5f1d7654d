// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/triangle_mesh.h"

#include <charconv>
#include <fstream>
#include <sstream>
#include <string>

namespace cagewright::testdata {
namespace {

void append(std::string& text, double number) {
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), result.ptr);
}

std::string off_text(const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      append(text, v[axis]);
      text += axis < 2 ? ' ' : '\n';
    }
  }
  for (const auto& [a, b, c] : mesh.triangles)
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  return text;
}

// The file's words, comments left out.
std::istringstream words_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw FileError(file.string() + ": cannot be opened for reading");
  std::string text;
  for (std::string line; std::getline(stream, line);) text += line.substr(0, line.find('#')) + '\n';
  return std::istringstream(text);
}

TriangleMesh read_off(const std::filesystem::path& file) {
  std::istringstream words = words_of(file);
  std::string magic;
  std::size_t vertices = 0, triangles = 0, edges = 0;
  words >> magic >> vertices >> triangles >> edges;
  if (!words || magic != "OFF") throw FileError(file.string() + ": does not begin with OFF and three counts");
  TriangleMesh mesh;
  for (std::size_t i = 0; i < vertices && words; ++i) {
    Eigen::Vector3d& v = mesh.vertices.emplace_back();
    words >> v[0] >> v[1] >> v[2];
  }
  for (std::size_t i = 0; i < triangles && words; ++i) {
    int corners = 0;
    auto& t = mesh.triangles.emplace_back();
    words >> corners >> t[0] >> t[1] >> t[2];
    if (corners != 3) throw FileError(file.string() + ": face " + std::to_string(i) + " is not a triangle");
  }
  if (!words) throw FileError(file.string() + ": ends early, or holds something that is not a finite number");
  return mesh;
}

TriangleMesh read_obj(const std::filesystem::path& file) {
  std::istringstream words = words_of(file);
  TriangleMesh mesh;
  for (std::string kind; words >> kind;) {
    if (kind == "v") {
      Eigen::Vector3d& v = mesh.vertices.emplace_back();
      words >> v[0] >> v[1] >> v[2];
    } else if (kind == "f") {
      auto& t = mesh.triangles.emplace_back();
      words >> t[0] >> t[1] >> t[2];
      for (std::uint32_t& corner : t) --corner;
    } else {
      throw FileError(file.string() + ": '" + kind + "' is neither a vertex nor a triangle");
    }
    if (!words) throw FileError(file.string() + ": '" + kind + "' is not followed by three numbers");
  }
  return mesh;
}

}  // namespace

void write_off(const std::filesystem::path& file, const TriangleMesh& mesh) {
  std::filesystem::path draft = file;
  draft += ".part";
  {
    std::ofstream stream(draft, std::ios::binary);
    stream << off_text(mesh);
    if (!stream.flush()) throw FileError(draft.string() + ": cannot be written; is the folder there and not full?");
  }
  std::error_code error;
  std::filesystem::rename(draft, file, error);
  if (error) throw FileError(file.string() + ": cannot be written: " + error.message());
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  TriangleMesh mesh = file.extension() == ".obj" ? read_obj(file) : read_off(file);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.vertices.size())
        throw FileError(file.string() + ": a triangle names a vertex that is not there");
  return mesh;
}

}  // namespace cagewright::testdata
