// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_loader.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "host/file/byte_order.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr int deepest_json = 256;

// tinygltf descends recursively into extras and extensions; what is too deep would overflow the stack.
void check_depth(const std::filesystem::path& path, std::string_view json) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > deepest_json) throw FileError(path, {}, "its JSON is nested too deeply");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

// The JSON of the file: its first chunk where it is binary.
std::string_view json_of(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < 20) return {};
  return bytes.substr(20, load<std::uint32_t>(bytes.data() + 12, std::endian::little));
}

void refuse_version(const std::filesystem::path& path, const std::string& version) {
  if (version.empty() || version.starts_with("2.")) return;
  throw FileError(path, {}, "is glTF of version " + in_quotes(version) + "; only 2.0 can be read");
}

// What the binary header says of the length, tinygltf compares to nothing.
void check_binary_length(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.size() < 20) throw FileError(path, {}, "is cut short: it ends within the header of a .glb");
  refuse_version(path, std::to_string(load<std::uint32_t>(bytes.data() + 4, std::endian::little)) + ".0");
  const std::uint32_t length = load<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (length <= bytes.size()) return;
  throw FileError(path, Byte{8},
                  "is cut short: its header promises " + std::to_string(length) + " bytes, but it has " +
                      std::to_string(bytes.size()));
}

// tinygltf's messages are one or more lines; the first says it.
std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \r\n");
  if (begin == text.npos) return "unknown reason";
  std::string line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
  for (char& c : line) {
    if (c < ' ' || c > '~') c = '?';
  }
  return line.size() > 200 ? line.substr(0, 200) + "..." : line;
}

// Buffers are read through these, so that only files beside the .gltf are, and without asking a shell about "~".
bool is_there(const std::string& path, void* folder) {
  std::error_code error;
  return path.starts_with(*static_cast<const std::string*>(folder)) && std::filesystem::is_regular_file(path, error);
}

bool is_image(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 6> endings = {".png", ".jpg", ".jpeg", ".webp", ".ktx2", ".dds"};
  return std::find(endings.begin(), endings.end(), lower_ending(path)) != endings.end();
}

bool read_whole(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
  try {
    const std::string bytes = is_image(path) ? " " : read_bytes(path);
    out->assign(bytes.begin(), bytes.end());
    return true;
  } catch (const FileError& failure) {
    *error = failure.reason();
    return false;
  }
}

bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

void refuse_compression(const std::filesystem::path& path, const tinygltf::Model& model) {
  for (const std::string& extension : model.extensionsRequired) {
    if (extension == "KHR_draco_mesh_compression") {
      throw FileError(path, {},
                      "its meshes are compressed with Draco, which cannot be read; export it without compression");
    }
    if (extension == "EXT_meshopt_compression") {
      throw FileError(path, {},
                      "its meshes are compressed with meshopt, which cannot be read; export it without compression");
    }
  }
}

}  // namespace

void load_gltf(const std::filesystem::path& path, std::string_view bytes, tinygltf::Model& model) {
  const bool is_binary = bytes.starts_with("glTF");
  if (is_binary) check_binary_length(path, bytes);
  check_depth(path, json_of(bytes));
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) throw FileError(path, {}, "is longer than 4 GiB");
  const auto size = static_cast<unsigned int>(bytes.size());

  std::string folder = std::filesystem::absolute(path).parent_path().string();
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  loader.SetFsCallbacks({is_there, [](const std::string& name, void*) { return name; }, read_whole, nullptr, &folder});

  std::string error, warning;
  bool is_good = false;
  try {
    is_good = is_binary
                  ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                  : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
  } catch (const std::exception& failure) {  // tinygltf indexes some empty arrays with at()
    error += failure.what();
  }
  refuse_version(path, model.asset.version);
  refuse_compression(path, model);
  // tinygltf reports success though it left out a primitive that it could not parse; its messages tell.
  if (!is_good || !error.empty()) throw FileError(path, {}, "cannot be read as glTF 2.0: " + first_line(error));
}

}  // namespace cagewright::host
