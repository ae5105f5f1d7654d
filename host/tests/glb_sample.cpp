// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/glb_sample.h"

#include <cstdint>

#include "host/file/byte_order.h"

namespace cagewright::host {
namespace {

int append(nlohmann::json& array, const nlohmann::json& value) {
  array.push_back(value);
  return static_cast<int>(array.size()) - 1;
}

void append_chunk(std::string& file, std::string bytes, const char* type, char filler) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filler);
  append_little_endian(file, static_cast<std::uint32_t>(bytes.size()));
  file.append(type, 4);
  file += bytes;
}

}  // namespace

GlbSample::GlbSample() {
  json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  json["scenes"][0]["nodes"] = nlohmann::json::array();
}

template <class Number>
int GlbSample::view(const std::vector<Number>& numbers, int stride) {
  binary_.resize((binary_.size() + 3) / 4 * 4);
  const std::size_t offset = binary_.size();
  for (const Number number : numbers) append_little_endian(binary_, number);
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", binary_.size() - offset}};
  if (stride > 0) view["byteStride"] = stride;
  return append(json["bufferViews"], view);
}

template int GlbSample::view(const std::vector<float>&, int);
template int GlbSample::view(const std::vector<std::int8_t>&, int);
template int GlbSample::view(const std::vector<std::int16_t>&, int);
template int GlbSample::view(const std::vector<std::uint8_t>&, int);
template int GlbSample::view(const std::vector<std::uint16_t>&, int);
template int GlbSample::view(const std::vector<std::uint32_t>&, int);

int GlbSample::accessor(int view, int component_type, int count, const std::string& type) {
  return append(json["accessors"],
                {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
}

int GlbSample::mesh(int positions, int indices, int mode) {
  nlohmann::json primitive = {{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
  if (indices >= 0) primitive["indices"] = indices;
  nlohmann::json mesh;
  mesh["primitives"].push_back(primitive);
  return append(json["meshes"], mesh);
}

int GlbSample::node(int mesh) {
  const int node = append(json["nodes"], {{"mesh", mesh}});
  json["scenes"][0]["nodes"].push_back(node);
  return node;
}

void GlbSample::one_triangle() {
  const int positions = accessor(view<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), gl_float, 3, "VEC3");
  node(mesh(positions, accessor(view<std::uint16_t>({0, 1, 2}), gl_ushort, 3, "SCALAR")));
}

std::string GlbSample::bytes() const {
  nlohmann::json whole = json;
  if (!whole.contains("buffers")) whole["buffers"][0]["byteLength"] = binary_.size();
  std::string chunks;
  append_chunk(chunks, whole.dump(), "JSON", ' ');
  append_chunk(chunks, binary_, "BIN\0", '\0');
  std::string file = "glTF";
  append_little_endian(file, std::uint32_t{2});
  append_little_endian(file, static_cast<std::uint32_t>(12 + chunks.size()));
  return file + chunks;
}

}  // namespace cagewright::host
