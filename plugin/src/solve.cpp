// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/solve.h"

#include <algorithm>
#include <string>

#include "core/parallel/parallel_for.h"
#include "plugin/src/abi_struct.h"
#include "plugin/src/names.h"

namespace cagewright::plugin {

namespace {

constexpr unsigned most_threads = 256;  // more would only wait for each other

cgw_solve_options checked(const cgw_solve_options* given) {
  const cgw_solve_options defaults = CGW_SOLVE_OPTIONS_INIT;
  const cgw_solve_options options = given ? read_struct(given, defaults, "cgw_solve_options") : defaults;
  if (options.last_stage < CGW_STAGE_SEGMENT || options.last_stage > CGW_STAGE_REFINE) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT,
                   "last_stage is " + std::to_string(options.last_stage) + ", which is none of CGW_STAGE_*");
  }
  if (options.editing > 1) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT,
                   "editing is " + std::to_string(options.editing) + "; it has to be 0 or 1");
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

}  // namespace

void solve(cgw_session& session, const cgw_solve_options* given) {
  const cgw_solve_options asked = checked(given);
  PipelineOptions options = session.parameters.options(asked.editing == 1);
  options.last_stage = static_cast<Stage>(asked.last_stage);
  options.refine.threads = std::min(thread_count(asked.threads), most_threads);

  auto results = std::make_unique<Results>();
  results->slide_ids = session.slides.ids();
  results->diagonal = model_of(session).diagonal;
  results->threads = options.refine.threads;
  try {
    results->made = make_cage(model_of(session), session.slides.definitions(), options, progress_of(session.host));
  } catch (const Error& error) {
    const AbiError translated = to_abi_error(error, results->slide_ids);
    if (error.code() != ErrorCode::cancelled) session.slides.blame(translated);
    throw translated;
  }
  const auto& refinement = results->made.refinement;
  if (refinement && !refinement->converged && asked.editing == 0)
    log(session.host, CGW_LOG_WARNING, refinement->shortfall);  // before the change: a host's log may throw
  session.slides.settle(results->made.segmentation.ellipses);
  session.results = std::move(results);
}

}  // namespace cagewright::plugin
