// SPDX-License-Identifier: BSD-3-Clause
//
// A plug-in for tests of the host alone: its cage is the model's bounding box, and it misbehaves on demand. What it is
// to do stands in the environment variable CAGEWRIGHT_FAKE, words separated by commas:
//   null_table, small_table, other_major, gaps   what cgw_get_api_v1 answers
//   older                 it has ABI 1.2
//   open_cage             the box lacks a triangle
//   short_summary         writes only as much of cgw_summary as an older plug-in knew
//   no_sentence           errors have no sentence
//   wait                  solve reports progress until the host cancels
//   slow, deaf            solve announces itself, then works on for a while, or for ever, without asking the host
//   mesh_log, mesh_deaf   set_mesh says so first, works for ever
//   mesh_open, slides_touch, out_of_memory, internal   how solve or set_mesh fails
#include <cagewright/cagewright.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

struct cgw_session {
  cgw_host host = CGW_HOST_INIT;
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  std::vector<std::string> names;
  std::array<double, 3> low{}, high{};
  double lambda = 4;
  double iterations = 30;
  double scope = 0;
  std::string sentence;
  cgw_error_info error = CGW_ERROR_INFO_INIT;
  bool is_solved = false;
};

struct cgw_evaluation {};

namespace {

thread_local std::string free_sentence;

bool asked(const char* word) {
  const char* text = std::getenv("CAGEWRIGHT_FAKE");
  std::istringstream words(text == nullptr ? "" : text);
  for (std::string other; std::getline(words, other, ',');) {
    if (other == word) return true;
  }
  return false;
}

cgw_status fail(cgw_session* session, cgw_status status, std::string sentence) {
  if (asked("no_sentence")) sentence.clear();
  if (session == nullptr) {
    free_sentence = std::move(sentence);
  } else {
    session->sentence = std::move(sentence);
    session->error.code = status;
  }
  return status;
}

const char* status_name(cgw_status status) {
  switch (status) {
    case CGW_OK:
      return "ok";
    case CGW_SLIDE_UNSOLVED:
      return "unsolved";
    case CGW_ERROR_MESH_OPEN:
      return "mesh_open";
    case CGW_ERROR_INTERNAL:
      return "internal";
    default:
      return "unknown";
  }
}

const char* stage_name(int32_t stage) { return stage == CGW_STAGE_REFINE ? "refine" : "segment"; }

constexpr std::array<const char*, 2> scopes = {"local", "part"};
constexpr double no_limit = std::numeric_limits<double>::infinity();

cgw_status parameter_info(uint32_t index, cgw_parameter* out) {
  const std::array<cgw_parameter, 3> parameters = {
      {{sizeof(cgw_parameter), CGW_PARAM_REAL, "orient.lambda", "Alignment", "Weight of alignment.", "", 4, 0, no_limit,
        nullptr, 0, 0},
       {sizeof(cgw_parameter), CGW_PARAM_INTEGER, "refine.iterations", "Iterations", "At most.", "", 30, 0, 1000,
        nullptr, 0, 0},
       {sizeof(cgw_parameter), CGW_PARAM_CHOICE, "refine.scope", "Scope", "Which vertices.", "", 0, 0, 1, scopes.data(),
        2, 0}}};
  if (index >= parameters.size()) return fail(nullptr, CGW_ERROR_INVALID_ARGUMENT, "no such parameter");
  std::memcpy(out, &parameters[index], std::min<std::size_t>(out->struct_size, sizeof(cgw_parameter)));
  return CGW_OK;
}

// Counts by edges alone, which is all that the host's tests need.
cgw_status inspect_mesh(const cgw_mesh* mesh, cgw_mesh_report* out) {
  if (mesh->triangle_count == 0) return fail(nullptr, CGW_ERROR_MESH_EMPTY, "the mesh has no triangles");
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (uint64_t i = 0; i < 3 * mesh->triangle_count; ++i) {
    const uint32_t a = mesh->triangles[i], b = mesh->triangles[i % 3 == 2 ? i - 2 : i + 1];
    ++edges[{a, b}];
  }
  out->vertices = mesh->vertex_count;
  out->triangles = mesh->triangle_count;
  out->components = 1;
  uint64_t undirected = 0;
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    const int back = opposite == edges.end() ? 0 : opposite->second;
    if (back == 0 || edge.first < edge.second) ++undirected;
    if (count + back == 1) ++out->open_edges;
    if (count + back == 2 && count == 2) ++out->inconsistent_edges;
    if (count + back > 2 && edge.first < edge.second) ++out->non_manifold_edges;
  }
  out->closed = out->open_edges == 0 && out->non_manifold_edges == 0 ? 1 : 0;
  out->consistently_oriented = out->inconsistent_edges == 0 ? 1 : 0;
  const auto euler = static_cast<int64_t>(mesh->vertex_count + mesh->triangle_count) - static_cast<int64_t>(undirected);
  out->genus = out->closed == 1 ? (2 - euler) / 2 : -1;
  for (uint64_t t = 0; t < mesh->triangle_count; ++t) {
    const double* p[3];
    for (uint64_t k = 0; k < 3; ++k) p[k] = mesh->vertices + 3 * mesh->triangles[3 * t + k];
    out->signed_volume +=
        (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
         p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
        6;
  }
  out->inside_out = out->closed == 1 && out->signed_volume < 0 ? 1 : 0;
  out->diagonal = 2;
  return CGW_OK;
}

cgw_status session_create(const cgw_host* host, cgw_session** out) {
  *out = new cgw_session;
  if (host != nullptr) (*out)->host = *host;
  return CGW_OK;
}

void session_destroy(cgw_session* session) { delete session; }

const char* last_error(const cgw_session* session) {
  return session == nullptr ? free_sentence.c_str() : session->sentence.c_str();
}

cgw_status last_error_info(const cgw_session* session, cgw_error_info* out) {
  if (session != nullptr) *out = session->error;
  return CGW_OK;
}

cgw_status set_mesh(cgw_session* session, const cgw_mesh* mesh) {
  if (asked("mesh_log") && session->host.log != nullptr) session->host.log(session->host.user, CGW_LOG_INFO, "mesh");
  while (asked("mesh_deaf")) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  if (asked("mesh_open")) return fail(session, CGW_ERROR_MESH_OPEN, "the mesh has 3 open edges, the first at vertex 7");
  session->points.assign(mesh->vertices, mesh->vertices + 3 * mesh->vertex_count);
  session->triangles.assign(mesh->triangles, mesh->triangles + 3 * mesh->triangle_count);
  session->low.fill(no_limit);
  session->high.fill(-no_limit);
  for (std::size_t i = 0; i < session->points.size(); ++i) {
    session->low[i % 3] = std::min(session->low[i % 3], session->points[i]);
    session->high[i % 3] = std::max(session->high[i % 3], session->points[i]);
  }
  return CGW_OK;
}

cgw_mesh as_mesh(const cgw_session* session) {
  return {sizeof(cgw_mesh),          0,
          session->points.data(),    session->points.size() / 3,
          session->triangles.data(), session->triangles.size() / 3};
}

cgw_status mesh_report(const cgw_session* session, cgw_mesh_report* out) {
  const cgw_mesh mesh = as_mesh(session);
  return inspect_mesh(&mesh, out);
}

double* find_parameter(cgw_session* session, const std::string& id) {
  if (id == "orient.lambda") return &session->lambda;
  if (id == "refine.iterations") return &session->iterations;
  if (id == "refine.scope") return &session->scope;
  return nullptr;
}

cgw_status set_parameter(cgw_session* session, const char* id, double value) {
  double* parameter = find_parameter(session, id);
  if (parameter == nullptr) {
    return fail(session, CGW_ERROR_UNKNOWN_PARAMETER, "there is no parameter \"" + std::string(id) + "\"");
  }
  if (!(value >= 0)) return fail(session, CGW_ERROR_PARAMETER_OUT_OF_RANGE, std::string(id) + " is at least 0");
  *parameter = value;
  return CGW_OK;
}

cgw_status set_parameter_text(cgw_session* session, const char* id, const char* text) {
  if (std::string(text) == "local" || std::string(text) == "part") return set_parameter(session, id, *text == 'p');
  return set_parameter(session, id, std::atof(text));
}

cgw_status get_parameter(const cgw_session* session, const char* id, double* value) {
  const double* parameter = find_parameter(const_cast<cgw_session*>(session), id);
  *value = parameter == nullptr ? 0 : *parameter;
  return CGW_OK;
}

cgw_status slide_add(cgw_session* session, const cgw_slide_input* input, uint64_t* id) {
  if (input->kind == CGW_SLIDE_STROKE && input->stroke_count < 5) {
    return fail(session, CGW_ERROR_STROKE_TOO_SHORT, "slide \"" + std::string(input->name) + "\" has too few points");
  }
  *id = session->names.size();
  session->names.emplace_back(input->name);
  return CGW_OK;
}

cgw_status slide_change(cgw_session*, uint64_t, const cgw_slide_input*) { return CGW_OK; }
cgw_status slide_remove(cgw_session*, uint64_t) { return CGW_OK; }
uint64_t slide_count(const cgw_session* session) { return session->names.size(); }

cgw_status slide_info(const cgw_session* session, uint64_t index, cgw_slide_info* out) {
  out->id = index;
  out->name = session->names[index].c_str();
  out->status = session->is_solved ? CGW_OK : CGW_SLIDE_UNSOLVED;
  out->message = "";
  if (!session->is_solved) return CGW_OK;
  out->has_ellipse = 1;
  out->u[0] = 2;
  out->v[1] = out->normal[2] = 1;
  return CGW_OK;
}

bool goes_on(const cgw_session* session, double fraction, const char* stage) {
  return session->host.progress == nullptr || session->host.progress(session->host.user, fraction, stage) == 0;
}

cgw_status solve(cgw_session* session, const cgw_solve_options*) {
  if (session->host.log != nullptr) session->host.log(session->host.user, CGW_LOG_INFO, "a note\nof two lines");
  if (asked("out_of_memory")) return fail(session, CGW_ERROR_OUT_OF_MEMORY, "not enough memory");
  if (asked("internal")) return fail(session, CGW_ERROR_INTERNAL, "a defect in stage refine");
  if (asked("slides_touch")) return fail(session, CGW_ERROR_SLIDES_TOUCH, "slides \"a\" and \"b\" touch");
  if (!goes_on(session, 0, "segment")) return CGW_CANCELLED;
  while (asked("wait")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (!goes_on(session, 0.5, "refine")) return CGW_CANCELLED;
  }
  if (!goes_on(session, 0.5, "refine")) return CGW_CANCELLED;
  while (asked("deaf")) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  if (asked("slow")) std::this_thread::sleep_for(std::chrono::milliseconds(400));
  session->is_solved = true;
  return CGW_OK;
}

cgw_status get_parts(const cgw_session* session, cgw_parts* out) {
  out->part_count = session->names.size() + 1;
  return CGW_OK;
}

uint64_t section_count(const cgw_session* session) { return session->names.size(); }
cgw_status get_section(const cgw_session*, uint64_t, cgw_section*) { return CGW_OK; }
cgw_status get_loop(const cgw_session*, uint64_t, cgw_loop*) { return CGW_ERROR_NOT_READY; }

cgw_status get_cage(const cgw_session* session, cgw_cage* out) {
  constexpr std::array<uint32_t, 36> box = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  if (!session->is_solved) return CGW_ERROR_NOT_READY;
  out->vertex_count = 8;
  out->triangle_count = asked("open_cage") ? 11 : 12;
  if ((out->vertices != nullptr && out->vertex_capacity < out->vertex_count) ||
      (out->triangles != nullptr && out->triangle_capacity < out->triangle_count)) {
    return CGW_ERROR_BUFFER_TOO_SMALL;
  }
  for (std::size_t i = 0; out->vertices != nullptr && i < 24; ++i) {
    const bool is_high = ((i / 3) >> (i % 3) & 1) != 0;
    out->vertices[i] = is_high ? session->high[i % 3] : session->low[i % 3];
  }
  if (out->vertex_section != nullptr) std::fill_n(out->vertex_section, out->vertex_count, -1);
  if (out->triangles != nullptr) std::copy_n(box.begin(), 3 * out->triangle_count, out->triangles);
  return CGW_OK;
}

uint64_t iteration_count(const cgw_session*) { return 2; }

cgw_status get_iteration(const cgw_session*, uint64_t index, cgw_iteration* out) {
  out->max_signed_distance = index == 0 ? 0.5 : 0.25;
  return CGW_OK;
}

cgw_status get_summary(const cgw_session*, cgw_summary* out) {
  cgw_summary summary = CGW_SUMMARY_INIT;
  summary.last_stage = asked("no_enclose") ? CGW_STAGE_REFINE : CGW_STAGE_ENCLOSE;
  summary.iterations = 2;
  summary.converged = 1;
  summary.max_signed_distance_over_diagonal = 0.0005;
  summary.volume_ratio = 1.5;
  summary.segment_ms = 1;
  summary.orient_ms = 2;
  summary.meshing_ms = std::numeric_limits<double>::quiet_NaN();
  summary.refine_ms = 4;
  summary.extent = 1.75;
  summary.enclose_ms = 5;
  const std::size_t known = asked("short_summary") ? offsetof(cgw_summary, volume_ratio) : sizeof(cgw_summary);
  std::memcpy(out, &summary, std::min<std::size_t>(out->struct_size, known));
  return CGW_OK;
}

cgw_status save_state(const cgw_session*, const cgw_stream*) { return CGW_OK; }
cgw_status load_state(cgw_session*, const cgw_stream*) { return CGW_OK; }

// One pair of cage triangles and one vertex fail where "crossing" is asked for.
cgw_status fill_certificate(cgw_certificate* out) {
  const bool crosses = asked("crossing");
  out->closed = !asked("open_cage");
  out->encloses = out->closed == 1 && !crosses;
  out->keeps_distance = !asked("too_near");
  out->self_intersection_count = out->outside_count = crosses;
  if (crosses && out->self_intersections != nullptr) {
    out->self_intersections[0] = 3;
    out->self_intersections[1] = 7;
  }
  if (crosses && out->outside_vertices != nullptr) out->outside_vertices[0] = 5;
  out->message = crosses ? "move slide 'a'" : "";
  if (out->struct_size >= sizeof(cgw_certificate)) out->finding_count = crosses ? 2 : 0;
  return CGW_OK;
}

cgw_status get_finding(const cgw_session*, uint64_t index, cgw_finding* out) {
  out->message = index == 0 ? "move slide 'a'" : "add one";
  out->has_point = index == 1;
  if (index == 1) out->point[2] = 2.5;
  out->slide_count = index == 0 ? 1 : 0;
  if (index == 0 && out->slides != nullptr) out->slides[0] = 1;
  return CGW_OK;
}
cgw_status get_certificate(const cgw_session*, cgw_certificate* out) { return fill_certificate(out); }

cgw_status fill_measures(cgw_measures* out) {
  out->volume_ratio = 1.5;
  out->mean_gap = 0.25;
  out->max_gap = 0.5;
  out->clearance = 0.125;
  out->coverage = std::numeric_limits<double>::quiet_NaN();
  out->worst_squareness = 0.0625;
  return CGW_OK;
}
cgw_status get_measures(const cgw_session*, cgw_measures* out) { return fill_measures(out); }

cgw_status evaluation_create(const cgw_mesh*, const cgw_mesh*, uint32_t, cgw_evaluation** out) {
  *out = new cgw_evaluation;
  return CGW_OK;
}
void evaluation_destroy(cgw_evaluation* evaluation) { delete evaluation; }
cgw_status evaluation_certificate(const cgw_evaluation*, cgw_certificate* out) { return fill_certificate(out); }
cgw_status evaluation_measures(const cgw_evaluation*, cgw_measures* out) { return fill_measures(out); }

cgw_status slide_fit(const cgw_session*, const cgw_slide_input*, cgw_slide_info* out) {
  out->has_ellipse = 1;
  out->u[0] = 2;
  out->v[1] = out->normal[2] = 1;
  return CGW_OK;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const cgw_api* cgw_get_api_v1(uint32_t) {
  static cgw_api api = {sizeof(cgw_api),
                        CGW_ABI_MAJOR,
                        CGW_ABI_MINOR,
                        3,
                        "0.0.1",
                        status_name,
                        stage_name,
                        parameter_info,
                        inspect_mesh,
                        session_create,
                        session_destroy,
                        last_error,
                        last_error_info,
                        set_mesh,
                        mesh_report,
                        set_parameter,
                        set_parameter_text,
                        get_parameter,
                        slide_add,
                        slide_change,
                        slide_remove,
                        slide_count,
                        slide_info,
                        solve,
                        get_parts,
                        section_count,
                        get_section,
                        get_loop,
                        get_cage,
                        iteration_count,
                        get_iteration,
                        get_summary,
                        save_state,
                        load_state,
                        get_certificate,
                        get_measures,
                        evaluation_create,
                        evaluation_destroy,
                        evaluation_certificate,
                        evaluation_measures,
                        slide_fit,
                        get_finding};
  if (asked("null_table")) return nullptr;
  constexpr std::size_t size_of_1_2 = offsetof(cgw_api, slide_fit);
  api.struct_size = asked("small_table") ? size_of_1_2 - sizeof(void*) : asked("older") ? size_of_1_2 : sizeof(cgw_api);
  api.abi_minor = asked("older") ? 2 : CGW_ABI_MINOR;
  api.slide_fit = asked("older") ? nullptr : slide_fit;
  api.get_finding = asked("older") ? nullptr : get_finding;
  api.abi_major = asked("other_major") ? 2 : CGW_ABI_MAJOR;
  api.load_state = asked("gaps") ? nullptr : load_state;
  return &api;
}
