// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/solve.h"

#include <algorithm>
#include <string>

#include "core/parallel/parallel_for.h"
#include "plugin/src/abi_struct.h"
#include "plugin/src/names.h"

namespace cagewright::plugin {

namespace {

cgw_solve_options checked(const cgw_solve_options* given) {
  const cgw_solve_options defaults = CGW_SOLVE_OPTIONS_INIT;
  const cgw_solve_options options = given ? read_struct(given, defaults, "cgw_solve_options") : defaults;
  if (options.last_stage < CGW_STAGE_SEGMENT || options.last_stage > CGW_STAGE_ENCLOSE) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT,
                   "last_stage is " + std::to_string(options.last_stage) + ", which is none of CGW_STAGE_*");
  }
  if (options.editing > CGW_EDITING_REFINE) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT,
                   "editing is " + std::to_string(options.editing) + ", which is none of CGW_EDITING_*");
  }
  return options;
}

// Tells the host, which cancels by returning nonzero. The fraction never falls, whatever the stages report.
StageProgress progress_of(const cgw_host& host) {
  if (!host.progress) return {};
  return [&host, told = 0.0](double fraction, Stage stage) mutable {
    told = std::max(told, std::min(fraction, 1.0));
    return host.progress(host.user, told, stage_name(static_cast<std::int32_t>(stage))) == 0;
  };
}

// What the core is asked for. Enclosing keeps the distance itself; a refinement that keeps it, too, would only start it
// from farther out. One that leaves the planes of the slides makes it harder to come back to them, and is not what the
// enclosing cage will look like.
PipelineOptions pipeline_options(const Parameters& parameters, const cgw_solve_options& asked) {
  const bool is_editing = asked.editing != CGW_EDITING_NONE, encloses = asked.editing != CGW_EDITING_REFINE;
  PipelineOptions options = parameters.options(is_editing);
  options.last_stage = static_cast<Stage>(encloses ? asked.last_stage : std::min(asked.last_stage, CGW_STAGE_REFINE));
  const bool is_for_enclosing = options.certify && (options.last_stage >= Stage::enclose || !encloses);
  options.refine.in_plane = options.refine.in_plane || (is_for_enclosing && options.enclose.in_plane);
  if (is_for_enclosing && encloses) options.refine.delta = 0;
  options.enclose.tighten = options.enclose.tighten && !is_editing;
  options.enclose.merge = options.enclose.merge && !is_editing;
  options.refine.threads = options.enclose.threads = std::min(thread_count(asked.threads), most_threads);
  return options;
}

void log_shortfalls(const cgw_host& host, const PipelineResult& made) {
  const bool is_certified = made.enclosure && made.enclosure->shortfall.empty();
  if (made.refinement && !made.refinement->converged && !is_certified)
    log(host, CGW_LOG_WARNING, made.refinement->shortfall);
  if (made.enclosure && !is_certified) log(host, CGW_LOG_WARNING, made.enclosure->shortfall);
}

}  // namespace

void solve(cgw_session& session, const cgw_solve_options* given) {
  const cgw_solve_options asked = checked(given);
  const PipelineOptions options = pipeline_options(session.parameters, asked);
  auto results = std::make_unique<Results>();
  results->slide_ids = session.slides.ids();
  results->diagonal = model_of(session).diagonal;
  results->threads = options.refine.threads;
  try {
    results->made = make_cage(model_of(session), session.slides.on_model(model_of(session).mesh), options,
                              progress_of(session.host));
  } catch (const Error& error) {
    std::vector<AbiError> translated = {to_abi_error(error, results->slide_ids)};
    for (const Error& other : error.others()) translated.push_back(to_abi_error(other, results->slide_ids));
    if (error.code() != ErrorCode::cancelled) session.slides.blame(translated);
    throw translated.front();
  }
  if (asked.editing == CGW_EDITING_NONE)
    log_shortfalls(session.host, results->made);  // before the change: a host's log may throw
  session.slides.settle(results->made.segmentation.ellipses);
  session.results = std::move(results);
}

}  // namespace cagewright::plugin
