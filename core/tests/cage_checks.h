// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <set>
#include <vector>

#include "core/meshing/meshing.h"
#include "core/tests/shapes.h"

namespace cagewright::checks {

// Expects a closed, consistently oriented 2-manifold of `genus` (of the whole), by counts that share no code with the
// core: every directed edge once and its opposite once, one fan round every vertex, Euler's number over components.
void expect_closed_manifold(const Points& points, const Triangles& triangles, long genus);
long components_of(const Triangles& triangles);

// E - V + components of the graph whose vertices are the parts with a cage of their own and whose edges are the slides.
long genus_of_slides(const Segmentation& segmentation);

// Expects `other` to be `cage` moved: its points within `tolerance` of the moved ones, one to one, and the same
// triangles of the same parts between them, in whatever order.
void expect_same_cage(const Cage& cage, const Cage& other, double tolerance, const shapes::Motion& motion = {});
// The largest distance between partners, or infinity where the points have no one-to-one partners.
double distance_between(const Cage& cage, const Cage& other, const shapes::Motion& motion);

// Of each part the triangles by corner positions, in order: what vertex and triangle order must not change.
using Corner = std::array<double, 3>;
std::vector<std::multiset<std::array<Corner, 3>>> parts_by_position(const Segmentation& segmentation);

double area_of(const IndexedMesh& mesh);
double volume_of(const IndexedMesh& mesh);
std::vector<std::string> names_of(const std::vector<Slide>& slides);

}  // namespace cagewright::checks
