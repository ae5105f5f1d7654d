// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "core/enclose/enclose.h"
#include "core/orient/orient.h"
#include "core/refine/refine.h"

namespace cagewright {

enum class Stage { segment = 1, orient = 2, meshing = 3, refine = 4, enclose = 5 };

struct PipelineOptions {
  double lambda = 4;  // of equation (5)
  OrientMinimum orient_minimum = OrientMinimum::linear;
  RefineOptions refine;
  bool certify = true;  // false: the stage enclose is passed over
  EncloseOptions enclose;
  Stage last_stage = Stage::refine;  // the paper's
};

// Everything the stages made, up to the last one asked for.
struct PipelineResult {
  Stage last_stage = Stage::segment;
  Segmentation segmentation;
  NeighbourPairs neighbours;           // slides that bound the same part
  std::vector<SectionFrame> sections;  // after orient
  std::optional<Cage> cage;            // after meshing: as the last stage left it
  std::optional<Refinement> refinement;
  std::optional<Enclosure> enclosure;
  std::optional<long> cage_genus;
  std::optional<double> volume_ratio;  // cage over model
  double segment_ms = 0, orient_ms = 0, meshing_ms = 0, refine_ms = 0, enclose_ms = 0;
};

// Told the fraction of the whole, never falling, and the stage; returns false to cancel.
using StageProgress = std::function<bool(double fraction, Stage stage)>;

// Runs the paper's pipeline (3.1 to 3.4) and what earns the certificate, up to options.last_stage. Throws Error: those
// of the stages. Thread-safe.
PipelineResult make_cage(const Model& model, const std::vector<Slide>& slides, const PipelineOptions& options,
                         const StageProgress& progress = {});

}  // namespace cagewright
