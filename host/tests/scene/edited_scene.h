// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SCENE_EDITED_SCENE_H
#define CAGEWRIGHT_HOST_TESTS_SCENE_EDITED_SCENE_H

#include <array>
#include <functional>
#include <string>

#include "host/file/gltf_json.h"
#include "host/scene/scene_document.h"

// Scenes as another tool leaves them: the JSON of a file of our own scenes is changed as it pleases.
namespace cagewright::host::test {

GltfJson json_of(const SceneDocument& scene);
// Of a file of our own scenes.
GltfJson json_of(const std::string& name);
// The document of the JSON of a .gltf. `name` is for sentences and for the files that it names.
SceneDocument scene_of(const GltfJson& json, const std::string& name = "edited.gltf");

SceneDocument edited(const std::string& name, const std::function<void(GltfJson&)>& edit);
SceneDocument as_it_is(const std::string& name);
bool has_note(const SceneDocument& scene, const std::string& part);
// Removes all of ours.
GltfJson without_ours(SceneDocument& scene);
// Saved and read again.
SceneDocument reloaded(const SceneDocument& scene);

// The only slide of this name; fails the test where there is none and gives an empty one.
SceneSlide slide_called(const SceneDocument& scene, const std::string& name);

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

// A node's own transform, three rows, by glTF's formulas and without our code.
std::array<std::array<double, 4>, 3> transform_in(const GltfJson& node);
// A point of a node's space in the space of its ancestor, or in the scene's where it comes to a root first.
Point3 mapped_up(const GltfJson& json, std::size_t node, std::size_t ancestor, Point3 point);
// 64 points of the unit circle of a node's XY plane are where the ellipse has them in the mesh node's space.
void expect_circle_maps_to(const Slide::Ellipse& ellipse, const GltfJson& json, std::size_t node,
                           std::size_t mesh_node);

// 64 points of one ellipse lie on the other, whichever of its radii come first: 1e-9 of their length.
void expect_same_curve(const Slide::Ellipse& expected, const Slide::Ellipse& given);
void expect_ellipse(const Slide::Ellipse& expected, const Slide::Ellipse& given, double tolerance = 1e-12);

}  // namespace cagewright::host::test

#endif
