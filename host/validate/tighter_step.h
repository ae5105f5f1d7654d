// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_TIGHTER_STEP_H
#define CAGEWRIGHT_HOST_VALIDATE_TIGHTER_STEP_H

#include <vector>

#include "host/validate/contacts.h"

namespace cagewright::host {

// What holds for every step: the cage's triangles, and what its sections have to stay. Lengths are fractions of the
// model's diagonal.
struct TighterProblem {
  std::vector<Corners> triangles;
  std::vector<Eigen::Vector3d> plane_normals;  // by vertex: it moves across this unit normal only; 0: free
  struct Corner {                              // the angle at vertex `at` keeps |cos| below `most`
    int at, before, after;
    double most;
  };
  std::vector<Corner> corners;
  double margin = 0;  // kept from everything
};

// From the vertices `from`: the least, by Ceres, of half the square of the volume over what it is now, plus
// `restraint` / 2 times the squared steps, plus penalties where a contact, a corner or a fold over an edge would be
// violated, which are made heavier in turn. Throws std::runtime_error where Ceres finds nothing usable.
PointList tighter_step(const TighterProblem& problem, const PointList& from, const Contacts& contacts,
                       double restraint);

double volume_of(const PointList& vertices, const std::vector<Corners>& triangles);

}  // namespace cagewright::host

#endif
