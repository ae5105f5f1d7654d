// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/mesh/prepare.h"
#include "core/slide/slide.h"

namespace cagewright {

// One side of one slide, as a part sees it.
struct PartSection {
  int slide;     // index
  bool outward;  // the slide's normal points out of the part (the part is behind the slide)
};

// A connected piece of the model between slides (paper 3.1).
struct Part {
  std::vector<PartSection> sections;  // by slide index; none: a component that no slide cuts
  std::vector<int> vertices;          // rows of Segmentation::cut.points, ascending; loop vertices belong to both sides
  bool enclosed = false;              // a whole component that lies inside another: it needs no cage of its own
};

struct Segmentation {
  IndexedMesh cut;                 // the model, its triangles split exactly along the slides
  std::vector<int> triangle_part;  // of each triangle of `cut`
  std::vector<Part> parts;         // in an order that does not depend on the model's vertex and triangle order
  std::vector<Ellipse> ellipses;   // of each slide
  std::vector<Points> loops;       // of each slide: closed polygon
  std::vector<std::array<int, 2>> slide_parts;  // of each slide: the part behind and the part ahead of it
};

// Called between slides with the fraction done; returns false to cancel.
using Progress = std::function<bool(double)>;

// Cuts the model along the loops of the slides (paper 3.1, but triangles are split along the plane, not dropped, and
// only the loop that encloses the slide's centre is cut). Without slides the whole model is one part.
// Throws Error: those of place_slide; slides_touch (both slides and the place), part_sees_slide_twice; cancelled.
// Where slides fail the others are looked at all the same, without those that failed: what is wrong with them is the
// error's others(). Thread-safe. O(slides * n).
Segmentation segment(const Model& model, const std::vector<Slide>& slides, const Progress& progress = {});

}  // namespace cagewright
