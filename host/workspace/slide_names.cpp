// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/slide_names.h"

#include <array>
#include <cctype>
#include <utility>

namespace cagewright::host {
namespace {

bool is_letter(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

}  // namespace

std::string without_echo(std::string sentence) {
  for (const std::string quote : {"'", "\""}) {
    const std::string echo = "slide " + quote + "slide ";
    const std::size_t word = std::string("slide ").size();
    for (std::size_t at = 0; (at = sentence.find(echo, at)) != std::string::npos; at += echo.size() - word)
      sentence.erase(at, word);
  }
  return sentence;
}

SlideNames::SlideNames(const std::vector<const SceneSlide*>& slides) {
  for (const SceneSlide* slide : slides) taken_.insert(slide->name);
}

std::string SlideNames::next() {
  for (int number = 1;; ++number) {
    const std::string name = "slide " + std::to_string(number);
    if (taken_.insert(name).second) return name;
  }
}

std::string SlideNames::like(const std::string& wanted) {
  if (wanted.empty()) return next();
  if (taken_.insert(wanted).second) return wanted;
  for (int number = 2;; ++number) {
    const std::string name = wanted + " " + std::to_string(number);
    if (taken_.insert(name).second) return name;
  }
}

// A copy's copy is another copy of the same: "copy copy" would go on growing.
std::string SlideNames::copy_of(const std::string& name) {
  static const std::string copy = " copy";
  const std::size_t last = name.find_last_not_of("0123456789");
  const bool is_numbered = last != std::string::npos && last + 1 < name.size() && name[last] == ' ';
  const std::string named = is_numbered ? name.substr(0, last) : name;
  const bool is_copy = named.size() > copy.size() && named.ends_with(copy);
  return like(is_copy ? named : name + copy);
}

std::string SlideNames::mirror_of(const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 6> sides = {{{"left", "right"},
                                                                                {"right", "left"},
                                                                                {"Left", "Right"},
                                                                                {"Right", "Left"},
                                                                                {"LEFT", "RIGHT"},
                                                                                {"RIGHT", "LEFT"}}};
  for (const auto& [here, there] : sides) {
    const std::string side = here;
    const std::size_t at = name.find(side);
    const bool is_word =
        at != std::string::npos && (at == 0 || !is_letter(name, at - 1)) && !is_letter(name, at + side.size());
    if (is_word) return like(name.substr(0, at) + there + name.substr(at + side.size()));
  }
  return like(name + " mirrored");
}

}  // namespace cagewright::host
