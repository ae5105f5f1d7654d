// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SCENE_BROKEN_SCENES_H
#define CAGEWRIGHT_HOST_TESTS_SCENE_BROKEN_SCENES_H

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace cagewright::host::test {

std::filesystem::path broken_folder();

// A file of that folder, and what the sentence that refuses it has to say after the file's name.
struct BrokenScene {
  std::string name, sentence;
};
std::vector<BrokenScene> broken_scenes();

// Those that a document can hold all the same; why is said where they are.
std::set<std::string> readable_broken_scenes();

}  // namespace cagewright::host::test

#endif
