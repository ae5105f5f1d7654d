// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_container.h"

#include <cstdint>
#include <limits>

#include "host/file/byte_order.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  return load<std::uint32_t>(bytes.data() + at, std::endian::little);
}

// The chunk's bytes, and the place after it.
std::string_view chunk_at(const std::filesystem::path& path, std::string_view bytes, std::size_t at) {
  if (bytes.size() - at < chunk_header_size) {
    throw FileError(path, Byte{at}, "is cut short: it ends within the header of a chunk");
  }
  const std::uint32_t length = word(bytes, at);
  if (length > bytes.size() - at - chunk_header_size) {
    const bool is_json = at == header_size;
    throw FileError(path, Byte{at},
                    std::string(is_json ? "its JSON" : "its chunk") + " should have " + counted(length, "byte") +
                        ", but only " + std::to_string(bytes.size() - at - chunk_header_size) + " follow");
  }
  if (length % 4 != 0) {
    throw FileError(path, Byte{at},
                    "is not a .glb: a chunk has the length " + std::to_string(length) + ", which is no multiple of 4");
  }
  return bytes.substr(at + chunk_header_size, length);
}

}  // namespace

GltfContainer split_gltf(const std::filesystem::path& path, std::string_view bytes) {
  GltfContainer container;
  if (!bytes.starts_with("glTF")) {
    container.json = bytes;
    return container;
  }
  container.is_binary = true;
  if (bytes.size() < header_size + chunk_header_size) {
    throw FileError(path, {}, "is cut short: it ends within the header of a .glb");
  }
  if (const std::uint32_t version = word(bytes, 4); version != 2) {
    throw FileError(path, Byte{4},
                    "is glTF of version " + in_quotes(std::to_string(version) + ".0") + "; only 2.0 can be read");
  }
  const std::uint32_t length = word(bytes, 8);
  if (length > bytes.size() || length < header_size + chunk_header_size) {
    throw FileError(path, Byte{8},
                    "is cut short: its header promises " + counted(length, "byte") + ", but it has " +
                        std::to_string(bytes.size()));
  }
  if (word(bytes, header_size + 4) != json_chunk) {
    throw FileError(path, Byte{header_size + 4}, "its first chunk is not the JSON of a glTF file");
  }
  const std::string_view inside = bytes.substr(0, length);
  container.json = chunk_at(path, inside, header_size);
  const std::size_t after_json = header_size + chunk_header_size + container.json.size();
  container.chunks = inside.substr(after_json);
  container.trailing = bytes.substr(length);
  for (std::size_t at = after_json; at < inside.size();) at += chunk_header_size + chunk_at(path, inside, at).size();
  return container;
}

GltfJson parse_container_json(const std::filesystem::path& path, const GltfContainer& container) {
  if (!container.is_binary) return parse_gltf_json(path, container.json);
  return parse_gltf_json(path, container.json, header_size + chunk_header_size);
}

std::string join_gltf(const std::filesystem::path& path, const GltfContainer& container, std::string json) {
  if (!container.is_binary) return json;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t size = header_size + chunk_header_size + json.size() + container.chunks.size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw FileError(path, {}, "cannot be written: a .glb cannot be longer than 4 GiB");
  }
  std::string file = "glTF";
  append_little_endian(file, std::uint32_t{2});
  append_little_endian(file, static_cast<std::uint32_t>(size));
  append_little_endian(file, static_cast<std::uint32_t>(json.size()));
  append_little_endian(file, json_chunk);
  file += json;
  file += container.chunks;
  file += container.trailing;
  return file;
}

std::string binary_chunk(const std::string& bytes) {
  std::string chunk;
  if (bytes.empty()) return chunk;
  append_little_endian(chunk, static_cast<std::uint32_t>((bytes.size() + 3) / 4 * 4));
  append_little_endian(chunk, bin_chunk);
  chunk += bytes;
  chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
  return chunk;
}

}  // namespace cagewright::host
