// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/slide_fitter.h"

#include <utility>

namespace cagewright::host {

SlideFitter::SlideFitter(std::shared_ptr<const Plugin> plugin) : plugin_(std::move(plugin)) {}

void SlideFitter::prepare(const std::shared_ptr<const TriangleMesh>& mesh) {
  if (mesh == mesh_) return;
  const auto with_mesh = [plugin = plugin_, mesh] {
    auto session = std::make_shared<Session>(plugin, SessionListener{});
    session->set_mesh(*mesh);
    return session;
  };
  session_ = {};  // two big meshes at a time would be one too many
  session_ = std::async(std::launch::async, with_mesh).share();
  mesh_ = mesh;
}

Slide::Ellipse SlideFitter::fit(const std::shared_ptr<const TriangleMesh>& mesh, const Slide& slide) {
  prepare(mesh);
  return session_.get()->fit(slide);
}

}  // namespace cagewright::host
