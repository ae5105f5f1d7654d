// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/meshing/meshing.h"

namespace cagewright {

enum class RefineScope {
  local,  // (6) over the vertices seen through the triangle from the part's centre (the cone over it)
  part,   // (6) over all vertices of the part, as in the paper; diverges on parts that are not nearly convex
};

struct RefineOptions {
  double delta = 0;     // the distance asked for, as a fraction of the diagonal
  int iterations = 30;  // at most
  RefineScope scope = RefineScope::local;
  bool in_plane = false;  // section corners stay in their slides' planes
  double damping = 0.01;  // > 0: Tikhonov term of (8), as a fraction of the trace of its matrix
  double push = 8;        // weight in (8) of triangles that still have to move (7a) over the others; 1: the paper
  unsigned threads = 0;   // 0: all. The result is the same bits for any number.
};

// What one iteration saw and did: enough for an independent solver to repeat it.
struct RefineRecord {
  double max_signed_distance = 0;       // max over t of (6), before the step, model units
  Points before, after;                 // cage vertices
  std::vector<double> damping;          // per vertex: mu of the term mu |x - u|^2 added to (8)
  Points plane_normal;                  // per vertex: it moves across this unit normal only; zero: free
  Points normals, anchors;              // per triangle: n_t and a_t' of (7)
  Points weights;                       // per triangle: the weight of (8) at its three corners
  std::vector<double> signed_distance;  // per triangle: (6); -infinity where it sees no vertex
  std::vector<long> outermost;          // per triangle: i(t), row of Segmentation::cut.points; -1 where none
};

struct Refinement {
  Cage cage;
  std::vector<RefineRecord> records;
  double max_signed_distance = 0;  // of the final cage, model units
  double extent = 0;               // the length for D_BB in (9): turns with the model, at most the diagonal
  bool converged = false;          // equation (9)
  std::string shortfall;           // where not converged: which part is how far from (9), and what to do; else empty
};

// Pushes the cage out until it bounds the model at distance delta (paper 3.4, equations (6) to (9)).
// Throws Error: refine_diverged (names the part and its slides), cancelled. Thread-safe.
// O(iterations * n); n = vertices of the cut model.
Refinement refine(const Segmentation& segmentation, const std::vector<SectionFrame>& sections, const Cage& cage,
                  double diagonal, const std::vector<std::string>& names, const RefineOptions& options,
                  const Progress& progress = {});

}  // namespace cagewright
