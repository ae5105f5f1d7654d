// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/pipeline.h"

#include <chrono>
#include <set>

#include "core/error/error.h"
#include "core/mesh/inspect.h"

namespace cagewright {
namespace {

class Stopwatch {
 public:
  double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Where each stage ends on the progress bar: about its share of the time on a model of 50,000 triangles.
constexpr double segment_end = 0.2, meshing_end = 0.25, refine_end = 0.35;

NeighbourPairs neighbours_of(const Segmentation& segmentation) {
  std::set<std::pair<int, int>> pairs;
  for (const Part& part : segmentation.parts)
    for (std::size_t i = 0; i < part.sections.size(); ++i)
      for (std::size_t j = i + 1; j < part.sections.size(); ++j)
        pairs.emplace(part.sections[i].slide, part.sections[j].slide);
  return {pairs.begin(), pairs.end()};
}

void measure(const Model& model, PipelineResult& result) {
  const MeshReport report = inspect({result.cage->points, result.cage->triangles});
  result.cage_genus = report.genus;
  result.volume_ratio = report.signed_volume / model.volume;
}

}  // namespace

PipelineResult make_cage(const Model& model, const std::vector<Slide>& slides, const PipelineOptions& options,
                         const StageProgress& progress) {
  const auto part_of_progress = [&](double begin, double end, Stage stage) -> Progress {
    if (!progress) return {};
    return [=, &progress](double fraction) { return progress(begin + fraction * (end - begin), stage); };
  };
  std::vector<std::string> names;
  for (const Slide& slide : slides) names.push_back(slide.name);
  PipelineResult result;
  const auto finish = [&] {
    if (progress && !progress(1, result.last_stage)) throw Error(ErrorCode::cancelled, "cancelled");
    return std::move(result);
  };
  Stopwatch watch;
  const bool encloses = options.last_stage >= Stage::enclose && options.certify;
  result.segmentation = segment(model, slides, part_of_progress(0, segment_end, Stage::segment));
  result.segment_ms = watch.lap_ms();
  result.neighbours = neighbours_of(result.segmentation);
  result.last_stage = Stage::segment;
  if (options.last_stage == Stage::segment) return finish();

  if (progress && !progress(segment_end, Stage::orient)) throw Error(ErrorCode::cancelled, "cancelled");
  result.sections = orient(result.segmentation.ellipses, result.neighbours, options.lambda, options.orient_minimum);
  result.orient_ms = watch.lap_ms();
  result.last_stage = Stage::orient;
  if (options.last_stage == Stage::orient) return finish();

  if (progress && !progress(segment_end, Stage::meshing)) throw Error(ErrorCode::cancelled, "cancelled");
  result.cage = mesh_cage(result.segmentation, result.sections, names);
  result.meshing_ms = watch.lap_ms();
  result.last_stage = Stage::meshing;
  if (options.last_stage >= Stage::refine) {
    result.refinement = refine(result.segmentation, result.sections, *result.cage, model.diagonal, names,
                               options.refine, part_of_progress(meshing_end, encloses ? refine_end : 1, Stage::refine));
    result.cage = result.refinement->cage;
    result.refine_ms = watch.lap_ms();
    result.last_stage = Stage::refine;
  }
  if (encloses) {
    result.enclosure = enclose(model, result.segmentation, result.sections, *result.cage, names, options.enclose,
                               part_of_progress(refine_end, 1, Stage::enclose));
    if (result.enclosure->merged)
      result.cage = result.enclosure->merged;
    else
      result.cage->points = result.enclosure->points;
    result.enclose_ms = watch.lap_ms();
    result.last_stage = Stage::enclose;
  }
  measure(model, result);
  return finish();
}

}  // namespace cagewright
