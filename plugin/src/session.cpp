// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/session.h"

#include <algorithm>
#include <string>

#include "core/slide/plane_loops.h"
#include "plugin/src/abi_struct.h"
#include "plugin/src/input.h"

namespace cagewright::plugin {

namespace {

// "193,600"
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

// "1 bow-tie vertex", "2 bow-tie vertices"
std::string counted(std::size_t number, const char* one, const char* many) {
  return grouped(number) + " " + (number == 1 ? one : many);
}

void log_report(const cgw_host& host, const MeshReport& report) {
  if (report.welded_vertices > 0) {
    log(host, CGW_LOG_INFO,
        counted(report.welded_vertices, "vertex was", "vertices were") + " merged into others at the same position");
  }
  if (report.unused_vertices > 0) {
    log(host, CGW_LOG_INFO,
        counted(report.unused_vertices, "vertex is", "vertices are") + " used by no triangle and left out");
  }
  if (report.degenerate_triangles > 0) {
    log(host, CGW_LOG_WARNING,
        counted(report.degenerate_triangles, "triangle names", "triangles name") + " a position twice; dropped");
  }
  if (report.bow_tie_vertices > 0) {
    log(host, CGW_LOG_WARNING,
        counted(report.bow_tie_vertices, "vertex joins", "vertices join") +
            " several fans of triangles (a bow-tie); split" +
            (report.first_bow_tie ? ", the first at " + to_text(*report.first_bow_tie) : std::string()));
  }
  if (report.turned_triangles > 0) {
    log(host, CGW_LOG_WARNING,
        std::string(report.inside_out ? "the model was inside out: " : "the triangles did not all face outward: ") +
            counted(report.turned_triangles, "triangle", "triangles") + " turned");
  }
}

std::int32_t kind_of(const SlideDefinition& definition) {
  if (std::holds_alternative<StrokeDefinition>(definition)) return CGW_SLIDE_STROKE;
  if (std::holds_alternative<PointNormalDefinition>(definition)) return CGW_SLIDE_POINT_NORMAL;
  if (std::holds_alternative<PointDefinition>(definition)) return CGW_SLIDE_POINT;
  return CGW_SLIDE_ELLIPSE;
}

void copy_ellipse(const Ellipse& ellipse, cgw_slide_info& info) {
  info.has_ellipse = 1;
  std::copy_n(ellipse.center.data(), 3, info.center);
  std::copy_n(ellipse.normal.data(), 3, info.normal);
  std::copy_n(ellipse.u.data(), 3, info.u);
  std::copy_n(ellipse.v.data(), 3, info.v);
}

}  // namespace

void log(const cgw_host& host, std::int32_t level, const std::string& message) {
  if (host.log) host.log(host.user, level, message.c_str());
}

cgw_mesh_report to_abi(const MeshReport& report) {
  cgw_mesh_report out = CGW_MESH_REPORT_INIT;
  out.closed = report.closed();
  out.consistently_oriented = report.consistently_oriented();
  out.inside_out = report.inside_out;
  out.vertices = report.vertices;
  out.triangles = report.triangles;
  out.welded_vertices = report.welded_vertices;
  out.degenerate_triangles = report.degenerate_triangles;
  out.unused_vertices = report.unused_vertices;
  out.open_edges = report.open_edges;
  out.non_manifold_edges = report.non_manifold_edges;
  out.inconsistent_edges = report.inconsistent_edges;
  out.bow_tie_vertices = report.bow_tie_vertices;
  out.turned_triangles = report.turned_triangles;
  out.components = report.components;
  out.genus = report.genus.value_or(-1);
  out.signed_volume = report.signed_volume;
  out.diagonal = report.diagonal();
  std::copy_n(report.box_min.data(), 3, out.box_min);
  std::copy_n(report.box_max.data(), 3, out.box_max);
  return out;
}

std::unique_ptr<cgw_session> make_session(const cgw_host* host) {
  auto session = std::make_unique<cgw_session>();
  if (host) session->host = read_struct<cgw_host>(host, CGW_HOST_INIT, "cgw_host");
  return session;
}

void set_mesh(cgw_session& session, const cgw_mesh* mesh) {
  auto model = std::make_unique<const Model>(prepare_model(to_mesh(mesh)));
  log_report(session.host, model->report);  // before the swap: a host's log that throws must not leave half a change
  session.model = std::move(model);
  session.results.reset();
  session.slides.forget_model();
}

const Model& model_of(const cgw_session& session) {
  if (!session.model) throw AbiError(CGW_ERROR_NOT_READY, "the session has no model yet; call set_mesh first");
  return *session.model;
}

void read_slide(const cgw_session& session, std::uint64_t index, cgw_slide_info* out) {
  common_size(out, "cgw_slide_info");
  if (index >= session.slides.size()) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT, "there is no slide at index " + std::to_string(index) +
                                                   "; the session has " + std::to_string(session.slides.size()));
  }
  const SlideEntry& entry = session.slides.at(index);
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  info.kind = kind_of(entry.slide.definition);
  info.id = entry.id;
  info.name = entry.slide.name.c_str();
  info.status = entry.status;
  info.message = entry.message.c_str();
  if (entry.ellipse) copy_ellipse(*entry.ellipse, info);
  write_struct(out, info, "cgw_slide_info");
}

void fit_slide(const cgw_session& session, const cgw_slide_input* input, cgw_slide_info* out) {
  common_size(out, "cgw_slide_info");
  const Slide slide = to_slide_or_nameless(input);
  const SlideOnModel placed = place_slide(model_of(session).mesh, model_of(session).edge_blocks, slide, 0);
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  info.kind = kind_of(slide.definition);
  info.id = CGW_NO_ID;
  info.name = info.message = "";
  copy_ellipse(placed.ellipse, info);
  write_struct(out, info, "cgw_slide_info");
}

}  // namespace cagewright::plugin
