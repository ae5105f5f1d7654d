// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/strict_json.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

using Json = nlohmann::json;

// The containers that are open while the parser goes on, outermost first.
class Trail {
 public:
  explicit Trail(const std::filesystem::path& path) : path_(path) {}

  bool follow(Json::parse_event_t event, const Json& value) {
    switch (event) {
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        open_.push_back({event == Json::parse_event_t::array_start, 0, {}, {}});
        break;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        open_.pop_back();
        end_item();
        break;
      case Json::parse_event_t::key:
        enter(value.get<std::string>());
        break;
      case Json::parse_event_t::value:
        end_item();
        break;
    }
    return true;
  }

  // "slides[2].stroke[0]", for the value that comes next.
  std::string text() const {
    std::string result;
    for (const Container& container : open_) {
      if (container.is_array) {
        result.append("[").append(std::to_string(container.items)).append("]");
      } else {
        result += (result.empty() ? "" : ".") + container.key;
      }
    }
    return result;
  }

 private:
  struct Container {
    bool is_array;
    std::size_t items;
    std::string key;
    std::set<std::string> keys;
  };

  void end_item() {
    if (!open_.empty()) ++open_.back().items;
  }

  void enter(const std::string& key) {
    open_.back().key = key;
    if (!open_.back().keys.insert(key).second) throw FileError(path_, {}, "the key " + text() + " is there twice");
  }

  const std::filesystem::path& path_;
  std::vector<Container> open_;
};

// nlohmann: "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ...".
std::string after_position(std::string_view message) {
  const std::size_t column = message.find("column ");
  const std::size_t colon = message.find(": ", column == message.npos ? 0 : column);
  std::string reason(colon == message.npos ? message : message.substr(colon + 2));
  for (char& c : reason) {
    if (c < ' ' || c > '~') c = '?';
  }
  return reason.size() > 160 ? reason.substr(0, 160) + "..." : reason;
}

[[noreturn]] void fail_at(const std::filesystem::path& path, std::string_view text, std::size_t byte,
                          const std::string& reason) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t column = before.size() - (before.rfind('\n') + 1);  // npos + 1 is 0
  throw FileError(path, Line{line, column + 1}, reason);
}

}  // namespace

Json parse_strict_json(const std::filesystem::path& path, std::string_view text) {
  Trail trail(path);
  try {
    return Json::parse(text.begin(), text.end(),
                       [&trail](int, Json::parse_event_t event, Json& value) { return trail.follow(event, value); });
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    fail_at(path, text, byte, "is not JSON: " + after_position(error.what()));
  } catch (const Json::out_of_range& error) {  // "... number overflow parsing '1e999'"
    const std::string message = error.what();
    const std::size_t open = message.find('\''), close = message.rfind('\'');
    const std::string number = open < close ? message.substr(open + 1, close - open - 1) : "";
    fail_at(path, text, text.find(number), trail.text() + " is beyond the range of numbers: " + in_quotes(number));
  }
}

}  // namespace cagewright::host
