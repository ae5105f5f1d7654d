// SPDX-License-Identifier: BSD-3-Clause
//
// The table of the C ABI. Every entry: barrier, then one call of what does the work.
#include <memory>
#include <string>

#include "cagewright/cagewright.h"
#include "core/mesh/inspect.h"
#include "plugin/src/abi_struct.h"
#include "plugin/src/barrier.h"
#include "plugin/src/evaluation.h"
#include "plugin/src/input.h"
#include "plugin/src/names.h"
#include "plugin/src/parameters.h"
#include "plugin/src/results.h"
#include "plugin/src/session.h"
#include "plugin/src/solve.h"
#include "plugin/src/state.h"

namespace {

using namespace cagewright::plugin;

void require(const void* pointer, const char* what) {
  if (!pointer) throw AbiError(CGW_ERROR_INVALID_ARGUMENT, std::string(what) + " is NULL");
}

const LastError& error_of(const cgw_session* session) { return session ? session->last_error : thread_error(); }

cgw_status parameter_info(std::uint32_t index, cgw_parameter* out) {
  return guard(thread_error(), [&] {
    common_size(out, "cgw_parameter");
    if (index >= Parameters::count) {
      throw AbiError(CGW_ERROR_UNKNOWN_PARAMETER, "there is no parameter at index " + std::to_string(index) +
                                                      "; the plug-in has " + std::to_string(Parameters::count));
    }
    write_struct(out, Parameters::list()[index], "cgw_parameter");
  });
}

cgw_status inspect_mesh(const cgw_mesh* mesh, cgw_mesh_report* out) {
  return guard(thread_error(), [&] {
    common_size(out, "cgw_mesh_report");
    write_struct(out, to_abi(cagewright::inspect(to_mesh(mesh))), "cgw_mesh_report");
  });
}

cgw_status session_create(const cgw_host* host, cgw_session** out) {
  return guard(thread_error(), [&] {
    require(out, "where to put the session");
    *out = make_session(host).release();
  });
}

void session_destroy(cgw_session* session) {
  if (!session) return;
  guard(thread_error(), [&] {
    { const Call no_other(session->busy); }
    delete session;
  });
}

const char* last_error(const cgw_session* session) { return error_of(session).sentence; }

cgw_status last_error_info(const cgw_session* session, cgw_error_info* out) {
  const cgw_error_info info = error_of(session).info;
  return guard(session ? session->last_error : thread_error(), [&] { write_struct(out, info, "cgw_error_info"); });
}

cgw_status set_mesh(cgw_session* session, const cgw_mesh* mesh) {
  return guard_session(session, [&](cgw_session& s) { cagewright::plugin::set_mesh(s, mesh); });
}

cgw_status mesh_report(const cgw_session* session, cgw_mesh_report* out) {
  return guard_session(session, [&](const cgw_session& s) {
    common_size(out, "cgw_mesh_report");
    write_struct(out, to_abi(model_of(s).report), "cgw_mesh_report");
  });
}

cgw_status set_parameter(cgw_session* session, const char* id, double value) {
  return guard_session(session, [&](cgw_session& s) {
    require(id, "the parameter's id");
    s.parameters.set(id, value);
  });
}

cgw_status set_parameter_text(cgw_session* session, const char* id, const char* text) {
  return guard_session(session, [&](cgw_session& s) {
    require(id, "the parameter's id");
    require(text, "the parameter's text");
    s.parameters.set_text(id, text);
  });
}

cgw_status get_parameter(const cgw_session* session, const char* id, double* value) {
  return guard_session(session, [&](const cgw_session& s) {
    require(id, "the parameter's id");
    require(value, "where to put the parameter's value");
    *value = s.parameters.get(id);
  });
}

cgw_status slide_add(cgw_session* session, const cgw_slide_input* input, std::uint64_t* id) {
  return guard_session(session, [&](cgw_session& s) {
    require(id, "where to put the slide's id");
    *id = s.slides.add(to_slide(input));
  });
}

cgw_status slide_change(cgw_session* session, std::uint64_t id, const cgw_slide_input* input) {
  return guard_session(session, [&](cgw_session& s) { s.slides.change(id, to_slide(input)); });
}

cgw_status slide_remove(cgw_session* session, std::uint64_t id) {
  return guard_session(session, [&](cgw_session& s) { s.slides.remove(id); });
}

std::uint64_t slide_count(const cgw_session* session) {
  std::uint64_t count = 0;
  guard_session(session, [&](const cgw_session& s) { count = s.slides.size(); });
  return count;
}

cgw_status slide_info(const cgw_session* session, std::uint64_t index, cgw_slide_info* out) {
  return guard_session(session, [&](const cgw_session& s) { read_slide(s, index, out); });
}

cgw_status slide_fit(const cgw_session* session, const cgw_slide_input* input, cgw_slide_info* out) {
  return guard_session(session, [&](const cgw_session& s) { fit_slide(s, input, out); });
}

cgw_status solve(cgw_session* session, const cgw_solve_options* options) {
  return guard_session(session, [&](cgw_session& s) { cagewright::plugin::solve(s, options); });
}

cgw_status get_parts(const cgw_session* session, cgw_parts* out) {
  return guard_session(session, [&](const cgw_session& s) { read_parts(s, out); });
}

std::uint64_t section_count(const cgw_session* session) {
  std::uint64_t count = 0;
  guard_session(session, [&](const cgw_session& s) { count = cagewright::plugin::section_count(s); });
  return count;
}

cgw_status get_section(const cgw_session* session, std::uint64_t index, cgw_section* out) {
  return guard_session(session, [&](const cgw_session& s) { read_section(s, index, out); });
}

cgw_status get_loop(const cgw_session* session, std::uint64_t index, cgw_loop* out) {
  return guard_session(session, [&](const cgw_session& s) { read_loop(s, index, out); });
}

cgw_status get_cage(const cgw_session* session, cgw_cage* out) {
  return guard_session(session, [&](const cgw_session& s) { read_cage(s, out); });
}

std::uint64_t iteration_count(const cgw_session* session) {
  std::uint64_t count = 0;
  guard_session(session, [&](const cgw_session& s) { count = cagewright::plugin::iteration_count(s); });
  return count;
}

cgw_status get_iteration(const cgw_session* session, std::uint64_t index, cgw_iteration* out) {
  return guard_session(session, [&](const cgw_session& s) { read_iteration(s, index, out); });
}

cgw_status get_summary(const cgw_session* session, cgw_summary* out) {
  return guard_session(session, [&](const cgw_session& s) { read_summary(s, out); });
}

cgw_status save_state(const cgw_session* session, const cgw_stream* stream) {
  return guard_session(session, [&](const cgw_session& s) { cagewright::plugin::save_state(s, stream); });
}

cgw_status load_state(cgw_session* session, const cgw_stream* stream) {
  return guard_session(session, [&](cgw_session& s) { cagewright::plugin::load_state(s, stream); });
}

cgw_status get_certificate(const cgw_session* session, cgw_certificate* out) {
  return guard_session(session, [&](const cgw_session& s) {
    common_size(out, "cgw_certificate");
    read_certificate(certificate_of(s), out);
  });
}

cgw_status get_finding(const cgw_session* session, std::uint64_t index, cgw_finding* out) {
  return guard_session(session, [&](const cgw_session& s) {
    common_size(out, "cgw_finding");
    const CageCertificate& certificate = certificate_of(s);
    read_finding(certificate, s.results->slide_ids, index, out);
  });
}

cgw_status get_measures(const cgw_session* session, cgw_measures* out) {
  return guard_session(session, [&](const cgw_session& s) {
    common_size(out, "cgw_measures");
    read_measures(figures_of(s), out);
  });
}

cgw_status evaluation_create(const cgw_mesh* model, const cgw_mesh* cage, std::uint32_t threads, cgw_evaluation** out) {
  return guard(thread_error(), [&] {
    require(out, "where to put the evaluation");
    *out = evaluate(model, cage, threads).release();
  });
}

void evaluation_destroy(cgw_evaluation* evaluation) { delete evaluation; }

cgw_status evaluation_certificate(const cgw_evaluation* evaluation, cgw_certificate* out) {
  return guard(thread_error(), [&] {
    require(evaluation, "the evaluation");
    read_certificate(evaluation->certificate, out);
  });
}

cgw_status evaluation_measures(const cgw_evaluation* evaluation, cgw_measures* out) {
  return guard(thread_error(), [&] {
    require(evaluation, "the evaluation");
    read_measures(evaluation->figures, out);
  });
}

constexpr cgw_api api = {
    .struct_size = sizeof(cgw_api),
    .abi_major = CGW_ABI_MAJOR,
    .abi_minor = CGW_ABI_MINOR,
    .parameter_count = Parameters::count,
    .version = CAGEWRIGHT_VERSION,
    .status_name = status_name,
    .stage_name = stage_name,
    .parameter_info = parameter_info,
    .inspect_mesh = inspect_mesh,
    .session_create = session_create,
    .session_destroy = session_destroy,
    .last_error = last_error,
    .last_error_info = last_error_info,
    .set_mesh = set_mesh,
    .mesh_report = mesh_report,
    .set_parameter = set_parameter,
    .set_parameter_text = set_parameter_text,
    .get_parameter = get_parameter,
    .slide_add = slide_add,
    .slide_change = slide_change,
    .slide_remove = slide_remove,
    .slide_count = slide_count,
    .slide_info = slide_info,
    .solve = solve,
    .get_parts = get_parts,
    .section_count = section_count,
    .get_section = get_section,
    .get_loop = get_loop,
    .get_cage = get_cage,
    .iteration_count = iteration_count,
    .get_iteration = get_iteration,
    .get_summary = get_summary,
    .save_state = save_state,
    .load_state = load_state,
    .get_certificate = get_certificate,
    .get_measures = get_measures,
    .evaluation_create = evaluation_create,
    .evaluation_destroy = evaluation_destroy,
    .evaluation_certificate = evaluation_certificate,
    .evaluation_measures = evaluation_measures,
    .slide_fit = slide_fit,
    .get_finding = get_finding,
};

}  // namespace

// Tables grow at their end only, so that this one serves a host of any minor version.
extern "C" __attribute__((visibility("default"))) const cgw_api* cgw_get_api_v1(std::uint32_t) { return &api; }
