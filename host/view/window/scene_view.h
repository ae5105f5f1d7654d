// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SCENE_VIEW_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SCENE_VIEW_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/file/slides_file.h"
#include "host/file/triangle_mesh.h"

class vtkRenderer;

namespace cagewright::host {

using Matrix4 = std::array<double, 16>;  // rows

// A mesh of the scene. One is active: slides and cage are in its space.
struct ShownMesh {
  int node = -1;
  std::shared_ptr<const TriangleMesh> mesh;
  Matrix4 to_scene{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool is_active = false;  // the others are dim
};

struct ShownSlide {
  std::int64_t id = -1;
  std::string label;  // beside it where it failed or is selected; may be empty
  Slide::Ellipse ellipse;
  bool is_selected = false, is_preview = false;
  bool failed = false;  // dashed, with its label
};

struct ShownCage {
  TriangleMesh mesh;
  std::vector<std::array<Point3, 4>> sections;
  bool is_stale = false;  // paler: it is not of these slides
};

// What is drawn, and how.
struct ViewOptions {
  bool model = true, other_meshes = true, slides = true, sections = true, cage = true, cage_faces = true, grid = true,
       wireframe = false;
  enum class Colours { plain, parts, coverage } colours = Colours::plain;
  bool dark = true;   // background and grid
  bool z_up = false;  // the grid lies across z, else across y
};

struct Ray {
  Point3 origin{}, direction{};  // unit
};

struct Hit {
  enum class What { nothing, model, slide, cage } what = What::nothing;
  std::int64_t slide = -1;
  int node = -1;    // of a model
  Point3 point{};   // in the active mesh's space (of a model: in its own)
  Point3 normal{};  // unit, of the model's triangle
};

// The actors of a window's scene in one renderer, which gets its light, background and render pass from here. No
// document logic: it shows what it is given. Renders nothing by itself. The renderer outlives it. Widths and sizes in
// pixels grow with the window's DPI over 72. Main thread only (VTK).
class SceneView {
 public:
  explicit SceneView(vtkRenderer& renderer);
  ~SceneView();

  void set_meshes(std::vector<ShownMesh> meshes);
  // Colours of the active mesh: of the cut model's parts, or red where its vertices poke out. O(n).
  void set_parts(const TriangleMesh& cut_model, const std::vector<int>& triangle_parts);
  void set_outside(const std::vector<std::uint32_t>& vertices);
  // Those with numbers that are not finite are left out. Only what has changed is uploaded: cheap at every mouse move.
  void set_slides(std::vector<ShownSlide> slides);
  void set_cage(const ShownCage* cage);                // null: none
  void set_stroke(const std::vector<Point3>& points);  // while it is drawn; empty: none
  // A mark on top of everything, in the active mesh's space; empty: none.
  void set_place(const std::optional<Point3>& place);
  // Lines where the active mesh is open, as long as it is the active one. Finding them is O(n log n).
  void show_open_edges(bool shown);
  void set_options(const ViewOptions& options);
  const ViewOptions& options() const;

  // Where display coordinates (VTK's: pixels from the lower left) point to, of what is shown: a slide within a few
  // pixels, else the nearest model, else the cage. `slides_first`: the slide wins also over the model in front of it.
  // Slides without an id (-1) are not found.
  Hit pick(double x, double y, bool slides_first) const;
  // On the active mesh only, also where it is switched off; empty: it is missed. O(log n), the first time O(n).
  std::optional<Hit> pick_model(double x, double y) const;
  Ray ray(double x, double y) const;                            // in the active mesh's space
  std::array<double, 2> to_display(const Point3& point) const;  // of the active mesh's space
  Matrix4 active_to_scene() const;                              // identity where no mesh is active
  // Towards a viewer who would see this place of the active mesh's space, unit, in the scene's space; as straight on
  // its surface as can be. Empty: it is seen well now, or from nowhere, as within the model. O(n).
  std::optional<Point3> direction_to_see(const Point3& place) const;

  // Bounds in the scene's space {x0, x1, y0, y1, z0, z1}; empty: nothing there. Of meshes and slides alone: what is
  // framed does not depend on how far the cage has come.
  std::optional<std::array<double, 6>> bounds() const;
  std::optional<std::array<double, 6>> bounds_of_model() const;  // the active mesh
  std::optional<std::array<double, 6>> bounds_of_slides(const std::vector<std::int64_t>& ids) const;
  std::optional<std::array<double, 6>> bounds_of_place(
      const Point3& place) const;  // a box round it, a quarter of the active mesh's diagonal

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cagewright::host

#endif
