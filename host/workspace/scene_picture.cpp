// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/scene_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace cagewright::host {
namespace {

bool is_at_fault(const CageState& cage, std::int64_t id) {
  return std::ranges::any_of(cage.problems, [&](const Problem& it) {
    return !it.is_advice && std::ranges::find(it.slides, id) != it.slides.end();
  });
}

}  // namespace

PictureInput scene_picture(const Workspace& workspace) {
  PictureInput input;
  const TriangleMesh& mesh = workspace.mesh();
  const CageState& cage = workspace.cage();
  input.model_points = mesh.points;
  input.model_triangles = mesh.triangles;
  input.cage_points = cage.cage.points;
  input.cage_triangles = cage.cage.triangles;
  for (const SceneSlide* slide : workspace.slides()) {
    input.slides.push_back({slide->ellipse.center, slide->ellipse.u, slide->ellipse.v, is_at_fault(cage, slide->id)});
  }
  for (std::size_t k = 0; k < cage.sections.size(); ++k) {
    if (cage.sections_merged[k]) continue;
    std::array<double, 12> corners{};
    for (std::size_t i = 0; i < 12; ++i) corners[i] = cage.sections[k][i / 3][i % 3];
    input.sections.push_back(corners);
  }
  return input;
}

PictureInput session_picture(const Session& session, const TriangleMesh& model, const TriangleMesh& cage,
                             const std::vector<double>& cage_points) {
  PictureInput input;
  input.model_points = model.points;
  input.model_triangles = model.triangles;
  input.cage_points = cage_points;
  input.cage_triangles = cage.triangles;
  for (const SlideInfo& slide : session.slides()) {
    if (slide.info.has_ellipse != 1) continue;
    input.slides.push_back({std::to_array(slide.info.center), std::to_array(slide.info.u), std::to_array(slide.info.v),
                            slide.info.status != CGW_OK});
  }
  return input;
}

std::vector<View> turntable(const View& first, std::size_t frames) {
  const Eigen::Vector3d up = Eigen::Vector3d::Map(first.up.data()).stableNormalized();
  std::vector<View> views(frames, first);
  for (std::size_t k = 0; k < frames; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(frames);
    const Eigen::Vector3d toward = Eigen::AngleAxisd(angle, up) * Eigen::Vector3d::Map(first.toward_viewer.data());
    views[k].toward_viewer = {toward.x(), toward.y(), toward.z()};
  }
  return views;
}

}  // namespace cagewright::host
