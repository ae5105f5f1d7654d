// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_WORKSPACE_RANDOM_COMMANDS_H
#define CAGEWRIGHT_HOST_TESTS_WORKSPACE_RANDOM_COMMANDS_H

#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "host/workspace/workspace.h"

namespace cagewright::host::test {

// Commands of docs/script.md at random, about limbs along y. A fifth of them is spoilt: an argument is missing,
// unknown, of another kind, out of bounds, or names a slide that is not there. Same seed and same workspace, same
// commands.
class RandomCommands {
 public:
  RandomCommands(const Workspace& workspace, unsigned seed) : workspace_(workspace), random_(seed) {}

  // About the workspace as it is now.
  nlohmann::json next();

  // Every command that changes a document, and every other one but those that open, close, write, make pictures, check
  // with Ceres or change the plug-in.
  static const std::set<std::string>& changing();
  static const std::set<std::string>& others();

 private:
  using Json = nlohmann::json;

  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  double number(double least, double greatest) { return std::uniform_real_distribution(least, greatest)(random_); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Value>
  const Value& any(const std::vector<Value>& values) {
    return values[below(values.size())];
  }

  Json make(const std::string& name);
  void spoil(Json& command);

  Json vertex();
  Json height();  // a point on the limb's axis
  Json radii(double by);
  Json ring(std::size_t count);
  Json name();
  Json names();
  Json add_slide();
  Json extend_stroke();
  Json change_slide();
  Json ellipse();
  Json listed_ellipses();
  Json set_parameter();
  Json select_mesh();

  const Workspace& workspace_;
  std::mt19937 random_;
  std::size_t names_given_ = 0;
};

}  // namespace cagewright::host::test

#endif
