// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/evaluation.h"

#include <algorithm>
#include <limits>

#include "core/mesh/weld.h"
#include "core/parallel/parallel_for.h"
#include "plugin/src/abi_struct.h"
#include "plugin/src/buffers.h"
#include "plugin/src/input.h"
#include "plugin/src/session.h"

namespace cagewright::plugin {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The rows of the certified meshes in those of the host. An empty list: the same.
struct GivenRows {
  std::vector<int> model_vertices, model_triangles, cage_triangles;
};

int given(const std::vector<int>& rows, int row) { return rows.empty() ? row : rows[static_cast<std::size_t>(row)]; }

void name_given_rows(const GivenRows& rows, Certificate& certificate) {
  for (int& t : certificate.degenerate_triangles) t = given(rows.cage_triangles, t);
  for (auto& [s, t] : certificate.self_intersections) {
    s = given(rows.cage_triangles, s);
    t = given(rows.cage_triangles, t);
  }
  for (auto& [t, wall] : certificate.model_cage_intersections) {
    t = given(rows.model_triangles, t);
    wall = given(rows.cage_triangles, wall);
  }
  for (int& v : certificate.vertices_outside) v = given(rows.model_vertices, v);
}

void add_dropped_triangles(const WeldedMesh& welded, Eigen::Index given_count, Certificate& certificate) {
  std::size_t kept = 0;
  for (int t = 0; t < static_cast<int>(given_count); ++t) {
    if (kept < welded.given_rows.size() && welded.given_rows[kept] == t) {
      ++kept;
    } else {
      certificate.degenerate_triangles.push_back(t);
    }
  }
  std::sort(certificate.degenerate_triangles.begin(), certificate.degenerate_triangles.end());
}

// Products of three lengths, as volumes are, have to be numbers.
void require_range(const Points& points) {
  constexpr double largest = 1e100;
  if (points.cwiseAbs().maxCoeff() <= largest) return;
  throw Error(ErrorCode::mesh_not_finite,
              "it reaches beyond 1e100, where volumes are no floating-point numbers: scale it");
}

// `body` with the name of the mesh that an error is about.
template <class Body>
auto of_mesh(const char* name, const Body& body) {
  try {
    return body();
  } catch (const Error& error) {
    throw Error(error.code(), std::string(name) + ": " + error.what(), error.place());
  } catch (const AbiError& error) {
    throw AbiError(error.info(), std::string(name) + ": " + error.what());
  }
}

}  // namespace

std::unique_ptr<cgw_evaluation> evaluate(const cgw_mesh* model, const cgw_mesh* cage, std::uint32_t threads) {
  const unsigned workers = std::min(thread_count(threads), most_threads);
  const WeldedMesh welded_model = of_mesh("the model", [&] { return weld(to_mesh(model)); });
  const IndexedMesh given_cage = of_mesh("the cage", [&] { return to_mesh(cage); });
  const WeldedMesh welded_cage = of_mesh("the cage", [&] { return weld(given_cage); });
  of_mesh("the model", [&] { require_range(welded_model.mesh.points); });
  of_mesh("the cage", [&] { require_range(welded_cage.mesh.points); });
  auto evaluation = std::make_unique<cgw_evaluation>();
  Certificate& found = evaluation->certificate.found;
  found = certify(welded_model.mesh, welded_cage.mesh, workers);
  evaluation->figures.measures = measure_cage(welded_model.mesh, welded_cage.mesh, found, workers);
  name_given_rows({find_given_vertices(welded_model), welded_model.given_rows, welded_cage.given_rows}, found);
  add_dropped_triangles(welded_cage, given_cage.triangles.rows(), found);
  return evaluation;
}

const CageCertificate& certificate_of(const cgw_session& session) {
  if (!session.results || !session.results->made.cage) not_ready("cage");
  const Results& results = *session.results;
  if (results.certificate) return *results.certificate;
  const Model& model = model_of(session);
  CageCertificate certificate;
  if (const auto& enclosure = results.made.enclosure) {
    certificate = {enclosure->certificate, enclosure->keeps_delta, enclosure->shortfall, enclosure->findings};
  } else {
    certificate.found = certify(to_indexed_mesh(model.mesh), {results.made.cage->points, results.made.cage->triangles},
                                results.threads);
  }
  name_given_rows({model.given_vertices, model.given_triangles, {}}, certificate.found);
  return results.certificate.emplace(std::move(certificate));
}

