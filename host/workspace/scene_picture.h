// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SCENE_PICTURE_H
#define CAGEWRIGHT_HOST_WORKSPACE_SCENE_PICTURE_H

#include <filesystem>
#include <vector>

#include "host/plugin_client/session.h"
#include "host/view/picture.h"
#include "host/workspace/workspace.h"

namespace cagewright::host {

// The chosen mesh, its slides (those at fault orange), sections and cage, as they are; borrows from the workspace.
// Throws CommandError where no mesh is there.
PictureInput scene_picture(const Workspace& workspace);

// Model, slides and cage of a session that has solved; `cage_points` are the cage's or others for its triangles.
// Borrows.
PictureInput session_picture(const Session& session, const TriangleMesh& model, const TriangleMesh& cage,
                             const std::vector<double>& cage_points);

// Views round what is up, from `first` on, at equal angles: a whole turn.
std::vector<View> turntable(const View& first, std::size_t frames);

}  // namespace cagewright::host

#endif
