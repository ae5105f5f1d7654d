// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr std::size_t deepest = 256;

// Builds the value from the parser's events, as nlohmann's own builder does not hand over the text of numbers.
class Builder : public nlohmann::json_sax<GltfJson> {
 public:
  Builder(const std::filesystem::path& path, std::string_view text, std::optional<std::size_t> first_byte)
      : path_(path), text_(text), first_byte_(first_byte) {}

  GltfJson result;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  // The parser gives whole numbers with a sign here, so a zero is -0.
  bool number_integer(number_integer_t value) override { return value == 0 ? add_text("-0") : add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& text) override {
    if (GltfJson(value).dump() == text) return add(value);
    return add_text(text);
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // JSON text has none
  bool start_object(std::size_t) override { return open(GltfJson::object()); }
  bool start_array(std::size_t) override { return open(GltfJson::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    if (!open_.back().keys.insert(value).second) {
      throw FileError(path_, {}, "has the key " + in_quotes(value) + " twice in one object of its JSON; take one out");
    }
    open_.back().key = std::move(value);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    const std::size_t at = std::min(position > 0 ? position - 1 : 0, text_.size());
    if (error.id == 406) {  // out of range
      const std::size_t begin = at >= token.size() ? text_.rfind(token, at) : 0;
      fail_at(begin == text_.npos ? at : begin,
              "its JSON holds a number beyond the range of doubles: " + in_quotes(token) + "; export it again");
    }
    if (at == text_.size()) fail_at(at, "its JSON ends in the middle; export it again");
    const std::string_view rest = text_.substr(at, text_.substr(at, 20).find_first_of("\r\n"));
    fail_at(at, "its JSON is broken at " + in_quotes(rest.substr(0, 20)) + "; export it again");
  }

 private:
  struct Container {
    GltfJson value;
    std::string key;
    std::unordered_set<std::string> keys;
  };

  [[noreturn]] void fail_at(std::size_t byte, const std::string& reason) const {
    if (first_byte_) throw FileError(path_, Byte{*first_byte_ + byte}, reason);
    const std::string_view before = text_.substr(0, byte);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    throw FileError(path_, Line{line, before.size() - (before.rfind('\n') + 1) + 1}, reason);  // npos + 1 is 0
  }

  bool add(GltfJson value) {
    if (open_.empty()) {
      result = std::move(value);
    } else if (open_.back().value.is_array()) {
      open_.back().value.push_back(std::move(value));
    } else {
      // The key is known to be new, and ordered_map's own insertion would look through all of them.
      auto& pairs = static_cast<GltfJson::object_t::Container&>(open_.back().value.get_ref<GltfJson::object_t&>());
      pairs.emplace_back(std::move(open_.back().key), std::move(value));
    }
    return true;
  }
  bool add_text(std::string_view number) {
    return add(GltfJson::binary(std::vector<std::uint8_t>(number.begin(), number.end())));
  }
  bool open(GltfJson value) {
    if (open_.size() == deepest) {
      throw FileError(path_, {}, "its JSON is nested too deeply; " + std::to_string(deepest) + " levels can be read");
    }
    open_.push_back({std::move(value), {}, {}});
    return true;
  }
  bool close() {
    GltfJson value = std::move(open_.back().value);
    open_.pop_back();
    return add(std::move(value));
  }

  const std::filesystem::path& path_;
  std::string_view text_;
  std::optional<std::size_t> first_byte_;
  std::vector<Container> open_;
};

class Writer {
 public:
  explicit Writer(int indent) : indent_(indent) {}

  std::string text;

  void write(const GltfJson& json, int level) {
    if (json.is_object()) {
      write_items(json, '{', '}', level, [&](const auto& item) {
        text += GltfJson(item.key()).dump();
        text += indent_ < 0 ? ":" : ": ";
        write(item.value(), level + 1);
      });
    } else if (json.is_array()) {
      write_items(json, '[', ']', level, [&](const auto& item) { write(item.value(), level + 1); });
    } else if (json.is_binary()) {
      text.append(json.get_binary().begin(), json.get_binary().end());
    } else {
      text += json.dump();
    }
  }

 private:
  template <typename WriteItem>
  void write_items(const GltfJson& json, char open, char close, int level, const WriteItem& write_item) {
    text += open;
    bool is_first = true;
    for (const auto& item : json.items()) {
      if (!is_first) text += ',';
      is_first = false;
      break_line(level + 1);
      write_item(item);
    }
    if (!json.empty()) break_line(level);
    text += close;
  }
  void break_line(int level) {
    if (indent_ < 0) return;
    text += '\n';
    text.append(static_cast<std::size_t>(level * indent_), ' ');
  }

  int indent_;
};

}  // namespace

GltfJson parse_gltf_json(const std::filesystem::path& path, std::string_view text,
                         std::optional<std::size_t> first_byte) {
  Builder builder(path, text, first_byte);
  GltfJson::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder.result);
}

std::string gltf_json_text(const GltfJson& json, int indent) {
  Writer writer(indent);
  writer.write(json, 0);
  return std::move(writer.text);
}

std::optional<double> number_in(const GltfJson& json) {
  if (json.is_number()) return json.get<double>();
  if (!json.is_binary()) return {};
  const auto& kept = json.get_binary();
  const char* begin = reinterpret_cast<const char*>(kept.data());
  double value = 0;
  const auto [end, error] = std::from_chars(begin, begin + kept.size(), value);
  if (end != begin + kept.size() || !std::isfinite(value)) return {};
  // Of numbers too small for a double from_chars says that they are out of range, and the nearest is zero.
  return error == std::errc() ? value : std::copysign(0.0, *begin == '-' ? -1.0 : 1.0);
}

std::optional<int> index_in(const GltfJson* json) {
  if (json == nullptr || !json->is_number_integer()) return {};
  return json->get<int>();
}

const GltfJson* find_key(const GltfJson& json, std::string_view key) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(std::string(key));
  return found == json.end() ? nullptr : &*found;
}

GltfJson* find_key(GltfJson& json, std::string_view key) {
  return const_cast<GltfJson*>(find_key(std::as_const(json), key));
}

}  // namespace cagewright::host
