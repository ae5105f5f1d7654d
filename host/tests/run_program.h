// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_RUN_PROGRAM_H
#define CAGEWRIGHT_HOST_TESTS_RUN_PROGRAM_H

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace cagewright::host {

struct ProgramRun {
  int exit_code = -1;  // 128 + the signal where one ended it
  std::string output, errors;
};

// The program `cagewright` as a process of its own, with stdout and stderr in pipes. The fake plug-in is in
// CAGEWRIGHT_PLUGIN, DISPLAY is not set; `environment` comes on top, "" unsets. `program` may be a copy elsewhere.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& environment = {}, const std::string& program = PROGRAM);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  // From here on nobody reads what it prints on stdout.
  void close_output();
  // Reads stderr until `text` was in it or it ended.
  void wait_for_error_text(const std::string& text);
  ProgramRun finish();

 private:
  pid_t process_ = -1;
  int output_ = -1, errors_ = -1;
  ProgramRun run_;
};

ProgramRun run_program(const std::vector<std::string>& arguments,
                       const std::map<std::string, std::string>& environment = {},
                       const std::string& program = PROGRAM);

}  // namespace cagewright::host

#endif
