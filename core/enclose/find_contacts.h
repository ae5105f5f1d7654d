// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/enclose/contact.h"
#include "core/enclose/movable_cage.h"

namespace cagewright {

struct ContactQuery {
  std::vector<double> clearance;  // of each cage triangle: the distance from the model that it has to keep, model units
  double gap = 0;                 // between cage triangles without a common vertex
  double longest = 0;             // no vertex will go farther in the step
  std::vector<std::pair<int, int>> hits;  // cage and model triangle: pairs to look at whatever their vertices say
  // While parts of the model are outside: of each of its vertices whether it is, and of each cage triangle the model
  // triangles that it meets, ascending. They are not looked at. Null: nothing is.
  const std::vector<char>* outside = nullptr;
  const std::vector<std::vector<int>>* meeting = nullptr;
  unsigned threads = 0;
  bool own_only = false;  // no other parts' model, and no cage triangles
};

// What a step may run into, to first order in it: the model's vertices near cage triangles (in each of a few fields of
// a triangle the nearest), model triangles too large to go by vertices, and cage triangles near each other.
// Cage triangles must not meet. The same for any number of threads. O(model near the cage + triangles^2).
Contacts find_contacts(const MovableCage& movable, const std::vector<int>& vertex_owner, const ContactQuery& query);

// Of each vertex of the model the first triangle at it, -1 where there is none. O(n).
std::vector<int> find_vertex_owners(const IndexedMesh& model);

// The condition that the point of cage triangle t at the barycentric weights keeps moving at least `least` along n.
Contact contact_of(const MovableCage& movable, int t, const Vector3& weights, const Vector3& n, double least);

}  // namespace cagewright
