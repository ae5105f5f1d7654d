// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/mesh/types.h"

namespace cagewright {

// A cut slide's ellipse (paper 3.1): center + cos(a) u + sin(a) v.
struct Ellipse {
  Vector3 center = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  // unit, along u x v
  Vector3 u = Vector3::UnitX();       // principal radii: orthogonal, |u| >= |v| > 0
  Vector3 v = Vector3::UnitY();
};

struct StrokeDefinition {
  Points points;  // n x 3, in the order drawn
};
struct PointNormalDefinition {
  Vector3 point, normal;  // the normal need not be unit
};
struct EllipseDefinition {
  Vector3 center, u, v;  // conjugate radii
};
struct PointDefinition {
  Vector3 point;  // on the surface; the plane is that across the limb there (see across_limb.h)
};
using SlideDefinition = std::variant<StrokeDefinition, PointNormalDefinition, EllipseDefinition, PointDefinition>;

// What the user asked for.
struct Slide {
  std::string name;  // empty only where it is alone
  SlideDefinition definition;
};

// How sentences call it: "slide 'wrist'", or "the slide" where it has no name.
inline std::string slide_text(const std::string& name) { return name.empty() ? "the slide" : "slide '" + name + "'"; }

}  // namespace cagewright
