// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_OWN_EXTENSION_H
#define CAGEWRIGHT_HOST_SCENE_OWN_EXTENSION_H

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

struct OwnSlideExtension {
  std::int64_t id = 0;
  std::vector<Point3> stroke;
  std::optional<TranslationRotationScale> fitted;
  std::vector<std::string> keeps;
};

// What every JSON reader can hold as a whole number.
inline constexpr std::int64_t largest_slide_id = std::int64_t{1} << 53;
// An id that is not taken: the next after the largest, where there is one.
std::int64_t free_slide_id(const std::set<std::int64_t>& taken);

// Of a whole node. Throws FileError, with `place` before the reason, where a value is of the wrong type.
OwnSlideExtension read_slide_extension(const std::filesystem::path& path, const std::string& place,
                                       const GltfJson& node);
// Parameters, slides, sections and certificate; adds to `keeps`. Throws as above.
SceneCage read_cage_extension(const std::filesystem::path& path, const std::string& place, const GltfJson& node,
                              std::set<std::string>& keeps);

// Put the extension and its shadow in `extras` into a node; what others have there stays.
void write_slide_extension(const SceneSlide& slide, const std::optional<TranslationRotationScale>& fitted,
                           GltfJson& node);
void write_cage_extension(const SceneCage& cage, int source, GltfJson& node);
// On any node that has one of ours.
void write_keeps(const std::set<std::string>& keeps, GltfJson& node);

// Takes both out of a node, and `extensions` or `extras` where nothing else is in them.
void remove_own_extensions(GltfJson& node);

}  // namespace cagewright::host

#endif
