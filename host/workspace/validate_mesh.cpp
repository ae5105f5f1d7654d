// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/validate_mesh.h"

#include "host/plugin_client/plugin_error.h"
#include "host/workspace/scene_picture.h"

namespace cagewright::host {
namespace {

std::string picture_of(const Session& session, const TriangleMesh& model, const TriangleMesh& cage,
                       const std::vector<double>& cage_points) {
  PictureOptions options;
  options.width = 960;
  options.height = 600;
  const std::vector<std::uint8_t> png = render_picture(session_picture(session, model, cage, cage_points), options);
  return {png.begin(), png.end()};
}

void set_up(Session& session, const Workspace& workspace) {
  for (const Parameter& parameter : workspace.plugin()->parameters()) {
    const bool is_merging = parameter.id == "enclose.merge";
    session.set_parameter(parameter.id, is_merging ? 0 : workspace.parameter(parameter.id));
  }
  session.set_mesh(workspace.mesh());
  for (const SceneSlide* slide : workspace.slides()) session.add_slide({slide->name, slide->ellipse});
}

}  // namespace

std::vector<PagePicture> validation_pictures(const Session& session, const TriangleMesh& model,
                                             const TriangleMesh& cage, const Validation& validation) {
  const auto picture = [&](const std::vector<double>& points) { return picture_of(session, model, cage, points); };
  std::vector<PagePicture> pictures = {{"The plug-in's cage", picture(cage.points)}};
  if (const std::optional<Optimality>& tighter = validation.optimality) {
    pictures.push_back({"What Ceres made of it, sections in plane and in shape", picture(tighter->shaped.vertices)});
    pictures.push_back({"What Ceres made of it, sections free", picture(tighter->free.vertices)});
  }
  return pictures;
}

MeshValidation validate_mesh(const Workspace& workspace, const ValidationOptions& options,
                             const std::function<bool()>& is_interrupted) {
  if (!workspace.has_scene() || workspace.mesh_node() < 0) throw CommandError("there is no mesh to validate: open one");
  if (!workspace.plugin()) throw CommandError("no plug-in is loaded, so there is nothing to validate: load one");
  const auto goes_on = [&](double, const std::string&) { return !is_interrupted || !is_interrupted(); };
  Session session(workspace.plugin(), {{}, goes_on});
  set_up(session, workspace);
  session.solve(options.threads);
  MeshValidation found;
  const TriangleMesh& model = workspace.mesh();
  found.report = {workspace.path().string(),
                  CAGEWRIGHT_VERSION,
                  {{"plugin", workspace.plugin()->path().string()},
                   {"plugin version", workspace.plugin()->version()},
                   {"starts", std::to_string(options.starts)},
                   {"seconds", std::to_string(options.seconds)}},
                  {validate(*workspace.plugin(), session, model, options, goes_on)}};
  try {
    require_display();
    found.pictures = validation_pictures(session, model, session.cage(), found.report.cages.front());
  } catch (const PictureError& error) {
    found.why_no_pictures = error.what();
  }
  return found;
}

std::string validation_page(const MeshValidation& found) {
  using Pictures = std::vector<std::vector<PagePicture>>;
  return validation_page(found.report, found.pictures.empty() ? Pictures() : Pictures{found.pictures},
                         found.why_no_pictures);
}

}  // namespace cagewright::host
