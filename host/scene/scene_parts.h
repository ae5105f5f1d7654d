// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SCENE_PARTS_H
#define CAGEWRIGHT_HOST_SCENE_SCENE_PARTS_H

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/file/gltf_json.h"
#include "host/scene/scene_content.h"
#include "host/scene/scene_document.h"
#include "host/scene/slide_ids.h"
#include "host/scene/slide_transform.h"

namespace tinygltf {
class Model;
}

// A scene's JSON taken apart into what is others' and what is ours, and put together again.
namespace cagewright::host {

struct NodeAsRead {
  GltfJson node;  // whole, ours included
  int parent = -1;
  int carrier = -1;        // the nearest slide between it and the mesh node, or -1
  int home = -1;           // its place among the nodes where it has to keep it, or -1
  bool is_pinned = false;  // the node stays, as an ordinary one, where the slide or the cage goes
};

struct SlideAsRead : NodeAsRead {
  Slide::Ellipse ellipse;                          // that its transform is
  std::optional<TranslationRotationScale> fitted;  // what the stroke was fitted to, where it still counts
  Eigen::Affine3d parent_to_mesh = Eigen::Affine3d::Identity();
};

struct CageAsRead : NodeAsRead {
  bool is_elsewhere = false;               // not in the mesh node's space, or not under it
  std::vector<std::pair<int, int>> roots;  // of a stray: scenes that it is a root of, and how many roots of others come
                                           // before it there
  int block = -1;                          // which of SceneBase::blocks holds its geometry, or -1
  int mesh = -1;                           // where others use the geometry too: the mesh in the base, else -1
  std::vector<GltfJson> geometry;  // mesh, 2 accessors, 2 buffer views, buffer: where it has no mesh in the base
};

// The places of a cage's geometry in the arrays of the file: another tool has put something after them.
struct CageBlock {
  int mesh = -1, positions = -1, indices = -1, position_view = -1, index_view = -1, buffer = -1;
};

// What is others'. Nodes of ours that have something after them have left an empty node in their place.
struct SceneBase {
  GltfJson json;
  std::set<int> holes;                   // places of nodes that are ours to use
  std::vector<CageBlock> blocks;         // places of geometry that are ours to use
  std::map<int, Eigen::Affine3d> poses;  // of skinned mesh nodes: node_tree.h; where it is not the identity
  std::map<int, int> shells;    // nodes of ours that stay only for the sake of others of ours below them; their parents
  std::map<int, int> carriers;  // of slides' nodes that have one: the next slide on the way to the mesh node
  std::set<std::string> keeps;  // JSON pointers of arrays that are there though empty
  std::set<std::string> drops;  // of arrays that only we have filled: there, empty, only for their place
};

struct TakenApart {
  SceneBase base;
  SceneContent content;
  std::vector<std::string> notes;  // what had to be mended, a sentence each
};

// Every id that a slide has or a cage names.
SlideIds ids_in(const SceneContent& content);

// `model` is the typed view of the same file. Throws FileError: nodes that form no tree, and where that is refused,
// nodes of ours that cannot be read: values of wrong types, a slide that is under no mesh node or has no area, a cage
// whose geometry is none. O(size of the JSON).
TakenApart take_apart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model,
                      SceneDocument::Unreadable unreadable);

// The whole again: the same for the same base and content, whatever was done before. Throws FileError where a cage
// cannot be written as floats. O(size of the JSON).
GltfJson put_together(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content);

}  // namespace cagewright::host

#endif
