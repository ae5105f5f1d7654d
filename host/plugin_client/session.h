// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_SESSION_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_SESSION_H

#include <cagewright/cagewright.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/file/slides_file.h"
#include "host/file/triangle_mesh.h"
#include "host/plugin_client/plugin.h"
#include "host/plugin_client/records.h"

namespace cagewright::host {

// What a session tells while it works, on the calling thread. Neither may throw; either may be empty.
struct SessionListener {
  std::function<void(int level, const std::string& message)> log;               // CGW_LOG_*
  std::function<bool(double fraction, const std::string& stage)> may_continue;  // false cancels
};

struct SlideInfo {
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;  // its name and message are NULL: see below
  std::string name, message;
};

// One model with its slides, parameters and results in the plug-in, which stays loaded as long. One thread at a time.
// Every function throws PluginError, and Cancelled where may_continue answered false.
class Session {
 public:
  Session(std::shared_ptr<const Plugin> plugin, SessionListener listener);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void set_mesh(const TriangleMesh& mesh);
  cgw_mesh_report mesh_report() const;
  void set_parameter(const std::string& id, const std::string& text);
  void set_parameter(const std::string& id, double value);
  double parameter(const std::string& id) const;
  std::uint64_t add_slide(const Slide& slide);
  std::vector<SlideInfo> slides() const;

  // These instead of those that there are.
  void set_slides(const std::vector<Slide>& slides);
  // The slide as an ellipse: what a solve would make of it.
  Slide::Ellipse fit(const Slide& slide) const;

  // threads: 0 for as many as the machine has. editing: few steps of refinement, and no tightening.
  void solve(std::uint32_t threads, bool editing = false);

  // Results. Figures that the plug-in did not write are NaN.
  TriangleMesh cage() const;
  // Of each vertex of the cage: the row of sections() that it is a corner of, or -1.
  std::vector<int> vertex_sections() const;
  std::vector<cgw_section> sections() const;
  std::uint64_t part_count() const;
  cgw_summary summary() const;
  Certificate certificate() const;
  Measures measures() const;
  CutModel cut_model() const;
  // Of each triangle of the cage: the part that it bounds.
  std::vector<int> triangle_parts() const;
  std::vector<IterationRecord> iterations() const;
  // Of each iteration, before its step, in model units.
  std::vector<double> max_signed_distances() const;

 private:
  void check(cgw_status status, const char* call) const { plugin_->check(status, session_, call); }
  const cgw_api& api() const { return plugin_->api(); }

  static void log(void* user, std::int32_t level, const char* message);
  static std::int32_t progress(void* user, double fraction, const char* stage);

  std::shared_ptr<const Plugin> plugin_;
  SessionListener listener_;
  cgw_session* session_ = nullptr;
};

}  // namespace cagewright::host

#endif
