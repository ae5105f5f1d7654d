// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cagewright/cagewright.h"
#include "core/mesh/prepare.h"
#include "core/pipeline/pipeline.h"
#include "plugin/src/barrier.h"
#include "plugin/src/evaluation.h"
#include "plugin/src/parameters.h"
#include "plugin/src/slides.h"

namespace cagewright::plugin {

// What a successful solve made.
struct Results {
  PipelineResult made;
  std::vector<std::uint64_t> slide_ids;                // of the slides at the time, in the order of the sections
  double diagonal = 0;                                 // of the model, model units
  unsigned threads = 0;                                // that the solve could use
  mutable std::optional<CageCertificate> certificate;  // of the cage, once somebody has asked for it
  mutable std::optional<CageFigures> figures;          // the same
};

inline constexpr unsigned most_threads = 256;  // more would only wait for each other

// Writes to the host's log where it has one. Not noexcept: what a host throws goes to the barrier.
void log(const cgw_host& host, std::int32_t level, const std::string& message);

cgw_mesh_report to_abi(const MeshReport& report);

}  // namespace cagewright::plugin

// One model with its slides, parameters and results. The functions below throw AbiError or Error, and leave the session
// as it was where they throw.
struct cgw_session {
  cgw_host host = CGW_HOST_INIT;
  cagewright::plugin::Parameters parameters;
  cagewright::plugin::SlideList slides;
  std::unique_ptr<const cagewright::Model> model;              // NULL before set_mesh
  std::unique_ptr<const cagewright::plugin::Results> results;  // NULL before the first good solve
  mutable cagewright::plugin::LastError last_error;            // reading calls can fail, too
  mutable std::atomic<bool> busy = false;                      // a call is running
};

namespace cagewright::plugin {

// `host` may be NULL.
std::unique_ptr<cgw_session> make_session(const cgw_host* host);

// Prepares the model, tells the log what had to be mended, drops the results. Throws Error: those of prepare_model.
void set_mesh(cgw_session& session, const cgw_mesh* mesh);

// Throws AbiError(NOT_READY) before set_mesh.
const Model& model_of(const cgw_session& session);

// The slide at `index` as the host sees it. Throws AbiError(INVALID_ARGUMENT).
void read_slide(const cgw_session& session, std::uint64_t index, cgw_slide_info* out);

// What ellipse the slide would have on the session's model. Throws AbiError: NOT_READY, INVALID_ARGUMENT; Error: those
// of place_slide.
void fit_slide(const cgw_session& session, const cgw_slide_input* input, cgw_slide_info* out);

}  // namespace cagewright::plugin
