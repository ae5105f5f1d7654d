// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/slides_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/strict_json.h"

namespace cagewright::host {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 6> shape_keys = {"stroke", "point", "normal", "center", "u", "v"};

std::string key_text(std::string_view key) {
  std::string text(1, '"');
  text += key;
  return text += '"';
}

// A name as sentences show it: one line, whatever it holds.
std::string name_text(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; }, '?');
  return key_text(name);
}

class SlidesReader {
 public:
  explicit SlidesReader(const std::filesystem::path& path) : path_(path) {}

  std::vector<Slide> read(const Json& json) {
    if (!json.is_object()) fail("should be an object with \"version\" and \"slides\"");
    if (!json.contains("version")) fail("has no \"version\"; this program reads version 1");
    const Json& version = json["version"];
    if (!version.is_number() || version != 1) {
      fail("is of version " + in_quotes(version.dump()) + "; this program reads version 1");
    }
    for (const auto& [key, value] : json.items()) {
      if (key != "version" && key != "slides") fail("has the unknown key " + in_quotes(key));
    }
    if (!json.contains("slides")) fail("has no \"slides\"");
    if (!json["slides"].is_array()) fail("its \"slides\" should be an array");
    std::vector<Slide> slides;
    for (const Json& slide : json["slides"]) slides.push_back(read_slide(slide, slides.size()));
    return slides;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason); }
  [[noreturn]] void fail_slide(const std::string& reason) const { fail(label_ + ": " + reason); }

  Slide read_slide(const Json& json, std::size_t index) {
    label_ = "slide " + std::to_string(index);
    if (!json.is_object()) fail_slide("should be an object");
    Slide slide;
    slide.name = read_name(json, index);
    for (const auto& [key, value] : json.items()) {
      const bool is_known = std::find(shape_keys.begin(), shape_keys.end(), key) != shape_keys.end();
      if (key != "name" && !is_known) fail_slide("unknown key " + in_quotes(key));
    }
    // The first key of each kind is its own; the others only belong to it.
    if (json.contains("stroke")) {
      refuse_others(json, "stroke", {"stroke"});
      slide.shape = Slide::Stroke{read_stroke(json["stroke"])};
    } else if (json.contains("point") || json.contains("normal")) {
      refuse_others(json, json.contains("point") ? "point" : "normal", {"point", "normal"});
      const Point3 point = read_vector(json, "point");
      if (json.contains("normal")) {
        slide.shape = Slide::PointNormal{point, read_vector(json, "normal")};
      } else {
        slide.shape = Slide::Point{point};
      }
    } else if (json.contains("center") || json.contains("u") || json.contains("v")) {
      slide.shape = Slide::Ellipse{read_vector(json, "center"), read_vector(json, "u"), read_vector(json, "v")};
    } else {
      fail_slide("needs \"stroke\", or \"point\", or \"point\" and \"normal\", or \"center\", \"u\" and \"v\"");
    }
    return slide;
  }

  std::string read_name(const Json& json, std::size_t index) {
    if (!json.contains("name")) fail_slide("has no \"name\"");
    if (!json["name"].is_string()) fail_slide("\"name\" should be a string");
    const std::string name = json["name"].get<std::string>();
    if (name.empty()) fail_slide("\"name\" is empty");
    if (name.find('\0') != name.npos) fail_slide("\"name\" holds a zero character");
    label_ += " (" + name_text(name) + ")";
    const auto [entry, is_new] = named_.try_emplace(name, index);
    if (!is_new) fail_slide("\"name\" is also that of slide " + std::to_string(entry->second) + "; names must differ");
    return name;
  }

  void refuse_others(const Json& json, std::string_view kind, std::initializer_list<std::string_view> allowed) const {
    for (const std::string_view key : shape_keys) {
      const bool is_allowed = std::find(allowed.begin(), allowed.end(), key) != allowed.end();
      if (json.contains(key) && !is_allowed) {
        fail_slide("has both " + key_text(kind) + " and " + key_text(key) + "; a slide is given in one way only");
      }
    }
  }

  std::vector<Point3> read_stroke(const Json& json) const {
    if (!json.is_array()) fail_slide("\"stroke\" should be an array of points [x, y, z]");
    std::vector<Point3> stroke;
    for (const Json& point : json)
      stroke.push_back(to_point(point, "point " + std::to_string(stroke.size()) + " of \"stroke\""));
    return stroke;
  }

  Point3 read_vector(const Json& json, std::string_view key) const {
    if (!json.contains(key)) fail_slide("has no " + key_text(key));
    return to_point(json[std::string(key)], key_text(key));
  }

  Point3 to_point(const Json& json, const std::string& what) const {
    if (!json.is_array() || json.size() != 3 ||
        !std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); })) {
      fail_slide(what + " should be three numbers [x, y, z]");
    }
    return json.get<Point3>();
  }

  const std::filesystem::path& path_;
  std::string label_;
  std::map<std::string, std::size_t> named_;
};

// Objects with their keys in the documented order.
using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const Slide& slide) {
  OrderedJson json;
  json["name"] = slide.name;
  if (const auto* stroke = std::get_if<Slide::Stroke>(&slide.shape)) {
    json["stroke"] = stroke->points;
  } else if (const auto* plane = std::get_if<Slide::PointNormal>(&slide.shape)) {
    json["point"] = plane->point;
    json["normal"] = plane->normal;
  } else if (const auto* ellipse = std::get_if<Slide::Ellipse>(&slide.shape)) {
    json["center"] = ellipse->center;
    json["u"] = ellipse->u;
    json["v"] = ellipse->v;
  } else if (const auto* click = std::get_if<Slide::Point>(&slide.shape)) {
    json["point"] = click->point;
  }
  return json;
}

}  // namespace

std::vector<Slide> parse_slides(const std::filesystem::path& path, std::string_view text) {
  return SlidesReader(path).read(parse_strict_json(path, text));
}

std::vector<Slide> read_slides(const std::filesystem::path& path) { return parse_slides(path, read_bytes(path)); }

std::string slides_text(const std::filesystem::path& path, const std::vector<Slide>& slides) {
  // A slide a line: a file that people read, edit and compare.
  std::string text = "{\"version\": 1, \"slides\": [";
  try {
    for (std::size_t i = 0; i < slides.size(); ++i) text += (i == 0 ? "\n  " : ",\n  ") + to_json(slides[i]).dump();
  } catch (const OrderedJson::exception&) {
    throw FileError(path, {}, "cannot be written: the name of a slide is not UTF-8");
  }
  text += slides.empty() ? "]}\n" : "\n]}\n";
  parse_slides(path, text);
  return text;
}

}  // namespace cagewright::host
