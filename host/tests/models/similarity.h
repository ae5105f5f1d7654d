// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_MODELS_SIMILARITY_H
#define CAGEWRIGHT_HOST_TESTS_MODELS_SIMILARITY_H

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "host/tests/models/surface.h"

namespace cagewright::host {

// A rotation, then a uniform scale, then a translation.
struct Similarity {
  Eigen::Matrix3d rotation;
  double scale;
  Eigen::Vector3d translation;

  Eigen::Vector3d point(const Eigen::Vector3d& p) const { return scale * (rotation * p) + translation; }
};

// Any rotation; a scale of 1e-3 to 1e3, all magnitudes as likely; a translation of up to two `length`s, scaled too,
// along each axis. The same seed gives the same on every machine.
Similarity random_similarity(std::uint64_t seed, double length);

Surface moved(const Surface& surface, const Similarity& motion);

// A slides file (format of `--slides`) whose strokes, points, normals and ellipses are moved.
nlohmann::json moved_slides(const nlohmann::json& slides_file, const Similarity& motion);

// The same surface with its vertices and triangles in another order, and every triangle from another corner on.
Surface shuffled(const Surface& surface, std::uint64_t seed);

}  // namespace cagewright::host

#endif
