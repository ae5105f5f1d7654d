// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_OBSERVED_CAGE_H
#define CAGEWRIGHT_HOST_VALIDATE_OBSERVED_CAGE_H

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/plugin_client/session.h"

namespace cagewright::host {

using PointList = std::vector<Eigen::Vector3d>;
using Corners = std::array<int, 3>;

struct ObservedSection {
  std::string slide;                     // its name
  Eigen::Vector3d center, normal, u, v;  // the ellipse
  Eigen::Vector3d p, q;                  // half edges of the rectangle
  Eigen::Vector2d x;                     // the direction that p is the fourth root of
  Eigen::Vector2d linear;                // the minimiser of (1) as a quadratic form; NaN where not handed out
  std::array<int, 2> parts{-1, -1};      // behind and ahead
};

struct ObservedPart {
  std::vector<int> vertices;  // rows of ObservedCage::model, ascending; those of loops belong to both sides
  bool is_enclosed = false;
  Eigen::Vector3d center;
};

struct ObservedIteration {
  double max_signed_distance = 0;
  PointList before, after, plane_normals;  // by cage vertex; a plane normal of 0: free
  std::vector<double> damping;
  PointList normals, anchors;  // by cage triangle
  std::vector<std::array<double, 3>> weights;
  std::vector<double> signed_distances;
  std::vector<std::int64_t> outermost;  // row of ObservedCage::model, or -1
};

// All that a session's last solve tells of how its cage came about, model units. Nothing is judged here. Limbs were not
// merged: the records are about the triangles that the cage had before.
struct ObservedCage {
  double diagonal = 0, extent = 0;
  double lambda = 0, delta = 0, damping = 0, push = 0;  // as the stages were given them: delta is a length
  bool is_over_angles = false;                          // orientation went on to the minimum over the angles
  bool is_local = true, is_in_plane = false;            // scope and constraint of the refinement
  bool is_enclosed = false;                             // enclosing came after the refinement
  bool certified = false, converged = false;
  double max_signed_distance = 0;  // of the refined cage
  double corner_angle = 0;         // degrees: sections keep within it of right angles where they stay in plane

  PointList model;  // the vertices of the cut model
  std::vector<Corners> model_triangles;
  std::vector<ObservedPart> parts;
  std::vector<ObservedSection> sections;  // corners of section k are vertices 4 k to 4 k + 3 of the cage
  PointList vertices;                     // of the cage as it ended
  std::vector<Corners> triangles;
  std::vector<int> triangle_part, vertex_section;
  std::vector<ObservedIteration> iterations;
};

// After a solve that went through the refinement at least. Throws PluginError, and std::runtime_error where what the
// plug-in hands out does not fit together.
ObservedCage observe(const Session& session);

PointList to_points(const std::vector<double>& rows);

}  // namespace cagewright::host

#endif
