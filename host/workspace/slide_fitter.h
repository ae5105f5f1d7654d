// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SLIDE_FITTER_H
#define CAGEWRIGHT_HOST_WORKSPACE_SLIDE_FITTER_H

#include <future>
#include <memory>

#include "host/plugin_client/session.h"

namespace cagewright::host {

// Fits slides to one mesh at a time, in a session of its own, beside the one that makes the cage. The plug-in takes a
// mesh on a thread of the fitter's: a million triangles take it a second and more. Owner's thread only.
class SlideFitter {
 public:
  explicit SlideFitter(std::shared_ptr<const Plugin> plugin);

  // Has the plug-in take this mesh, and returns at once; the same pointer is the same mesh, which it has already. Waits
  // where it is still taking another one.
  void prepare(const std::shared_ptr<const TriangleMesh>& mesh);
  // prepare, waits for that, and fits. Throws what Session::set_mesh and Session::fit throw.
  Slide::Ellipse fit(const std::shared_ptr<const TriangleMesh>& mesh, const Slide& slide);

 private:
  std::shared_ptr<const Plugin> plugin_;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_future<std::shared_ptr<Session>> session_;  // with mesh_; its destructor waits for the thread
};

}  // namespace cagewright::host

#endif
