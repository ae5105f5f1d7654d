// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_loader.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/file/byte_order.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr int deepest_json = 256;
constexpr std::size_t json_at = 20;  // where it begins in a .glb

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
  if (bytes.size() < json_at) return {};
  return bytes.substr(json_at, load<std::uint32_t>(bytes.data() + 12, std::endian::little));
}

void refuse_version(const std::filesystem::path& path, const std::string& version) {
  if (version.empty() || version.starts_with("2.")) return;
  throw FileError(path, {}, "is glTF of version " + in_quotes(version) + "; only 2.0 can be read");
}

// What the binary header says of the length, tinygltf compares to nothing.
void check_binary_length(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.size() < json_at) throw FileError(path, {}, "is cut short: it ends within the header of a .glb");
  refuse_version(path, std::to_string(load<std::uint32_t>(bytes.data() + 4, std::endian::little)) + ".0");
  const std::uint32_t length = load<std::uint32_t>(bytes.data() + 8, std::endian::little);
  if (length > bytes.size()) {
    throw FileError(path, Byte{8},
                    "is cut short: its header promises " + counted(length, "byte") + ", but it has " +
                        std::to_string(bytes.size()));
  }
  if (bytes.substr(16, 4) != "JSON") throw FileError(path, Byte{16}, "its first chunk is not the JSON of a glTF file");
  const std::uint32_t chunk = load<std::uint32_t>(bytes.data() + 12, std::endian::little);
  if (chunk > bytes.size() - json_at) {
    throw FileError(path, Byte{12},
                    "its JSON should have " + counted(chunk, "byte") + ", but only " +
                        std::to_string(bytes.size() - json_at) + " follow");
  }
}

FilePlace place_of(std::string_view bytes, std::size_t byte) {
  if (bytes.starts_with("glTF")) return Byte{byte};
  const std::string_view before = bytes.substr(0, byte);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  return Line{line, before.size() - (before.rfind('\n') + 1) + 1};  // npos + 1 is 0
}

// Throws FileError where the JSON itself is broken; tinygltf's own words would be those of its parser.
void check_json(const std::filesystem::path& path, std::string_view bytes) {
  const std::string_view json = json_of(bytes);
  const auto begin = static_cast<std::size_t>(json.data() - bytes.data());
  try {
    [[maybe_unused]] const auto parsed = nlohmann::json::parse(json.begin(), json.end());
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, json.size());
    const std::string_view rest = json.substr(at, json.substr(at, 20).find_first_of("\r\n"));
    throw FileError(path, place_of(bytes, begin + at),
                    (at == json.size() ? std::string("its JSON ends in the middle")
                                       : "its JSON is broken at " + in_quotes(rest.substr(0, 20))) +
                        "; export it again");
  } catch (const nlohmann::json::out_of_range& error) {  // "... number overflow parsing '1e999'"
    const std::string message = error.what();
    const std::size_t open = message.find('\''), close = message.rfind('\'');
    const std::string number = open < close ? message.substr(open + 1, close - open - 1) : "";
    throw FileError(path, place_of(bytes, begin + std::min(json.find(number), json.size())),
                    "its JSON holds a number beyond the range of doubles: " + in_quotes(number));
  }
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

// What the callbacks below know of the file.
struct Surroundings {
  std::string folder;        // absolute
  std::string missing_file;  // the last that was looked for there in vain
};

// Buffers are read through these, so that only files beside the .gltf are, and without asking a shell about "~".
bool is_there(const std::string& path, void* user) {
  auto& surroundings = *static_cast<Surroundings*>(user);
  if (!path.starts_with(surroundings.folder)) return false;
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) return true;
  surroundings.missing_file = path.substr(surroundings.folder.size());
  surroundings.missing_file.erase(0, surroundings.missing_file.find_first_not_of('/'));
  return false;
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

  Surroundings surroundings{std::filesystem::absolute(path).parent_path().string(), {}};
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  loader.SetFsCallbacks(
      {is_there, [](const std::string& name, void*) { return name; }, read_whole, nullptr, &surroundings});

  std::string error, warning;
  bool is_good = false;
  try {
    is_good = is_binary ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                      reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                                      surroundings.folder)
                        : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, surroundings.folder);
  } catch (const std::exception& failure) {  // tinygltf indexes some empty arrays with at()
    error += failure.what();
  }
  refuse_version(path, model.asset.version);
  refuse_compression(path, model);
  if (!is_good) check_json(path, bytes);
  if (!is_good && !surroundings.missing_file.empty() && error.find("File not found") != error.npos) {
    throw FileError(path, {},
                    "its buffer is the file " + in_quotes(surroundings.missing_file) +
                        ", which is not there; put it there, as seen from the .gltf, or export the model as .glb");
  }
  // tinygltf reports success though it left out a primitive that it could not parse; its messages tell.
  if (!is_good || !error.empty()) throw FileError(path, {}, "cannot be read as glTF 2.0: " + first_line(error));
}

}  // namespace cagewright::host
