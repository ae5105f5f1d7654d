// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace cagewright::testdata {

enum class SlideKind { kStroke, kPointNormal, kEllipse };

struct Slide {
  std::string name;
  SlideKind kind;
  Eigen::Vector3d point;   // on the plane, inside the loop: the point, the centre, or the mean of the stroke
  Eigen::Vector3d normal;  // unit
};

// Reads a slides file, strictly. Throws std::runtime_error, naming the slide, where it is not what docs say: JSON of
// version 1; names unique and not empty; exactly one of stroke (5 points or more), point + normal, center + u + v;
// nothing else; numbers finite; normals not zero; u and v neither zero nor parallel; strokes not along a line.
std::vector<Slide> read_slides(const std::filesystem::path& file);

}  // namespace cagewright::testdata
