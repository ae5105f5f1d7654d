// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_container.h"

#include <cstdint>
#include <limits>

#include "host/file/byte_order.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::string_view magic = "glTF";
constexpr char cut_in_header[] = "is cut short: it ends within the header of a .glb; copy or export it again";
constexpr std::uint32_t json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  return load<std::uint32_t>(bytes.data() + at, std::endian::little);
}

// A .glb cut into chunks; `bytes` end where its header says.
class Chunks {
 public:
  Chunks(const std::filesystem::path& path, std::string_view bytes, bool has_trailing_bytes)
      : path_(path), bytes_(bytes), has_trailing_bytes_(has_trailing_bytes) {}

  bool at_end() const { return next_ == bytes_.size(); }
  std::size_t next() const { return next_; }

  // What the next one holds.
  std::string_view take() {
    const std::size_t at = next_;
    if (bytes_.size() - at < chunk_header_size) fail("is cut short: it ends within the header of a chunk" + context());
    const std::size_t length = word(bytes_, at), left = bytes_.size() - at - chunk_header_size;
    if (length > left) {
      fail(std::string(at == header_size ? "its JSON" : "its chunk") + " should have " + counted(length, "byte") +
           ", but only " + std::to_string(left) + " follow" + context());
    }
    if (length % 4 != 0) {
      fail("is not a .glb: a chunk has the length " + std::to_string(length) + ", which is no multiple of 4");
    }
    before_ = at;
    next_ = at + chunk_header_size + length;
    return bytes_.substr(at + chunk_header_size, length);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(path_, Byte{next_}, reason + "; export it again");
  }

  // Where a length goes wrong, one that was read before may be the wrong one.
  std::string context() const {
    if (has_trailing_bytes_) return ", up to the end that byte 8 gives";
    return before_ > 0 ? ", after the chunk at byte " + std::to_string(before_) : "";
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  bool has_trailing_bytes_;
  std::size_t next_ = header_size, before_ = 0;
};

// What has no "glTF" in front is JSON, if it is anything.
void refuse_other_formats(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.empty()) throw FileError(path, {}, "is empty; export it again");
  if (lower_ending(path) != ".glb") return;
  if (magic.starts_with(bytes)) throw FileError(path, {}, cut_in_header);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first != bytes.npos && bytes[first] == '{') return;
  throw FileError(
      path, {},
      "is not a .glb: its first bytes are " + in_quotes(bytes.substr(0, 4)) + " instead of \"glTF\"; export it again");
}

}  // namespace

GltfContainer split_gltf(const std::filesystem::path& path, std::string_view bytes) {
  GltfContainer container;
  if (!bytes.starts_with(magic)) {
    refuse_other_formats(path, bytes);
    container.json = bytes;
    return container;
  }
  container.is_binary = true;
  if (bytes.size() < header_size + chunk_header_size) {
    throw FileError(path, {}, cut_in_header);
  }
  if (const std::uint32_t version = word(bytes, 4); version != 2) {
    throw FileError(path, Byte{4},
                    "is glTF of version " + in_quotes(std::to_string(version) + ".0") +
                        "; only 2.0 can be read: export it as that");
  }
  const std::uint32_t length = word(bytes, 8);
  if (length > bytes.size() || length < header_size + chunk_header_size) {
    throw FileError(path, Byte{8},
                    "is cut short: its header promises " + counted(length, "byte") + ", but it has " +
                        std::to_string(bytes.size()) + "; copy or export it again");
  }
  if (word(bytes, header_size + 4) != json_chunk) {
    throw FileError(path, Byte{header_size + 4}, "its first chunk is not the JSON of a glTF file; export it again");
  }
  const std::string_view inside = bytes.substr(0, length);
  container.trailing = bytes.substr(length);
  Chunks chunks(path, inside, !container.trailing.empty());
  container.json = chunks.take();
  if (container.json.empty()) throw FileError(path, Byte{header_size}, "its JSON is empty; export it again");
  container.chunks = inside.substr(chunks.next());
  while (!chunks.at_end()) {
    const std::size_t at = chunks.next();
    const std::string_view content = chunks.take();
    const bool is_first = inside.size() - at == container.chunks.size();
    if (is_first && word(inside, at + 4) == bin_chunk) container.binary = content;
  }
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
  std::string file(magic);
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
