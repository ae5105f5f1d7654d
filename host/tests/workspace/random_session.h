// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_WORKSPACE_RANDOM_SESSION_H
#define CAGEWRIGHT_HOST_TESTS_WORKSPACE_RANDOM_SESSION_H

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/tests/workspace/random_commands.h"
#include "host/workspace/script.h"

namespace cagewright::host::test {

// Random commands given to a workspace with an open scene, and what the document was after each step of undo. Every
// command is checked as it is done: one that is refused changes nothing; undo and redo say what they take back and lead
// to the recorded bytes; another change is one step, after which nothing can be redone. Fails the test where one is
// not.
class RandomSession {
 public:
  // What saving the document would write, without the cage of the time.
  struct Bytes {
    std::string glb, gltf;
    bool operator==(const Bytes&) const = default;
  };

  RandomSession(Workspace& workspace, ScriptRunner& runner, unsigned seed);

  // Until so many commands that change documents were done, not counting those that were refused.
  void run(std::size_t changes);
  void give(const nlohmann::json& command);
  // Step by step, each compared; `each`, if any, is called at every position on the way, the first and last among them.
  using AtStep = std::function<void()>;
  void undo_to(std::size_t position, const AtStep& each = {});
  void redo_to(std::size_t position, const AtStep& each = {});

  std::size_t position() const { return position_; }  // steps that are done
  std::size_t steps() const { return states_.size() - 1; }
  Bytes bytes() const;
  // How often each command was done and refused.
  const std::map<std::string, std::size_t>& done() const { return done_; }
  const std::map<std::string, std::size_t>& refused() const { return refused_; }

 private:
  void expect_unchanged(const std::string& why) const;
  void step(const char* command, std::size_t to, const AtStep& each);

  Workspace& workspace_;
  ScriptRunner& runner_;
  RandomCommands commands_;
  std::vector<Bytes> states_;        // [0]: before any command; [k]: after step k
  std::vector<std::string> labels_;  // of step k, at k - 1
  std::size_t position_ = 0;
  std::map<std::string, std::size_t> done_, refused_;
};

}  // namespace cagewright::host::test

#endif
