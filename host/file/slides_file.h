// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_SLIDES_FILE_H
#define CAGEWRIGHT_HOST_FILE_SLIDES_FILE_H

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cagewright::host {

using Point3 = std::array<double, 3>;  // model units, in the model's own coordinates

// A cut slide as its file gives it; none of it is fitted or checked against a model.
struct Slide {
  struct Stroke {
    std::vector<Point3> points;  // on the surface
    bool operator==(const Stroke&) const = default;
  };
  struct PointNormal {
    Point3 point{};
    Point3 normal{};  // of any length
    bool operator==(const PointNormal&) const = default;
  };
  struct Ellipse {
    Point3 center{};
    Point3 u{}, v{};  // radii
    bool operator==(const Ellipse&) const = default;
  };
  struct Point {
    Point3 point{};  // on the surface; the plane is that across the limb there
    bool operator==(const Point&) const = default;
  };
  std::string name;  // UTF-8, not empty
  std::variant<Stroke, PointNormal, Ellipse, Point> shape;
  bool operator==(const Slide&) const = default;
};

// {"version": 1, "slides": [{"name": ..., "stroke": [[x,y,z], ...]} or "point", "normal" or "point" or "center", "u",
// "v"]}. Strict: unknown, missing and repeated keys, mixed kinds, wrong types and lengths, numbers beyond a double,
// empty and repeated names are errors. Throws FileError with a sentence that names the slide and the key, or line and
// column.
std::vector<Slide> read_slides(const std::filesystem::path& path);
std::vector<Slide> parse_slides(const std::filesystem::path& path, std::string_view text);

// The slides as such a file, in their order; numbers read back as the same doubles. Precondition: numbers finite.
// Throws FileError where parse_slides would refuse a name.
std::string slides_text(const std::filesystem::path& path, const std::vector<Slide>& slides);

}  // namespace cagewright::host

#endif
