// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_buffers.h"

#include <tiny_gltf.h>

#include <string>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_uri.h"

namespace cagewright::host {
namespace {

class BufferReader {
 public:
  BufferReader(const std::filesystem::path& path, const GltfContainer& container, std::size_t index,
               const GltfJson& buffer)
      : path_(path), container_(container), index_(index), buffer_(buffer) {}

  std::vector<unsigned char> read() const {
    const auto length = find_key(buffer_, "byteLength")->get<std::size_t>();
    if (length == 0) return {};
    const GltfJson* uri = find_key(buffer_, "uri");
    std::string holder;
    std::vector<unsigned char> bytes =
        uri ? read_uri(uri->get_ref<const std::string&>(), holder) : read_binary_chunk(holder);
    if (bytes.size() < length) {
      fail("should have " + counted(length, "byte") + ", but " + holder + " has " + std::to_string(bytes.size()) +
           "; export it again");
    }
    bytes.resize(length);  // glTF 2.0, 3.6.1.1: what holds it may be longer
    return bytes;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(path_, {}, "buffer " + std::to_string(index_) + (reason.front() == ':' ? "" : " ") + reason);
  }

  std::vector<unsigned char> read_binary_chunk(std::string& holder) const {
    if (index_ > 0 || !container_.is_binary) fail(": it has no \"uri\" that says where it is; export it again");
    if (container_.binary.data() == nullptr) fail(": the binary chunk that should hold it is missing; export it again");
    holder = "the binary chunk";
    return {container_.binary.begin(), container_.binary.end()};
  }

  std::vector<unsigned char> read_uri(const std::string& uri, std::string& holder) const {
    if (is_data_uri(uri)) {
      std::vector<unsigned char> bytes;
      std::string type;
      const auto text = base64_of(uri);
      // tinygltf knows some media types only; which one it is says nothing of the bytes.
      if (!text || !tinygltf::DecodeDataURI(&bytes, type, "data:application/octet-stream;base64," + std::string(*text),
                                            0, false)) {
        fail(": its data URI " + in_quotes(uri) + " is not base64; export it again");
      }
      holder = "its data URI";
      return bytes;
    }
    const auto name = relative_path(uri);
    if (!name) {
      fail(": it is at " + in_quotes(uri) + ", where it is not looked for; put it beside the file, or export as .glb");
    }
    return read_file(*name, holder);
  }

  std::vector<unsigned char> read_file(const std::filesystem::path& name, std::string& holder) const {
    holder = "the file " + in_quotes(name.string());
    const std::filesystem::path file = std::filesystem::absolute(path_).parent_path() / name;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      throw FileError(path_, {},
                      "its buffer is " + holder +
                          ", which is not there; put it there, as seen from the .gltf, or export the model as .glb");
    }
    try {
      const std::string bytes = read_bytes(file);
      return {bytes.begin(), bytes.end()};
    } catch (const FileError& failure) {
      fail(": " + holder + " " + failure.reason() + "; export the model as .glb");
    }
  }

  const std::filesystem::path& path_;
  const GltfContainer& container_;
  std::size_t index_;
  const GltfJson& buffer_;
};

}  // namespace

std::vector<std::vector<unsigned char>> read_gltf_buffers(const std::filesystem::path& path,
                                                          const GltfContainer& container, const GltfJson& json) {
  std::vector<std::vector<unsigned char>> buffers;
  const GltfJson* items = find_key(json, "buffers");
  for (std::size_t i = 0; items && i < items->size(); ++i) {
    buffers.push_back(BufferReader(path, container, i, (*items)[i]).read());
  }
  return buffers;
}

}  // namespace cagewright::host
