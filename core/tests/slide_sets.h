// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/prepare.h"
#include "core/slide/slide.h"
#include "core/tests/random_numbers.h"

namespace cagewright {

// Random slides on a model, as a user without any sense would put them. Keeps the model by reference.
class SlideSets {
 public:
  explicit SlideSets(const Model& model);

  // Through a random point of the surface, across a random direction or along the limb there.
  Slide make_slide(const std::string& name, Random& random) const;

  // 2 to 15 slides, named 's1' and so on, that segment() accepts; fewer, or none, where too few of many fit.
  std::vector<Slide> make_set(Random& random) const;

 private:
  Vector3 point_on_surface(Random& random) const;
  Vector3 limb_direction(const Vector3& point, double radius) const;

  const Model& model_;
  IndexedMesh mesh_;
  Points normals_, centers_;         // of each triangle; the normals are unit
  std::vector<double> areas_up_to_;  // of each triangle: the area of all up to it and its own
};

}  // namespace cagewright
