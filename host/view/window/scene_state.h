// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SCENE_STATE_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SCENE_STATE_H

#include <vtkCallbackCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "host/view/window/cage_actors.h"
#include "host/view/window/ground_grid.h"
#include "host/view/window/line_actor.h"
#include "host/view/window/mesh_picker.h"
#include "host/view/window/place_mark.h"
#include "host/view/window/scene_view.h"
#include "host/view/window/slide_actors.h"
#include "host/view/window/slide_labels.h"
#include "host/view/window/still_layer.h"
#include "host/view/window/surface_actor.h"
#include "host/view/window/vertex_marks.h"

namespace cagewright::host {

// One mesh of the scene with what draws and picks it.
struct MeshEntry {
  ShownMesh shown;
  std::unique_ptr<SurfaceActor> surface;
  std::unique_ptr<MeshPicker> picker;
  Eigen::Matrix4d to_scene, from_scene;
  bool is_flat = false;        // to_scene has no inverse: nothing of it can be picked
  Eigen::AlignedBox3d bounds;  // in the scene's space
};

// What SceneView keeps; scene_view.cpp fills it, scene_pick.cpp asks it.
struct SceneView::State {
  explicit State(vtkRenderer& of);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const MeshEntry* active() const;
  bool shows(const MeshEntry& entry) const;
  Eigen::Matrix4d active_to_scene() const;    // identity where none is active
  Eigen::Matrix4d active_from_scene() const;  // likewise, and where it is flat
  void apply_transform();                     // the active mesh's, to all that is in its space
  void apply_look();                          // options and colours
  void apply_background();
  void before_frame();
  void fit_grid();
  void make_parts();
  std::vector<vtkProp*> models() const;
  void colour_outside();

  vtkRenderer& renderer;
  ViewOptions options;
  std::vector<MeshEntry> meshes;

  TriangleMesh cut_model;  // empty: no parts are known
  std::vector<int> cut_model_parts;
  std::unique_ptr<SurfaceActor> parts;  // null until they are shown
  std::vector<std::uint32_t> outside;
  bool outside_is_coloured = false;  // the active mesh has the colours of `outside`

  std::vector<ShownSlide> slides;
  std::optional<ShownCage> cage;

  GroundGrid grid;
  VertexMarks outside_marks;
  CageActors cage_actors;
  SlideActors slide_actors;
  SlideLabels slide_labels;
  PlaceMark place_mark;
  LineActor stroke, open_edges;
  std::shared_ptr<const TriangleMesh> mesh_of_open_edges;  // null: they are not known
  bool shows_open_edges = false;
  vtkNew<vtkLight> light;
  vtkNew<vtkRenderStepsPass> pass;
  vtkNew<StillLayer> still_layer;
  vtkNew<vtkCallbackCommand> frame_listener;
};

}  // namespace cagewright::host

#endif
