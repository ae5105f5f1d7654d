// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SCENE_CAGE_H
#define CAGEWRIGHT_HOST_WORKSPACE_SCENE_CAGE_H

#include "host/file/report_file.h"
#include "host/scene/scene_document.h"

namespace cagewright::host {

// A mesh node's cage as its scene is to hold it, without parameters, slides and sections: with a name where the node
// has no cage yet, and with the certificate and the fingerprints of model and cage, so that nobody believes it of
// another one; without a certificate (null, too) where the scene's floats round the cage. Throws FileError.
SceneCage scene_cage(const SceneDocument& scene, int mesh_node, const TriangleMesh& cage,
                     const Report::Certificate* certificate);

}  // namespace cagewright::host

#endif
