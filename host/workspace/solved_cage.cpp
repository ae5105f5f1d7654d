// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/solved_cage.h"

#include <algorithm>
#include <map>
#include <string>

#include "host/workspace/describe_run.h"
#include "host/workspace/slide_names.h"

namespace cagewright::host {
namespace {

// Ids of the session's slides to the request's, by their names.
std::map<std::uint64_t, std::int64_t> ids_of(const std::vector<SlideInfo>& slides, const SolveRequest& request) {
  std::map<std::uint64_t, std::int64_t> ids;
  for (const SlideInfo& slide : slides) {
    for (const auto& [id, asked] : request.slides) {
      if (asked.name == slide.name) ids.emplace(slide.info.id, id);
    }
  }
  return ids;
}

void read_sections(const Session& session, const SolveRequest& request, CageState& state) {
  const auto ids = ids_of(session.slides(), request);
  for (const cgw_section& section : session.sections()) {
    std::array<Point3, 4> corners{};
    for (std::size_t i = 0; i < 12; ++i) corners[i / 3][i % 3] = section.corners[i];
    state.sections.push_back(corners);
    const auto id = ids.find(section.slide);
    state.section_slides.push_back(id == ids.end() ? -1 : id->second);
    state.sections_merged.push_back(std::ranges::find(section.cage_vertex, -1) != std::end(section.cage_vertex));
  }
}

void read_findings(const Session& session, const SolveRequest& request, CageState& state) {
  const auto ids = ids_of(session.slides(), request);
  for (const Finding& finding : state.certificate->findings) {
    Problem problem{finding.sentence, {}, finding.place, finding.is_advice};
    for (const std::uint64_t id : finding.slides)
      if (const auto found = ids.find(id); found != ids.end()) problem.slides.push_back(found->second);
    state.findings.push_back(std::move(problem));
  }
}

bool names(const std::string& sentence, const std::string& slide) {
  return sentence.find("'" + slide + "'") != std::string::npos;
}

// With all slides that its sentence names. The ABI has no place of it: the slide's middle stands for it.
Problem problem_of(const SlideInfo& slide, const SolveRequest& request) {
  Problem problem{slide.message, {}, {}};
  for (const auto& [id, asked] : request.slides) {
    if (asked.name != slide.name && !names(slide.message, asked.name)) continue;
    problem.slides.push_back(id);
    if (const auto* ellipse = std::get_if<Slide::Ellipse>(&asked.shape); ellipse && asked.name == slide.name)
      problem.place = ellipse->center;
  }
  return problem;
}

// The one that stands for all findings, of a plug-in that does not list them.
Problem problem_of_message(const std::string& message, const SolveRequest& request) {
  Problem problem{message, {}, {}};
  if (message.empty()) problem.sentence = "the cage does not enclose the model: add slides or move them";
  for (const auto& [id, slide] : request.slides) {
    if (names(message, slide.name)) problem.slides.push_back(id);
  }
  return problem;
}

}  // namespace

CageState read_cage_state(const Plugin& plugin, const Session& session, const SolveRequest& request) {
  CageState state;
  state.is_of_editing = request.editing;
  state.cage = session.cage();
  state.triangle_parts = session.triangle_parts();
  state.vertex_sections = session.vertex_sections();
  read_sections(session, request, state);
  state.summary = session.summary();
  if (request.editing) return state;
  CutModel cut = session.cut_model();
  state.cut_model = std::move(cut.mesh);
  state.cut_model_parts = std::move(cut.triangle_part);
  state.certificate = session.certificate();
  read_findings(session, request, state);
  state.measures = session.measures();
  state.report = std::make_shared<Report>(
      describe_run({{"threads", std::int64_t{0}}}, plugin, session, state.cage, plugin.inspect(state.cage)));
  const double diagonal = session.mesh_report().diagonal;
  for (const double distance : session.max_signed_distances()) {
    state.max_signed_distances.push_back(distance / diagonal);
  }
  state.max_signed_distances.push_back(state.summary.max_signed_distance_over_diagonal);
  return state;
}

std::vector<Problem> problems_of(const PluginError& error, const Session* session, const SolveRequest& request) {
  const std::vector<SlideInfo> slides = session ? session->slides() : std::vector<SlideInfo>();
  const auto ids = ids_of(slides, request);
  Problem first{error.what(), {}, {}};
  const auto blame_slide = [&](std::int64_t id) {
    if (std::ranges::find(first.slides, id) == first.slides.end()) first.slides.push_back(id);
  };
  for (const std::uint64_t id : {error.info().slide, error.info().other_slide}) {
    if (const auto found = ids.find(id); found != ids.end()) blame_slide(found->second);
  }
  // Of a slide that the session did not even take there is no id.
  if (first.slides.empty() && blame(error.status()) == Blame::slides) {
    for (const auto& [id, slide] : request.slides) {
      if (names(first.sentence, slide.name)) blame_slide(id);
    }
  }
  if (error.info().has_point == 1) first.place = std::to_array(error.info().point);
  std::vector<Problem> problems;
  for (const SlideInfo& slide : slides) {
    const auto id = ids.find(slide.info.id);
    if (id == ids.end() || slide.info.status == CGW_OK || slide.info.status == CGW_SLIDE_UNSOLVED) continue;
    if (slide.message == first.sentence) {
      blame_slide(id->second);
    } else if (std::ranges::find(first.slides, id->second) == first.slides.end()) {
      const auto same = std::ranges::find(problems, slide.message, &Problem::sentence);
      if (same == problems.end()) problems.push_back(problem_of(slide, request));
    }
  }
  problems.insert(problems.begin(), std::move(first));
  for (Problem& problem : problems) problem.sentence = without_echo(std::move(problem.sentence));
  return problems;
}

std::vector<Problem> problems_of(const CageState& state, const SolveRequest& request) {
  const bool was_asked_for = state.summary.last_stage >= CGW_STAGE_ENCLOSE;
  if (!state.certificate || !was_asked_for) return {};
  const Certificate& certificate = *state.certificate;
  const bool is_good = certificate.encloses && certificate.keeps_distance;
  std::vector<Problem> problems = state.findings;
  if (problems.empty() && !(is_good && certificate.message.empty())) {
    problems.push_back(problem_of_message(certificate.message, request));
    problems.back().is_advice = is_good;
  }
  for (Problem& problem : problems) {
    problem.sentence = without_echo(std::move(problem.sentence));
    if (problem.place || certificate.vertices_outside.empty() || !request.mesh) continue;
    const std::size_t row = 3 * std::size_t{certificate.vertices_outside.front()};
    const std::vector<double>& points = request.mesh->points;
    if (row + 2 < points.size()) problem.place = Point3{points[row], points[row + 1], points[row + 2]};
  }
  return problems;
}

}  // namespace cagewright::host
