// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SCENE_CONTENT_H
#define CAGEWRIGHT_HOST_SCENE_SCENE_CONTENT_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/file/slides_file.h"
#include "host/file/triangle_mesh.h"

// What of a scene is ours: its slides and cages. docs/scene-format.md says how a file holds them.
namespace cagewright::host {

struct SlideAsRead;  // of scene_parts.h
struct CageAsRead;

struct SceneSlide {
  std::int64_t id = 0;         // > 0, unique in the scene
  std::string name;            // not empty, unique under the mesh node
  int mesh_node = -1;          // the node whose mesh it cuts
  Slide::Ellipse ellipse;      // in that node's local space
  std::vector<Point3> stroke;  // that the ellipse was fitted to; empty where it was not, or no longer is
  std::shared_ptr<const SlideAsRead> as_read;     // the node that the file has, so that nothing else in it is lost
  std::optional<std::array<double, 10>> numbers;  // glTF's, of StoredEllipse: `ellipse` is what they give
};

struct SceneCage {
  std::string name;
  int mesh_node = -1;                                      // the node whose mesh it is round; one cage each
  TriangleMesh mesh;                                       // in that node's local space; a file holds floats
  std::vector<std::pair<std::string, double>> parameters;  // of the plug-in, by id
  std::vector<std::int64_t> slides;                        // ids of those that it was made from
  std::vector<int> sections;                               // of each vertex: row of `slides`, or -1
  std::string certificate;                                 // JSON text, as in the report; empty: none
  std::shared_ptr<const CageAsRead> as_read;               // the node that the file has; what is others' in it is kept
  bool is_as_read = false;                                 // whether all of the above is what the file has
};

// A node of ours that counts for nothing: a second cage of a mesh, one that has lost its mesh, or what cannot be read.
// It stays as it is until it is removed.
struct SceneStray {
  std::string name;
  bool is_cage = false;
  std::shared_ptr<const CageAsRead> as_read;
};

struct SceneContent {
  std::vector<SceneSlide> slides;
  std::vector<SceneCage> cages;
  std::vector<SceneStray> strays;
};

}  // namespace cagewright::host

#endif
