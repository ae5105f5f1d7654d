// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "testdata/generate/figures.h"

namespace cagewright::testdata {
namespace {

constexpr double kDiagonal = 0.70710678118654752;

// How an arm leaves the body and where it goes. Heights and the sideways swing are given at its five knots.
struct Arm {
  double x, z;                  // unit direction outward
  std::array<double, 5> swing;  // across that direction
  std::array<double, 5> height;
  double reach;  // stretches the distances from the axis
};

constexpr std::array<double, 5> kDistance{0.35, 0.95, 1.50, 2.00, 2.40};
constexpr std::array<double, 5> kRadius{0.230, 0.180, 0.135, 0.095, 0.045};

constexpr std::array<Arm, 8> kArms{{
    {1, 0, {0, 0, 0.08, 0.28, 0.55}, {0.30, 0.22, 0.15, 0.22, 0.40}, 1.00},
    {kDiagonal, kDiagonal, {0, 0, -0.05, -0.20, -0.45}, {0.30, 0.20, 0.16, 0.14, 0.20}, 0.96},
    {0, 1, {0, 0, 0.10, 0.30, 0.45}, {0.30, 0.26, 0.30, 0.52, 0.82}, 0.92},
    {-kDiagonal, kDiagonal, {0, 0, 0.02, -0.12, -0.38}, {0.30, 0.21, 0.14, 0.16, 0.32}, 1.02},
    {-1, 0, {0, 0, -0.10, -0.28, -0.36}, {0.30, 0.23, 0.20, 0.34, 0.64}, 0.98},
    {-kDiagonal, -kDiagonal, {0, 0, 0.06, 0.24, 0.52}, {0.30, 0.20, 0.14, 0.13, 0.16}, 1.00},
    {0, -1, {0, 0, -0.06, 0.04, 0.26}, {0.30, 0.22, 0.16, 0.26, 0.50}, 0.95},
    {kDiagonal, -kDiagonal, {0, 0, 0.09, 0.22, 0.26}, {0.30, 0.24, 0.22, 0.40, 0.72}, 0.94},
}};

std::vector<Knot> knots_of(const Arm& arm) {
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < kDistance.size(); ++i) {
    const double out = kDistance[i] * arm.reach;
    knots.push_back(
        {{arm.x * out - arm.z * arm.swing[i], arm.height[i], arm.z * out + arm.x * arm.swing[i]}, kRadius[i]});
  }
  return knots;
}

}  // namespace

Figure make_octopus() {
  Figure figure{"octopus", 0, 120, {}};
  Field& body = figure.field;
  body.add_ellipsoid({0, 0.34, 0}, {0.56, 0.27, 0.56}, 0);
  for (const Arm& arm : kArms) body.add_limb(knots_of(arm), 0.10);
  body.add_limb({{{0, 0.45, 0.05}, 0.38}, {{0, 0.80, -0.02}, 0.31}}, 0.20);
  body.add_ellipsoid({0.02, 1.26, -0.14}, {0.44, 0.56, 0.43}, 0.18, facing({0, 0.25, 1}));
  body.add_limb({{{0.10, 0.74, 0.09}, 0.14}, {{0.225, 0.79, 0.215}, 0.105}}, 0.12);
  body.add_limb({{{-0.10, 0.74, 0.10}, 0.14}, {{-0.215, 0.80, 0.225}, 0.105}}, 0.12);
  return figure;
}

}  // namespace cagewright::testdata
