// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "host/file/byte_order.h"
#include "host/file/file_error.h"
#include "host/file/mesh_writer.h"

namespace cagewright::host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int unsigned_short = 5123, unsigned_int = 5125, float_type = 5126;  // glTF's component types
constexpr int array_buffer = 34962, element_array_buffer = 34963, triangles_mode = 4;

// Chunks begin and end at multiples of 4 bytes.
void pad(std::string& bytes, char filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

void append_chunk(std::string& file, std::uint32_t type, const std::string& bytes) {
  append_little_endian(file, static_cast<std::uint32_t>(bytes.size()));
  append_little_endian(file, type);
  file += bytes;
}

struct Positions {
  std::string bytes;
  std::array<float, 3> least{}, most{};
};

Positions float_positions(const TriangleMesh& mesh, const std::filesystem::path& path) {
  Positions result;
  result.least.fill(std::numeric_limits<float>::infinity());
  result.most.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (std::abs(mesh.points[i]) > double{std::numeric_limits<float>::max()}) {
      throw FileError(path, {},
                      "cannot be written: vertex " + std::to_string(i / 3) + " is too far out for glTF's floats");
    }
    const auto x = static_cast<float>(mesh.points[i]);
    append_little_endian(result.bytes, x);
    result.least[i % 3] = std::min(result.least[i % 3], x);
    result.most[i % 3] = std::max(result.most[i % 3], x);
  }
  return result;
}

// 65535 is the restart value of 16-bit indices and not allowed.
bool fits_short(const TriangleMesh& mesh) { return mesh.vertex_count() <= 65535; }

std::string index_bytes(const TriangleMesh& mesh) {
  std::string bytes;
  for (const std::uint32_t index : mesh.triangles) {
    if (fits_short(mesh)) {
      append_little_endian(bytes, static_cast<std::uint16_t>(index));
    } else {
      append_little_endian(bytes, index);
    }
  }
  return bytes;
}

Json document(const TriangleMesh& mesh, const std::string& name, const Positions& positions, std::size_t index_size) {
  const std::size_t position_size = positions.bytes.size();
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "Cagewright"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
  json["nodes"] = Json::array({{{"name", name}, {"mesh", 0}}});
  const Json primitive = {{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", triangles_mode}};
  json["meshes"] = Json::array({{{"name", name}, {"primitives", Json::array({primitive})}}});
  json["accessors"] = Json::array({{{"bufferView", 0},
                                    {"componentType", float_type},
                                    {"count", mesh.vertex_count()},
                                    {"type", "VEC3"},
                                    {"min", positions.least},
                                    {"max", positions.most}},
                                   {{"bufferView", 1},
                                    {"componentType", fits_short(mesh) ? unsigned_short : unsigned_int},
                                    {"count", mesh.triangles.size()},
                                    {"type", "SCALAR"}}});
  json["bufferViews"] = Json::array(
      {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", position_size}, {"target", array_buffer}},
       {{"buffer", 0}, {"byteOffset", position_size}, {"byteLength", index_size}, {"target", element_array_buffer}}});
  json["buffers"] = Json::array({{{"byteLength", position_size + index_size}}});
  return json;
}

}  // namespace

std::string glb_bytes(const TriangleMesh& mesh, const std::string& name, const std::filesystem::path& path) {
  if (mesh.triangles.empty()) throw FileError(path, {}, "cannot be written: the mesh has no triangles");
  const Positions positions = float_positions(mesh, path);
  const std::string indices = index_bytes(mesh);
  std::string json =
      document(mesh, name, positions, indices.size()).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string binary = positions.bytes + indices;
  pad(json, ' ');
  pad(binary, '\0');
  const std::size_t size = 12 + 8 + json.size() + 8 + binary.size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw FileError(path, {}, "cannot be written: a .glb cannot be longer than 4 GiB");
  }
  std::string file = "glTF";
  append_little_endian(file, std::uint32_t{2});
  append_little_endian(file, static_cast<std::uint32_t>(size));
  append_chunk(file, 0x4E4F534A, json);    // "JSON"
  append_chunk(file, 0x004E4942, binary);  // "BIN"
  return file;
}

}  // namespace cagewright::host
