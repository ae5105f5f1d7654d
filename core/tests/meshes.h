// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <set>

#include "core/mesh/types.h"

// Meshes for tests, by property. All are made by arithmetic alone, deterministic, and face outward unless they say not.
namespace cagewright::meshes {

// Closed, genus 0.
IndexedMesh tetrahedron();  // corners at the origin and at the ends of the axes; volume 1/6
IndexedMesh box(const Vector3& min, const Vector3& max);
IndexedMesh icosphere(int subdivisions);                                // unit radius, 20 * 4^subdivisions triangles
IndexedMesh capsule(double radius, double length, int around, int up);  // round z; `length` between the half spheres

// The surface of a set of unit cells on a grid: two triangles for each side between a cell and no cell.
IndexedMesh surface_of_cells(const std::set<std::array<int, 3>>& cells);

// Closed, higher genus.
IndexedMesh torus(double major, double minor, int around, int across);  // round z; genus 1
IndexedMesh perforated_plate(int holes);                                // genus = holes; 2 holes + 1 by 3 by 1

// Closed, and a vertex or an edge where the surface touches itself.
IndexedMesh bow_tie();         // two tetrahedra that share one vertex
IndexedMesh bow_tie_edge();    // two boxes that share an edge: four triangles at it, two shared vertices
IndexedMesh touching_boxes();  // the same shape, each box with vertices of its own
IndexedMesh pinched_ring();    // a ring of ten unit boxes whose ends touch in one vertex: one component, one bow-tie
IndexedMesh seamed_pinch();    // a body that touches itself along an edge and is joined at both of the edge's ends;
                               // the two sides of the edge have vertices of their own

// Closed, with a shell inside: the inner one faces into the cavity.
IndexedMesh hollow_sphere(int subdivisions);

// Not orientable.
IndexedMesh klein_bottle(int around, int across);  // closed; `across` odd
IndexedMesh moebius_band(int around);              // open

// What befalls a mesh on its way through files.
IndexedMesh without_triangle(const IndexedMesh& mesh, Eigen::Index triangle);
IndexedMesh inside_out(const IndexedMesh& mesh);
IndexedMesh randomly_turned(const IndexedMesh& mesh, unsigned seed);  // every triangle on the toss of a coin
IndexedMesh shuffled(const IndexedMesh& mesh, unsigned seed);         // vertex and triangle order
IndexedMesh with_own_vertices(const IndexedMesh& mesh);               // three for every triangle, as in STL
IndexedMesh together(const IndexedMesh& first, const IndexedMesh& second);
IndexedMesh moved(const IndexedMesh& mesh, double scale, const Vector3& offset);  // scale (> 0) * point + offset

}  // namespace cagewright::meshes
