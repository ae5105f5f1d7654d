// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/enclose/certificate.h"
#include "core/enclose/finding.h"
#include "core/meshing/meshing.h"

namespace cagewright {

struct EncloseOptions {
  double delta = 0;  // clearance: the least distance from model to cage, as a fraction of the diagonal
  // Section corners stay in their slides' planes, and the angles of the sections within corner_angle of a right angle.
  bool in_plane = true;
  bool tighten = true;  // take volume off again while the cage keeps its certificate
  // Where nothing else encloses the model, or keeps the clearance: limbs whose walls run into each other become one
  // (merge_limbs.h).
  bool merge = true;
  unsigned threads = 0;      // 0: all
  double corner_angle = 15;  // degrees
  // The points are floats in the end, as files hold them, and so certified; but for models that floats do not hold: too
  // large or small for them, or so far from the origin that they are 1e-4 of the diagonal apart.
  bool round_to_float = true;
};

struct Enclosure {
  Points points;             // of the cage; its triangles are those that were given, or those of `merged`
  Certificate certificate;   // of the model as it was given
  bool keeps_delta = false;  // no triangle is nearer to the model than the clearance (in floating point)
  int pushes = 0;            // steps of push_out
  int sweeps = 0;            // of tighten, over all vertices
  // Where the certificate or the clearance is not earned, or the cage could be better: which slides, and what to do.
  std::vector<Finding> findings;
  std::string shortfall;    // their sentences; else empty
  double first_volume = 0;  // of the cage before it was tightened, model units cubed
  // Where sections were to stay in plane: those that could not, so that the cage encloses the model all the same.
  std::vector<int> sections_off_plane;
  std::optional<Cage> merged;        // where limbs were made one: the cage, with its points
  std::vector<int> sections_merged;  // those that lost corners by that; not among sections_off_plane
  double least_distance = 0;         // kept from the model everywhere, at most the clearance asked for, model units
  double most_off_square = 0;        // of a section's angle from a right angle where sections stay in plane, degrees
};

// Moves the vertices of a refined cage until it bounds the model, exactly, and then takes off what volume it can:
// start.h, push_out.h, tighten.h; where that fails, and only there, merge_limbs.h. Ends with the certificate of
// whatever was reached; never claims more. `model` is what segmentation.cut was cut from. Same bits for any number of
// threads. Throws Error(cancelled). Thread-safe.
Enclosure enclose(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                  const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options,
                  const Progress& progress = {});

}  // namespace cagewright
