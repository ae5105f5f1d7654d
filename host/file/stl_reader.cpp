// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <unordered_map>

#include "host/file/byte_order.h"
#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/file/text_scanner.h"

namespace cagewright::host {
namespace {

using Position = std::array<double, 3>;

struct PositionHash {
  std::size_t operator()(const Position& p) const {
    std::uint64_t hash = 0;
    for (const double x : p) {
      hash ^= std::bit_cast<std::uint64_t>(x) + 0x9E3779B97F4A7C15u + (hash << 6) + (hash >> 2);
      hash *= 0xFF51AFD7ED558CCDu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

// Vertices in the order in which they first occur.
class CornerWelder {
 public:
  void reserve(std::size_t triangles) {
    mesh_.triangles.reserve(3 * triangles);
    vertices_.reserve(triangles / 2 + 3);
  }
  void add_corner(Position p) {
    for (double& x : p) x += 0.0;  // -0 and 0 are the same place
    const auto [entry, is_new] = vertices_.try_emplace(p, static_cast<std::uint32_t>(mesh_.vertex_count()));
    if (is_new) mesh_.points.insert(mesh_.points.end(), p.begin(), p.end());
    mesh_.triangles.push_back(entry->second);
  }
  std::size_t triangle_count() const { return mesh_.triangle_count(); }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  TriangleMesh mesh_;
  std::unordered_map<Position, std::uint32_t, PositionHash> vertices_;
};

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

std::uint64_t promised_size(std::string_view bytes) {
  return header_bytes + triangle_bytes * std::uint64_t{load<std::uint32_t>(bytes.data() + 80, std::endian::little)};
}

TriangleMesh read_binary(const std::filesystem::path& path, std::string_view bytes) {
  const std::size_t triangles = (bytes.size() - header_bytes) / triangle_bytes;
  CornerWelder welder;
  welder.reserve(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::size_t first_corner = header_bytes + triangle_bytes * t + 12;  // after the normal
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t offset = first_corner + 12 * corner;
      Position p;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = double{load<float>(bytes.data() + offset + 4 * k, std::endian::little)};
        if (!std::isfinite(p[k])) {
          throw FileError(path, Byte{offset}, "a coordinate of triangle " + std::to_string(t) + " is not finite");
        }
      }
      welder.add_corner(p);
    }
  }
  return welder.take();
}

class AsciiStlReader {
 public:
  AsciiStlReader(const std::filesystem::path& path, std::string_view bytes) : scanner_(bytes, path, {}) {}

  TriangleMesh read() {
    while (scanner_.next_line()) read_solid();
    return welder_.take();
  }

 private:
  void read_solid() {
    expect("solid");
    scanner_.skip_line();  // the name
    while (true) {
      const std::string_view word = scanner_.word("\"endsolid\"");
      if (word == "endsolid") return;
      if (word != "facet") scanner_.fail("\"facet\" or \"endsolid\" should be here, not " + in_quotes(word));
      read_facet();
    }
  }

  void read_facet() {
    scanner_.skip_line();  // the normal: the corners' order says the same, and is always there
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      Position p;
      for (double& x : p) x = scanner_.to_coordinate(scanner_.word("a coordinate"), coordinate_name());
      welder_.add_corner(p);
    }
    expect("endloop");
    expect("endfacet");
  }

  std::string coordinate_name() const { return "a coordinate of triangle " + std::to_string(welder_.triangle_count()); }

  void expect(std::string_view keyword) {
    const std::string name = in_quotes(keyword);
    const std::string_view word = scanner_.word(name);
    if (word != keyword) scanner_.fail(name + " should be here, not " + in_quotes(word));
  }

  TextScanner scanner_;
  CornerWelder welder_;
};

bool begins_with_solid(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != bytes.npos && bytes.substr(begin).starts_with("solid");
}

// Binary files may begin with "solid" too; their size is the better sign.
bool is_binary(const std::filesystem::path& path, std::string_view bytes) {
  const bool has_header = bytes.size() >= header_bytes;
  if (has_header && promised_size(bytes) == bytes.size()) return true;
  const bool has_zero = bytes.substr(0, 1024).find('\0') != bytes.npos;
  if (begins_with_solid(bytes) && !has_zero) return false;
  if (!has_header)
    throw FileError(path, {}, "is not STL: it is no text that begins with \"solid\", and too short to be binary");
  const std::string promise =
      counted(static_cast<std::size_t>((promised_size(bytes) - header_bytes) / triangle_bytes), "triangle") + ", " +
      counted(static_cast<std::size_t>(promised_size(bytes)), "byte");
  throw FileError(
      path, Byte{80},
      "is not STL or damaged: as binary STL it promises " + promise + ", but it has " + std::to_string(bytes.size()));
}

}  // namespace

MeshFile read_stl(const std::filesystem::path& path, std::string_view bytes) {
  MeshFile result{is_binary(path, bytes) ? read_binary(path, bytes) : AsciiStlReader(path, bytes).read(), {}};
  if (result.mesh.triangles.empty()) throw FileError(path, {}, "holds no triangles; a closed surface is needed");
  return result;
}

}  // namespace cagewright::host
