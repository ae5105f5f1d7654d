// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/name_apart.h"

#include <map>
#include <set>
#include <utility>

#include "host/file/file_error.h"
#include "host/scene/scene_parts.h"

namespace cagewright::host {
namespace {

void number_apart(SceneContent& content, std::vector<std::string>& notes) {
  using MeshAndId = std::pair<int, std::int64_t>;
  SlideIds ids = ids_in(content);
  std::set<std::int64_t> seen;
  std::map<MeshAndId, std::int64_t> renumbered;
  std::set<MeshAndId> kept;
  for (SceneSlide& slide : content.slides) {
    if (seen.insert(slide.id).second) {
      kept.insert({slide.mesh_node, slide.id});
      continue;
    }
    const std::int64_t id = ids.take_next();
    notes.push_back("two slides have the id " + std::to_string(slide.id) + "; " + in_quotes(slide.name) + " gets " +
                    std::to_string(id));
    renumbered.try_emplace({slide.mesh_node, slide.id}, id);
    slide.id = id;
  }
  for (SceneCage& cage : content.cages) {
    for (std::int64_t& id : cage.slides) {
      const auto found = renumbered.find({cage.mesh_node, id});
      if (found != renumbered.end() && kept.count({cage.mesh_node, id}) == 0) id = found->second;
    }
  }
}

void rename_apart(SceneContent& content, std::vector<std::string>& notes) {
  using MeshAndName = std::pair<int, std::string>;
  std::set<MeshAndName> names, given_names;
  std::map<MeshAndName, int> copies;
  for (SceneSlide& slide : content.slides) {
    if (slide.name.empty()) slide.name = "slide " + std::to_string(slide.id);
    given_names.insert({slide.mesh_node, slide.name});
  }
  for (SceneSlide& slide : content.slides) {
    const MeshAndName given(slide.mesh_node, slide.name);
    if (names.insert(given).second) continue;
    int& copy = copies.try_emplace(given, 1).first->second;
    do {
      slide.name = given.second + "." + std::to_string(++copy);
    } while (!given_names.insert({slide.mesh_node, slide.name}).second);
    names.insert({slide.mesh_node, slide.name});
    notes.push_back("two slides are called " + in_quotes(given.second) + "; the second is now " +
                    in_quotes(slide.name));
  }
}

}  // namespace

std::vector<std::string> name_apart(SceneContent& content) {
  std::vector<std::string> notes;
  number_apart(content, notes);
  rename_apart(content, notes);
  return notes;
}

}  // namespace cagewright::host
