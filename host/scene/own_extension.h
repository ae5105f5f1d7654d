// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_OWN_EXTENSION_H
#define CAGEWRIGHT_HOST_SCENE_OWN_EXTENSION_H

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/file/gltf_json.h"
#include "host/scene/scene_content.h"
#include "host/scene/slide_transform.h"

// The JSON of the extensions CAGEWRIGHT_cut_slide and CAGEWRIGHT_cage and of the same keys in `extras`, as
// docs/scene-format.md defines them.
namespace cagewright::host {

// By which a node that has lost its mesh node finds it again; may be empty.
struct SourceNames {
  std::string node, mesh;
};

struct OwnSlideExtension {
  std::int64_t id = 0;
  SourceNames source;
  std::optional<Eigen::Affine3d> pose;  // from the mesh, as the scene showed it, to its node; empty: the identity
  std::vector<Point3> stroke;
  std::optional<TranslationRotationScale> fitted;
  std::vector<std::string> keeps;
};

struct OwnCageExtension {
  SceneCage cage;  // its parameters, slides, sections and certificate
  SourceNames source;
  std::optional<Eigen::Affine3d> pose;
  std::vector<std::string> keeps;
};

// Of a whole node. Throw FileError, with `place` before the reason, where a value is of the wrong type.
OwnSlideExtension read_slide_extension(const std::filesystem::path& path, const std::string& place,
                                       const GltfJson& node);
OwnCageExtension read_cage_extension(const std::filesystem::path& path, const std::string& place, const GltfJson& node);

// The mesh node that a slide or a cage belongs to.
struct SourceNode {
  int node = -1;
  SourceNames names;
  std::optional<Eigen::Affine3d> pose;
};

// Put the extension and its shadow in `extras` into a node. What others have there stays, also in the extension, and
// so does the text of numbers that are the same.
void write_slide_extension(const SceneSlide& slide, const SourceNode& source,
                           const std::optional<TranslationRotationScale>& fitted, GltfJson& node);
void write_cage_extension(const SceneCage& cage, const SourceNode& source, GltfJson& node);
// On any node that has one of ours.
void write_keeps(const std::set<std::string>& keeps, GltfJson& node);

// Takes both out of a node, and `extensions` or `extras` where nothing else is in them.
void remove_own_extensions(GltfJson& node);

}  // namespace cagewright::host

#endif
