// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_CAGE_INPUT_H
#define CAGEWRIGHT_HOST_CLI_CAGE_INPUT_H

#include <optional>
#include <string>
#include <vector>

#include "host/cli/command_line.h"
#include "host/file/slides_file.h"
#include "host/file/triangle_mesh.h"
#include "host/scene/scene_document.h"
#include "host/scene/scene_names.h"

namespace cagewright::host {

// A mesh that is to get a cage.
struct CageTarget {
  int node = -1;     // of the scene; -1 where the model is the whole file
  std::string name;  // for sentences; empty where there is nothing to tell apart
  TriangleMesh model;
  std::vector<Slide> slides;  // in the model's space
};

struct CageInput {
  std::optional<SceneDocument> scene;  // where MODEL is one and its nodes matter
  std::vector<CageTarget> targets;     // one at least
  bool slides_from_scene = false;
  std::vector<std::string> notes;
};

// Reads MODEL and the slides. Of a scene: the node that --node names; else the nodes that have slides; else the only
// one with a mesh; else, where no scene is to be written, all meshes as one. Throws FileError; InputError where it is
// not clear which node is meant.
CageInput read_cage_input(const CageCommand& command);

}  // namespace cagewright::host

#endif
