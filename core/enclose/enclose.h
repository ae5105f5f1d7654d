// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/enclose/certificate.h"
#include "core/meshing/meshing.h"

namespace cagewright {

struct EncloseOptions {
  double delta = 0;       // clearance: the least distance from model to cage, as a fraction of the diagonal
  bool in_plane = false;  // section corners stay in their slides' planes
  double damping = 0.01;  // of equation (8), as in RefineOptions
  bool tighten = true;    // take volume off again while the cage keeps its certificate
  unsigned threads = 0;   // of the certificate; 0: all
};

struct Enclosure {
  Points points;             // of the cage; its triangles are those that were given
  Certificate certificate;   // of the model as it was given
  bool keeps_delta = false;  // no triangle is nearer to the model than the clearance (in floating point)
  int pushes = 0;            // steps of push_out
  int sweeps = 0;            // of tighten, over all vertices
  std::string
      shortfall;  // where the certificate or the clearance is not earned: which slides, and what to do; else empty
};

// Moves the vertices of a refined cage until it bounds the model, exactly, and then takes off what volume it can:
// push_out.h, untangle.h, tighten.h. Ends with the certificate of whatever was reached; never claims more. `model` is
// what segmentation.cut was cut from. Same bits for any number of threads. Throws Error(cancelled). Thread-safe.
Enclosure enclose(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                  const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options,
                  const Progress& progress = {});

}  // namespace cagewright
