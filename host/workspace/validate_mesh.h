// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_VALIDATE_MESH_H
#define CAGEWRIGHT_HOST_WORKSPACE_VALIDATE_MESH_H

#include <functional>
#include <string>
#include <vector>

#include "host/validate/validation_file.h"
#include "host/workspace/workspace.h"

namespace cagewright::host {

// What was found of the cage of a workspace's mesh, and pictures of it for the page.
struct MeshValidation {
  ValidationReport report;
  std::vector<PagePicture> pictures;
  std::string why_no_pictures;  // a sentence, where there are none
};

// Makes the cage of the chosen mesh anew, without merging (the refinement's records are about other triangles), and
// checks it: `cagewright validate` on what is open. Takes long; main thread. Throws CommandError, PluginError, and
// Cancelled where `is_interrupted`, which may be empty, answers true.
MeshValidation validate_mesh(const Workspace& workspace, const ValidationOptions& options,
                             const std::function<bool()>& is_interrupted);
std::string validation_page(const MeshValidation& found);

// Of a cage that was validated: the plug-in's and what Ceres made of it. Throws PictureError.
std::vector<PagePicture> validation_pictures(const Session& session, const TriangleMesh& model,
                                             const TriangleMesh& cage, const Validation& validation);

}  // namespace cagewright::host

#endif
