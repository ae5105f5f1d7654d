// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/session.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cagewright::host {
namespace {

constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Session::Session(std::shared_ptr<const Plugin> plugin, SessionListener listener)
    : plugin_(std::move(plugin)), listener_(std::move(listener)) {
  cgw_host host = CGW_HOST_INIT;
  host.user = this;
  host.log = log;
  host.progress = progress;
  check(api().session_create(&host, &session_), "session_create");
}

Session::~Session() { api().session_destroy(session_); }

void Session::log(void* user, std::int32_t level, const char* message) {
  const auto& listener = static_cast<Session*>(user)->listener_;
  if (listener.log && message != nullptr) listener.log(level, message);
}

std::int32_t Session::progress(void* user, double fraction, const char* stage) {
  const auto& listener = static_cast<Session*>(user)->listener_;
  return !listener.may_continue || listener.may_continue(fraction, stage == nullptr ? "" : stage) ? 0 : 1;
}

void Session::set_mesh(const TriangleMesh& mesh) {
  const cgw_mesh borrowed = borrow(mesh);
  check(api().set_mesh(session_, &borrowed), "set_mesh");
}

cgw_mesh_report Session::mesh_report() const {
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  check(api().mesh_report(session_, &report), "mesh_report");
  return report;
}

void Session::set_parameter(const std::string& id, const std::string& text) {
  check(api().set_parameter_text(session_, id.c_str(), text.c_str()), "set_parameter_text");
}

void Session::set_parameter(const std::string& id, double value) {
  check(api().set_parameter(session_, id.c_str(), value), "set_parameter");
}

double Session::parameter(const std::string& id) const {
  double value = 0;
  check(api().get_parameter(session_, id.c_str(), &value), "get_parameter");
  return value;
}

void Session::solve(std::uint32_t threads, bool editing) {
  cgw_solve_options options = CGW_SOLVE_OPTIONS_INIT;
  options.threads = threads;
  const std::uint32_t quickest = api().abi_minor >= 4 ? CGW_EDITING_REFINE : CGW_EDITING_ENCLOSE;
  options.editing = editing ? quickest : CGW_EDITING_NONE;
  check(api().solve(session_, &options), "solve");
}

TriangleMesh Session::cage() const {
  cgw_cage cage = CGW_CAGE_INIT;
  check(api().get_cage(session_, &cage), "get_cage");
  TriangleMesh mesh;
  mesh.points.resize(3 * cage.vertex_count);
  mesh.triangles.resize(3 * cage.triangle_count);
  cage.vertices = mesh.points.data();
  cage.vertex_capacity = cage.vertex_count;
  cage.triangles = mesh.triangles.data();
  cage.triangle_capacity = cage.triangle_count;
  check(api().get_cage(session_, &cage), "get_cage");
  return mesh;
}

std::vector<int> Session::vertex_sections() const {
  cgw_cage cage = CGW_CAGE_INIT;
  check(api().get_cage(session_, &cage), "get_cage");
  std::vector<std::int32_t> sections(cage.vertex_count);
  cage.vertex_section = sections.data();
  cage.vertex_capacity = cage.vertex_count;
  check(api().get_cage(session_, &cage), "get_cage");
  return {sections.begin(), sections.end()};
}

std::vector<cgw_section> Session::sections() const {
  std::vector<cgw_section> sections(api().section_count(session_), cgw_section CGW_SECTION_INIT);
  for (std::size_t i = 0; i < sections.size(); ++i) check(api().get_section(session_, i, &sections[i]), "get_section");
  return sections;
}

std::uint64_t Session::part_count() const {
  cgw_parts parts = CGW_PARTS_INIT;
  check(api().get_parts(session_, &parts), "get_parts");
  return parts.part_count;
}

cgw_summary Session::summary() const {
  cgw_summary summary = CGW_SUMMARY_INIT;
  for (double* figure :
       {&summary.max_signed_distance_over_diagonal, &summary.volume_ratio, &summary.segment_ms, &summary.orient_ms,
        &summary.meshing_ms, &summary.refine_ms, &summary.extent, &summary.enclose_ms}) {
    *figure = not_computed;
  }
  check(api().get_summary(session_, &summary), "get_summary");
  return summary;
}

Certificate Session::certificate() const {
  std::uint64_t findings = 0;
  Certificate certificate = read_certificate([&](cgw_certificate* out) {
    check(api().get_certificate(session_, out), "get_certificate");
    findings = out->finding_count;
  });
  if (!plugin_->has_findings()) return certificate;
  for (std::uint64_t i = 0; i < findings; ++i)
    certificate.findings.push_back(
        read_finding([&](cgw_finding* out) { check(api().get_finding(session_, i, out), "get_finding"); }));
  return certificate;
}

Measures Session::measures() const {
  return read_measures([this](cgw_measures* out) { check(api().get_measures(session_, out), "get_measures"); });
}

std::vector<double> Session::max_signed_distances() const {
  std::vector<double> distances;
  for (std::uint64_t i = 0; i < api().iteration_count(session_); ++i) {
    cgw_iteration iteration = CGW_ITERATION_INIT;
    iteration.max_signed_distance = not_computed;
    check(api().get_iteration(session_, i, &iteration), "get_iteration");
    distances.push_back(iteration.max_signed_distance);
  }
  return distances;
}

}  // namespace cagewright::host
