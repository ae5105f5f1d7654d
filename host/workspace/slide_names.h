// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SLIDE_NAMES_H
#define CAGEWRIGHT_HOST_WORKSPACE_SLIDE_NAMES_H

#include <set>
#include <string>
#include <vector>

#include "host/scene/scene_content.h"

namespace cagewright::host {

// A sentence without the word "slide" where the name that follows says it: "'slide 5' meets slide 'knee'" for "slide
// 'slide 5' meets slide 'knee'".
std::string without_echo(std::string sentence);

// The names that are taken under a mesh node, and free ones. Each that is given out is taken.
class SlideNames {
 public:
  explicit SlideNames(const std::vector<const SceneSlide*>& slides);

  std::string next();                              // "slide 1", "slide 2" ...
  std::string like(const std::string& wanted);     // itself, else "wanted 2", "wanted 3" ...; next() where it is empty
  std::string copy_of(const std::string& name);    // "knee copy", "knee copy 2" ..., also of a copy
  std::string mirror_of(const std::string& name);  // "left knee" for "right knee", else "knee mirrored"

 private:
  std::set<std::string> taken_;
};

}  // namespace cagewright::host

#endif
