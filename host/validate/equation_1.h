// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_EQUATION_1_H
#define CAGEWRIGHT_HOST_VALIDATE_EQUATION_1_H

#include <Eigen/Core>
#include <vector>

#include "host/validate/observed_cage.h"

namespace cagewright::host {

// Equation (1), built again from the slides' ellipses and the parts that they bound, as the paper has it (the nearest
// rotation by SVD), with what docs/algorithms/orientation.md adds: perpendicular slides follow each other both ways.
struct Equation1 {
  struct Pull {  // weight |x_k - target|^2
    int k;
    Eigen::Vector2d target;
    double weight;
  };
  struct Tie {  // weight |turn x_k - x_h|^2
    int k, h;
    Eigen::Matrix2d turn;
    double weight;
  };
  std::size_t slides = 0;
  std::vector<Pull> pulls;
  std::vector<Tie> ties;
  double tie_break =
      0;  // weight of |x_k - (1, 0)|^2 that the plug-in adds for every slide, so that one solution exists

  // (1) itself, without the tie-break, at directions of any length.
  double at(const std::vector<Eigen::Vector2d>& x) const;
  // At x_k = (cos 4 angle_k, sin 4 angle_k).
  double at_angles(const std::vector<double>& angles) const;
};

Equation1 equation_1(const ObservedCage& seen);

// The angle of p in the frame (u, v) of its ellipse.
double angle_of(const ObservedSection& section);

}  // namespace cagewright::host

#endif
