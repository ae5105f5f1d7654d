// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace cagewright::testdata {

// A bead on the axis of a limb: where the axis passes and how thick the limb is there (model units).
struct Knot {
  Eigen::Vector3d point;
  double radius;
};

// A body as a signed field: negative inside, positive outside, zero on the surface. It is the smooth union of pieces,
// in the order in which they were added. Uses only + - * / and square roots, so that its values are the same bits on
// every IEEE machine. Reading is thread-safe.
class Field {
 public:
  // A tube of changing thickness along the Catmull-Rom curve through the knots. Needs 2 knots or more; neighbouring
  // knots must be further apart than their radii differ. `blend`: the width over which the piece melts into those added
  // before it, model units; 0 is a plain union. Throws std::invalid_argument.
  void add_limb(const std::vector<Knot>& knots, double blend);

  // `axes`: the ellipsoid's axes as columns, a rotation.
  void add_ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii, double blend,
                     const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

  // Of the order of the distance to the surface; exact for a single limb. O(pieces near p).
  double value(const Eigen::Vector3d& p) const;

  // Central differences. Not normalised.
  Eigen::Vector3d gradient(const Eigen::Vector3d& p) const;

  // A box that holds the whole body.
  Eigen::AlignedBox3d bounds() const;

 private:
  struct RoundCone {
    Eigen::Vector3d start, direction;
    double length, start_radius, slope;  // slope: loss of radius per unit of length
  };
  struct Ellipsoid {
    Eigen::Vector3d center, radii;
    Eigen::Matrix3d to_local;
  };
  struct Piece {
    std::vector<RoundCone> cones;
    std::vector<Ellipsoid> ellipsoids;
    double blend = 0;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // of a ball that holds the piece
    double radius = 0;
    Eigen::AlignedBox3d box;
  };

  static double distance(const RoundCone& cone, const Eigen::Vector3d& p);
  static double distance(const Ellipsoid& ellipsoid, const Eigen::Vector3d& p);
  static double distance(const Piece& piece, const Eigen::Vector3d& p);

  std::vector<Piece> pieces_;
};

// The rotation that turns +z to `forward` and keeps +y as near to `up` as it can. Built from square roots only.
Eigen::Matrix3d facing(const Eigen::Vector3d& forward, const Eigen::Vector3d& up = Eigen::Vector3d::UnitY());

}  // namespace cagewright::testdata
