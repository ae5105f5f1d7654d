// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

// Every tolerance of the core, in one place. Lengths are relative to the diagonal of the model's bounding box.
namespace cagewright::tolerance {

inline constexpr double tie = 1e-9;                // two choices this near to equal: a fixed rule decides, not rounding
inline constexpr double touching_loops = 1e-9;     // loops nearer than this touch
inline constexpr double collinear_stroke = 1e-6;   // second principal extent of a stroke over its first
inline constexpr double degenerate_radius = 1e-6;  // shortest radius of a slide over the longest
inline constexpr double largest_ellipse = 50;      // longest radius over the extent of the stroke that it fits
inline constexpr double tie_break_weight = 1e-10;  // holds an unoriented slide to its u; over the heaviest of (1)
inline constexpr double nearest_centers = 1e-3;    // slides nearer than this to their size weigh no more in (4a)
inline constexpr double round_loop = 1e-6;         // radii this near to equal give no direction
inline constexpr double off_surface = 0.05;        // of a slide's point, at most, where the slide is a point alone
inline constexpr double into_surface = 1e-6;       // by which such a point is moved into the model
inline constexpr double least_thickness = 1e-3;    // of a box round a flat part, over its diagonal
inline constexpr double least_facing = 0.02;       // sine under which a centre sees a cage triangle, kept by refinement
inline constexpr double kept_facing = 0.5;         // of that sine, by one step of refinement
inline constexpr double least_cap = 0.1;        // side of a cap over its section's: a pointed part ends in a rectangle
inline constexpr double far_of_sections = 1.5;  // a limb reaches so far beyond them, over their half side,
inline constexpr double far_of_hull = 0.1;      // and beyond the hull of what bounds its part, over the hull's size
inline constexpr std::size_t most_limb_caps = 6;  // of one part
inline constexpr double least_visibility = 1e-6;  // sine under which a part's centre has to see what bounds it
inline constexpr double on_plane = 1e-9;  // a vertex this near to a slide's plane, as those of its loop, lies on it
inline constexpr double smallest_anchor_distance = 1e-6;  // bounds the weights of (8)
inline constexpr double convergence = 1e-3;               // equation (9)
inline constexpr double flip_gain = 1e-9;                 // radians by which an edge flip must smooth the cage
inline constexpr double near_slide = 2.0;      // from its centre over its long radius: both sides bound what is so near
inline constexpr double push_margin = 1e-4;    // by which a push clears the model; over the diagonal
inline constexpr double looked_beyond = 0.01;  // by a cage triangle for the model near it; over the diagonal
inline constexpr double longest_push = 0.02;   // of a vertex by one step; over the diagonal
inline constexpr double round_the_loop = 1e-3;  // left round a slide's loop; over the diagonal
inline constexpr double thin_triangle = 1e-3;   // twice the area over its box's diagonal squared: no sure normal
inline constexpr double rounding = 1e-12;       // of a length that was computed, over the coordinates
inline constexpr double least_gap = 2e-6;       // from cage to model and between its triangles; over the diagonal
inline constexpr double coarsest_float =
    1e-4;  // between floats where a cage is still rounded to them; over the diagonal
inline constexpr double contact_slack = 4e-6;            // what tightening leaves beyond it; over the diagonal
inline constexpr double first_tightening_step = 1.2e-2;  // of a vertex; over the diagonal
inline constexpr double least_tightening_step = 4e-4;    // shorter ones are not tried; over the diagonal
inline constexpr double least_tightening = 5e-4;         // of the volume, by one step; less makes steps shorter
inline constexpr double most_collapsed = 1e-3;           // of the volume, added or taken by one collapse of an edge
inline constexpr double diverged = 10.0;     // a cage vertex farther than this from the model's box has flown
inline constexpr double mirror = 1e-3;       // mean distance of a symmetric model from its mirror image
inline constexpr double same_mirror = 0.99;  // cosine between normals of mirror planes that are one
inline constexpr double same_moment = 0.01;  // difference of two principal moments, over the greater

}  // namespace cagewright::tolerance
