// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/types.h"
#include "core/slide/slide.h"

// Limbed bodies with cut slides, for tests of the stages. Deterministic, closed, outward, and without symmetries: what
// holds on them does not hold by chance.
namespace cagewright::shapes {

// Marching tetrahedra of {field < 0} on a grid of cubes of size `cell` over the box. Closed where the field is positive
// on the box's faces. O(cells).
IndexedMesh surface_of(const std::function<double(const Vector3&)>& field, const Eigen::AlignedBox3d& box, double cell);

struct Tube {
  Vector3 from, to;
  double radius;
};
// The smooth, slightly bumpy union of round tubes with round ends, flattened to 3/4 along y so that cross sections are
// not round.
IndexedMesh body_of(const std::vector<Tube>& tubes, double cell);

// A slide across tube at `share` of its way (0: from, 1: to), on the body that body_of makes; its normal runs along.
Slide slide_across(const std::string& name, const Tube& tube, double share);

struct SlidBody {
  std::string name;
  IndexedMesh mesh;
  std::vector<Slide> slides;
  long cage_genus;
};
SlidBody limb(int slides);              // one tube, cut across `slides` times
SlidBody fork(int slides_on_each_arm);  // three arms round a junction
SlidBody ring(int slides);              // a ring of tubes, genus 1
SlidBody figure();                      // trunk, head, two arms, two legs that stand close; seven slides
SlidBody close_legs(double gap);      // a trunk on two legs that come so near to each other below the knees; six slides
SlidBody handle_body();               // a trunk with a handle (genus 1) and a free arm
std::vector<SlidBody> slid_bodies();  // one of each, all soundly cut

// Uniform scale, then rotation, then translation.
struct Motion {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vector3 offset = Vector3::Zero();
  Vector3 operator()(const Vector3& point) const { return rotation * (scale * point) + offset; }
  Vector3 turn(const Vector3& direction) const { return rotation * direction; }
};
Motion random_motion(unsigned seed, double scale, double offset);
IndexedMesh moved(const IndexedMesh& mesh, const Motion& motion);
Slide moved(const Slide& slide, const Motion& motion);
std::vector<Slide> moved(const std::vector<Slide>& slides, const Motion& motion);

}  // namespace cagewright::shapes
