// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_WORKSPACE_WORKSPACE_FIXTURE_H
#define CAGEWRIGHT_HOST_TESTS_WORKSPACE_WORKSPACE_FIXTURE_H

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/file/mesh_writer.h"
#include "host/plugin_client/plugin.h"
#include "host/tests/temporary_folder.h"
#include "host/tests/workspace/ellipsoid.h"
#include "host/workspace/workspace.h"

namespace cagewright::host::test {

// Sanitizers make things five to twenty times as slow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

// A workspace with the real plug-in, and an ellipsoid along y, from -2 to 2, in a file.
class WorkspaceTest : public testing::Test {
 protected:
  WorkspaceTest() { model_ = write_model("limb.off", ellipsoid(24, 48)); }

  std::filesystem::path write_model(const std::string& name, const TriangleMesh& mesh) const {
    return folder_.write(name, mesh_bytes(mesh, name));
  }
  static std::filesystem::path own_scene(const std::string& name) {
    return std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name;
  }
  static Slide across(const std::string& name, double y) { return {name, Slide::PointNormal{{0.3, y, 0}, {0, 1, 0}}}; }
  void open_with_slides(std::initializer_list<double> heights) {
    workspace_.open(model_);
    for (const double y : heights) workspace_.add_slide(across("", y));
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const SceneSlide* slide : workspace_.slides()) names.push_back(slide->name);
    return names;
  }
  std::int64_t id(const std::string& name) const { return workspace_.find_slide(name)->id; }
  const Slide::Ellipse& ellipse(const std::string& name) const { return workspace_.find_slide(name)->ellipse; }
  std::string bytes() const { return workspace_.document().bytes(); }

  // Of an action that has to throw.
  template <class Error, class Action>
  static std::string sentence_of(const Action& action) {
    try {
      action();
    } catch (const Error& error) {
      return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
  }

  TemporaryFolder folder_;
  std::filesystem::path model_;
  std::shared_ptr<const Plugin> plugin_ = Plugin::load(CAGEWRIGHT_PLUGIN_FILE);
  Workspace workspace_{plugin_, {}};
};

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace cagewright::host::test

#endif
