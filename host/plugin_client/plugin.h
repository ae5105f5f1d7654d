// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_PLUGIN_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_PLUGIN_H

#include <cagewright/cagewright.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/file/triangle_mesh.h"
#include "host/plugin_client/certificate.h"

namespace cagewright::host {

// A parameter as the plug-in describes it.
struct Parameter {
  int type = CGW_PARAM_REAL;
  std::string id, label, doc, unit;
  double default_value = 0, minimum = 0, maximum = 0;
  std::vector<std::string> choices;
};

// The loaded plug-in; unloaded when its last owner (sessions own it too) goes.
class Plugin {
 public:
  // Opens `path`, looks up the entry point and checks the ABI. Throws PluginLoadError.
  static std::shared_ptr<const Plugin> load(const std::filesystem::path& path);

  // What a plug-in of an earlier minor version than 1.3 does not have is not there: see has_slide_fit and has_findings.
  const cgw_api& api() const { return *api_; }
  bool has_slide_fit() const;  // since 1.3
  bool has_findings() const;   // since 1.5
  const std::filesystem::path& path() const { return path_; }
  std::string version() const;
  // Of a call or a slide: "ok", "unsolved", "slides_touch" ...
  std::string status_name(cgw_status status) const;

  // In the plug-in's order. Throws PluginError.
  std::vector<Parameter> parameters() const;
  // Counts what a mesh is, open or not. Throws PluginError.
  cgw_mesh_report inspect(const TriangleMesh& mesh) const;
  // What any cage is to any model. threads: 0 for as many as the machine has. Throws PluginError.
  struct Evaluation {
    Certificate certificate;
    Measures measures;
  };
  Evaluation evaluate(const TriangleMesh& model, const TriangleMesh& cage, std::uint32_t threads) const;

  // For session and what follows: throws PluginError or Cancelled unless `status` is CGW_OK. session may be NULL.
  void check(cgw_status status, const cgw_session* session, const char* call) const;

 private:
  struct Unload {
    void operator()(void* library) const;
  };

  Plugin(std::filesystem::path path, std::unique_ptr<void, Unload> library, const cgw_api* api);

  std::filesystem::path path_;
  std::unique_ptr<void, Unload> library_;
  const cgw_api* api_;
};

// The mesh as the ABI takes it; borrows.
cgw_mesh borrow(const TriangleMesh& mesh);

// Whether every edge has two triangles that run along it in opposite directions, and every vertex one fan.
bool is_closed_manifold(const cgw_mesh_report& report);

}  // namespace cagewright::host

#endif
