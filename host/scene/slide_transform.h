// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SLIDE_TRANSFORM_H
#define CAGEWRIGHT_HOST_SCENE_SLIDE_TRANSFORM_H

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "host/file/slides_file.h"

namespace cagewright::host {

// The transform that maps the unit circle of the XY plane to the ellipse and Z to its normal u x v. X and Y are the
// principal radii, the longer first, so they are perpendicular even where the given radii are conjugate; where u is
// one of them X runs along it. Z is as long as their mean. Precondition: u and v span a plane.
Eigen::Affine3d slide_transform(const Slide::Ellipse& ellipse);

// The ellipse to which a transform maps the unit circle of the XY plane.
Slide::Ellipse transformed_circle(const Eigen::Affine3d& transform);

// glTF's translation (3), rotation (4: x, y, z, w) and scale (3) of a node, in this order.
using TranslationRotationScale = std::array<double, 10>;

// Empty where the transform's columns are not perpendicular (1e-9) or one is zero. A mirrored one gets a negative scale
// along Z.
std::optional<TranslationRotationScale> decompose(const Eigen::Affine3d& transform);

// What reading these numbers from a node gives, to the bit.
Eigen::Affine3d compose(const TranslationRotationScale& numbers);

// A slide's numbers as a node under its mesh node has them, and the ellipse that reading them gives: 1e-13 of its size
// from the one asked for where its radii are perpendicular; else it is the same ellipse by its principal radii (radii
// that are so but for 1e-9 are turned by as much). A scene that is saved and read has the slides, and so the cage, that
// it had before; not where a file of others has put a transform between the slide and its mesh.
struct StoredEllipse {
  TranslationRotationScale numbers{};
  Slide::Ellipse ellipse;
};

// What was stored once is stored as the same, to the bit. Empty where glTF's numbers cannot say it (radii of 0, or
// beyond all bounds).
std::optional<StoredEllipse> as_stored(const Slide::Ellipse& ellipse);

}  // namespace cagewright::host

#endif
