// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_SESSION_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_SESSION_H

#include <cagewright/cagewright.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
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
  // Slides, in the order in which they were added. Ids are the plug-in's, never given twice.
  std::uint64_t add_slide(const Slide& slide);
  void change_slide(std::uint64_t id, const Slide& slide);  // id and place in the order stay
  void remove_slide(std::uint64_t id);
  // Makes the session's slides those given, in their order, and returns their ids. Slides keep their ids, and what the
  // plug-in found for them, up to the first place where one comes in between or the order differs; a slide that has
  // another shape, or another name in the same place, is changed. Where one is refused, the slides are as before (but
  // some may have new ids), and info().slide of the error is its id only where it has one.
  std::vector<std::uint64_t> set_slides(const std::vector<Slide>& slides);
  std::size_t slide_count() const { return slides_.size(); }
  // Ellipses and, of the last solve, which slides it blames and why: of slides that touch, both.
  std::vector<SlideInfo> slides() const;
  // The ellipse that a slide would have on the mesh, without adding it. Its name may be empty. Throws PluginError
  // (CGW_ERROR_INVALID_ARGUMENT) where the plug-in is older than ABI 1.3, too.
  Slide::Ellipse fit(const Slide& slide) const;

  // threads: 0 for as many as the machine has. editing: while something is dragged; fewer iterations, and not enclosed
  // (by a plug-in older than ABI 1.4: enclosed, which is slower).
  void solve(std::uint32_t threads, bool editing = false);

  // Results. Figures that the plug-in did not write are NaN.
  TriangleMesh cage() const;
  // Of each vertex of the cage: the row of sections() that it is a corner of, or -1.
  std::vector<int> vertex_sections() const;
  std::vector<cgw_section> sections() const;  // one a slide, in the order of the slides at the time of the solve
  std::vector<Point3> loop(std::size_t index) const;  // of section `index`: where its slide cuts the model; closed
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

  void follow(const std::vector<Slide>& slides);  // set_slides without its promise for failures

  static void log(void* user, std::int32_t level, const char* message);
  static std::int32_t progress(void* user, double fraction, const char* stage);

  std::shared_ptr<const Plugin> plugin_;
  SessionListener listener_;
  cgw_session* session_ = nullptr;
  std::vector<std::pair<std::uint64_t, Slide>> slides_;  // as the plug-in has them, by id
};

}  // namespace cagewright::host

#endif
