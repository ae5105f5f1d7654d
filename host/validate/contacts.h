// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_CONTACTS_H
#define CAGEWRIGHT_HOST_VALIDATE_CONTACTS_H

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/validate/observed_cage.h"

namespace cagewright::host {

// What a cage must not run into while it is made smaller: conditions that hold where its vertices are now.
struct Contacts {
  struct Behind {  // a model point stays behind the plane of a cage triangle, wherever that goes
    int triangle;
    Eigen::Vector3d point;
  };
  struct Above {  // axis . x_vertex stays at least this
    int vertex;
    Eigen::Vector3d axis;
    double least;
  };
  struct Apart {  // axis . (x_upper - x_lower) stays above 0
    int upper, lower;
    Eigen::Vector3d axis;
  };
  std::vector<Behind> behind;
  std::vector<Above> above;
  std::vector<Apart> apart;
};

// All model points and pairs of cage triangles within `reach` of each other; of model points over the same place of a
// triangle only the nearest. O(model points x cage triangles), most of them told apart by boxes.
Contacts find_contacts(const PointList& model, const PointList& cage, const std::vector<Corners>& triangles,
                       double reach);

// Adds conditions that keep a triangle of the model, or another of the cage, apart from a triangle of the cage as they
// are now. Nothing where they meet already, or share a vertex.
void keep_apart(const std::array<Eigen::Vector3d, 3>& model_triangle, const PointList& cage, const Corners& triangle,
                Contacts& contacts);
void keep_apart(const PointList& cage, const Corners& first, const Corners& second, Contacts& contacts);

// A unit direction along which all of `upper` lies above all of `lower`, as far as the normals and the cross products
// of edges give it; nothing where none does.
std::optional<Eigen::Vector3d> separating_axis(const std::array<Eigen::Vector3d, 3>& upper,
                                               const std::array<Eigen::Vector3d, 3>& lower);

// The point of the triangle nearest to p.
Eigen::Vector3d nearest_point(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& p);

}  // namespace cagewright::host

#endif
