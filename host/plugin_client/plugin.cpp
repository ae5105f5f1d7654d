// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "host/plugin_client/plugin_error.h"
#include "host/plugin_client/whole_library.h"

namespace cagewright::host {
namespace {

std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

std::string last_loader_error() { return text_or_empty(::dlerror()); }

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
  throw PluginLoadError(path.string() + ": is no plug-in for this program: " + reason);
}

void require_whole(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) return;  // whoever opens it says why
  if (const auto needed = bytes_of_whole_library(path); needed && bytes < *needed)
    throw PluginLoadError(path.string() + ": the plug-in cannot be loaded: the file is cut short, after " +
                          std::to_string(bytes) + " of " + std::to_string(*needed) + " bytes or more: copy it again");
}

// What this program cannot do without: ABI 1.2.
constexpr std::size_t needed_size = offsetof(cgw_api, slide_fit);

// The table ends in functions, and none of them is optional.
bool has_gaps(const cgw_api& api) {
  const char* end = reinterpret_cast<const char*>(&api) + std::min<std::size_t>(api.struct_size, sizeof(cgw_api));
  for (auto at = reinterpret_cast<const char*>(&api.status_name); at + sizeof(void*) <= end; at += sizeof(void*)) {
    void* function = nullptr;
    std::memcpy(&function, at, sizeof(function));
    if (function == nullptr) return true;
  }
  return false;
}

void check_abi(const std::filesystem::path& path, const cgw_api* api) {
  const std::string host_version = std::to_string(CGW_ABI_MAJOR) + "." + std::to_string(CGW_ABI_MINOR);
  if (api == nullptr) refuse(path, "it does not serve ABI " + host_version);
  if (api->struct_size < needed_size) {
    refuse(path, "its table of functions has " + std::to_string(api->struct_size) + " bytes, this program needs " +
                     std::to_string(needed_size));
  }
  if (api->abi_major != CGW_ABI_MAJOR) {
    refuse(path, "it has ABI " + std::to_string(api->abi_major) + "." + std::to_string(api->abi_minor) +
                     ", this program ABI " + host_version);
  }
  if (has_gaps(*api)) refuse(path, "its table of functions has gaps");
}

}  // namespace

void Plugin::Unload::operator()(void* library) const { ::dlclose(library); }

Plugin::Plugin(std::filesystem::path path, std::unique_ptr<void, Unload> library, const cgw_api* api)
    : path_(std::move(path)), library_(std::move(library)), api_(api) {}

std::shared_ptr<const Plugin> Plugin::load(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw PluginLoadError(path.string() + ": there is no such plug-in");
  require_whole(path);
  // A name without a slash would be looked for in the system's folders.
  const std::string absolute = std::filesystem::absolute(path).string();
  std::unique_ptr<void, Unload> library(::dlopen(absolute.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (library == nullptr)
    throw PluginLoadError(path.string() + ": the plug-in cannot be loaded: " + last_loader_error());
  void* entry = ::dlsym(library.get(), CGW_ENTRY_POINT);
  if (entry == nullptr) refuse(path, "it has no function " CGW_ENTRY_POINT);
  const cgw_api* api = reinterpret_cast<cgw_get_api_fn>(entry)(CGW_ABI_MINOR);
  check_abi(path, api);
  return std::shared_ptr<const Plugin>(new Plugin(path, std::move(library), api));
}

bool Plugin::has_findings() const {
  return api_->struct_size >= offsetof(cgw_api, get_finding) + sizeof(api_->get_finding);
}

bool Plugin::has_slide_fit() const { return api_->struct_size >= needed_size + sizeof(api_->slide_fit); }

std::string Plugin::version() const { return text_or_empty(api_->version); }

std::string Plugin::status_name(cgw_status status) const { return text_or_empty(api_->status_name(status)); }

std::vector<Parameter> Plugin::parameters() const {
  std::vector<Parameter> parameters;
  for (std::uint32_t i = 0; i < api_->parameter_count; ++i) {
    cgw_parameter info = CGW_PARAMETER_INIT;
    check(api_->parameter_info(i, &info), nullptr, "parameter_info");
    Parameter parameter{info.type,
                        text_or_empty(info.id),
                        text_or_empty(info.label),
                        text_or_empty(info.doc),
                        text_or_empty(info.unit),
                        info.default_value,
                        info.minimum,
                        info.maximum,
                        {}};
    for (std::uint32_t choice = 0; info.choices != nullptr && choice < info.choice_count; ++choice) {
      parameter.choices.push_back(text_or_empty(info.choices[choice]));
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

cgw_mesh_report Plugin::inspect(const TriangleMesh& mesh) const {
  const cgw_mesh borrowed = borrow(mesh);
  cgw_mesh_report report = CGW_MESH_REPORT_INIT;
  check(api_->inspect_mesh(&borrowed, &report), nullptr, "inspect_mesh");
  return report;
}

Plugin::Evaluation Plugin::evaluate(const TriangleMesh& model, const TriangleMesh& cage, std::uint32_t threads) const {
  const cgw_mesh borrowed_model = borrow(model), borrowed_cage = borrow(cage);
  cgw_evaluation* made = nullptr;
  check(api_->evaluation_create(&borrowed_model, &borrowed_cage, threads, &made), nullptr, "evaluation_create");
  const std::unique_ptr<cgw_evaluation, void (*)(cgw_evaluation*)> evaluation(made, api_->evaluation_destroy);
  return {read_certificate([&](cgw_certificate* out) {
            check(api_->evaluation_certificate(made, out), nullptr, "evaluation_certificate");
          }),
          read_measures(
              [&](cgw_measures* out) { check(api_->evaluation_measures(made, out), nullptr, "evaluation_measures"); })};
}

void Plugin::check(cgw_status status, const cgw_session* session, const char* call) const {
  if (status == CGW_OK) return;
  if (status == CGW_CANCELLED) throw Cancelled();
  // The sentence first: it lives until the next call.
  std::string sentence = text_or_empty(api_->last_error(session));
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  if (api_->last_error_info(session, &info) != CGW_OK) info = CGW_ERROR_INFO_INIT;
  info.code = status;
  if (sentence.empty()) sentence = std::string("the plug-in's ") + call + " failed (" + status_name(status) + ")";
  throw PluginError(info, sentence);
}

cgw_mesh borrow(const TriangleMesh& mesh) {
  cgw_mesh borrowed = CGW_MESH_INIT;
  borrowed.vertices = mesh.points.data();
  borrowed.vertex_count = mesh.vertex_count();
  borrowed.triangles = mesh.triangles.data();
  borrowed.triangle_count = mesh.triangle_count();
  return borrowed;
}

bool is_closed_manifold(const cgw_mesh_report& report) {
  return report.closed == 1 && report.inconsistent_edges == 0 && report.bow_tie_vertices == 0;
}

}  // namespace cagewright::host
