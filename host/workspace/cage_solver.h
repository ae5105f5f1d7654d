// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_CAGE_SOLVER_H
#define CAGEWRIGHT_HOST_WORKSPACE_CAGE_SOLVER_H

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/plugin_client/plugin.h"
#include "host/workspace/cage_state.h"

namespace cagewright::host {

// What a cage is to be made of. Copied to the solver's thread.
struct SolveRequest {
  int mesh_node = -1;
  std::shared_ptr<const TriangleMesh> mesh;            // the same pointer: the same mesh, which is then not set again
  std::vector<std::pair<std::int64_t, Slide>> slides;  // ids (-1: a preview's) and ellipses
  std::vector<std::pair<std::string, double>> parameters;  // those that are not at their defaults
  bool editing = false;
  // Handed back, both.
  std::uint64_t revision = 0;
  std::chrono::steady_clock::time_point asked = {};
};

struct SolveResult {
  int mesh_node = -1;
  std::uint64_t revision = 0;
  bool was_cancelled = false;
  CageState state;  // where it failed: problems only, without a cage
};

// Solves on a thread of its own, the latest request first and only: one that waits is replaced by the next. A whole
// solve that is running is cancelled by any request; one for editing is finished, so that the cage follows a drag, and
// the next one begins when its result has been taken.
class CageSolver {
 public:
  // `has_news` is called on the solver's thread after progress or a result; it may only wake the owner's.
  CageSolver(std::shared_ptr<const Plugin> plugin, std::function<void()> has_news);
  ~CageSolver();  // cancels and joins
  CageSolver(const CageSolver&) = delete;
  CageSolver& operator=(const CageSolver&) = delete;

  // From the owner's thread.
  void request(SolveRequest request);
  void cancel();  // what runs and what waits
  std::optional<SolveResult> take_result();
  SolveProgress progress() const;  // of what is not taken, too: until then nobody has its cage
  void wait();                     // until nothing runs or waits

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cagewright::host

#endif