const CageFigures& figures_of(const cgw_session& session) {
  if (!session.results || !session.results->made.cage) not_ready("cage");
  const Results& results = *session.results;
  if (results.figures) return *results.figures;
  const PipelineResult& made = results.made;
  const IndexedMesh model = to_indexed_mesh(model_of(session).mesh), cage{made.cage->points, made.cage->triangles};
  CageFigures figures;
  figures.measures =
      measure_cage(model, cage, made.enclosure ? made.enclosure->certificate : certify(model, cage, results.threads),
                   results.threads);
  figures.sections = measure_sections(place_sections(made.sections, *made.cage), made.neighbours, results.diagonal);
  figures.neighbours = made.neighbours;
  return results.figures.emplace(std::move(figures));
}

void read_certificate(const CageCertificate& certificate, cgw_certificate* out) {
  cgw_certificate c = read_struct<cgw_certificate>(out, CGW_CERTIFICATE_INIT, "cgw_certificate");
  const Certificate& found = certificate.found;
  c.encloses = found.encloses();
  c.closed = found.closed;
  c.keeps_distance = certificate.keeps_distance;
  c.degenerate_count = found.degenerate_triangles.size();
  c.self_intersection_count = found.self_intersections.size();
  c.model_intersection_count = found.model_cage_intersections.size();
  c.outside_count = found.vertices_outside.size();
  c.message = certificate.message.c_str();
  c.finding_count = certificate.findings.size();
  write_struct(out, c, "cgw_certificate");
  check_room(c.degenerate_triangles, c.degenerate_capacity, c.degenerate_count, "degenerate triangles");
  check_room(c.self_intersections, c.self_intersection_capacity, c.self_intersection_count, "self-intersections");
  check_room(c.model_intersections, c.model_intersection_capacity, c.model_intersection_count, "model's intersections");
  check_room(c.outside_vertices, c.outside_capacity, c.outside_count, "vertices outside");
  copy_list(found.degenerate_triangles, c.degenerate_triangles);
  copy_pairs(found.self_intersections, c.self_intersections);
  copy_pairs(found.model_cage_intersections, c.model_intersections);
  copy_list(found.vertices_outside, c.outside_vertices);
}

void read_finding(const CageCertificate& certificate, const std::vector<std::uint64_t>& slide_ids, std::uint64_t index,
                  cgw_finding* out) {
  cgw_finding f = read_struct<cgw_finding>(out, CGW_FINDING_INIT, "cgw_finding");
  check_index(index, certificate.findings.size(), "finding");
  const Finding& finding = certificate.findings[index];
  f.has_point = finding.place.has_value();
  for (int axis = 0; axis < 3; ++axis) f.point[axis] = finding.place ? (*finding.place)(axis) : 0;
  f.message = finding.sentence.c_str();
  f.slide_count = finding.slides.size();
  f.is_advice = finding.is_advice;
  write_struct(out, f, "cgw_finding");
  check_room(f.slides, f.slide_capacity, f.slide_count, "slides");
  std::vector<std::uint64_t> ids;
  for (const int slide : finding.slides) ids.push_back(slide_ids[static_cast<std::size_t>(slide)]);
  copy_list(ids, f.slides);
}

void read_measures(const CageFigures& figures, cgw_measures* out) {
  cgw_measures m = read_struct<cgw_measures>(out, CGW_MEASURES_INIT, "cgw_measures");
  const auto& [tightness, shape, asymmetry] = figures.measures;
  m.volume_ratio = tightness.volume_ratio.value_or(unknown);
  m.mean_gap = tightness.mean_gap;
  m.max_gap = tightness.max_gap;
  m.coverage = tightness.coverage.value_or(unknown);
  m.clearance = tightness.clearance;
  m.least_dihedral = shape.least_dihedral.value_or(unknown);
  m.greatest_dihedral = shape.greatest_dihedral.value_or(unknown);
  m.greatest_aspect = shape.greatest_aspect;
  m.mean_asymmetry = asymmetry ? asymmetry->mean : unknown;
  m.max_asymmetry = asymmetry ? asymmetry->max : unknown;
  const SectionQuality none;
  const SectionQuality& sections = figures.sections ? *figures.sections : none;
  m.worst_squareness = figures.sections ? sections.worst_squareness() : unknown;
  m.worst_planarity = figures.sections ? sections.worst_planarity() : unknown;
  m.worst_twist = figures.sections ? sections.worst_twist() : unknown;
  m.section_count = sections.squareness.size();
  m.twist_count = sections.twist.size();
  write_struct(out, m, "cgw_measures");
  check_room(m.squareness, m.section_capacity, m.section_count, "sections' squareness");
  check_room(m.planarity, m.section_capacity, m.section_count, "sections' planarity");
  check_room(m.twist, m.twist_capacity, m.twist_count, "twists");
  check_room(m.twist_between, m.twist_capacity, m.twist_count, "twists' sections");
  copy_list(sections.squareness, m.squareness);
  copy_list(sections.planarity, m.planarity);
  copy_list(sections.twist, m.twist);
  copy_pairs(figures.neighbours, m.twist_between);
}

}  // namespace cagewright::plugin
