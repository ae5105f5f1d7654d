// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>

extern char** environ;

namespace cagewright::host {
namespace {

std::vector<std::string> with_environment(const std::map<std::string, std::string>& changes) {
  std::map<std::string, std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != text.npos) all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  all["CAGEWRIGHT_PLUGIN"] = FAKE_PLUGIN;
  all.erase("CAGEWRIGHT_FAKE");
  all.erase("DISPLAY");
  for (const auto& [name, value] : changes) all[name] = value;
  std::vector<std::string> result;
  for (const auto& [name, value] : all) {
    if (!value.empty()) result.push_back(name + "=" + value);
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

// Appends what there is; false at the end.
bool read_some(int pipe, std::string& to) {
  std::array<char, 4096> bytes;
  const ssize_t got = ::read(pipe, bytes.data(), bytes.size());
  if (got > 0) to.append(bytes.data(), static_cast<std::size_t>(got));
  return got > 0;
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
                 const std::string& program) {
  std::array<int, 2> output{}, errors{};
  if (::pipe2(output.data(), O_CLOEXEC) != 0 || ::pipe2(errors.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipes");
  }
  std::vector<std::string> command = {program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = with_environment(environment);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  const int failure = ::posix_spawn(&process_, program.c_str(), &actions, nullptr, pointers(command).data(),
                                    pointers(variables).data());
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  ::close(errors[1]);
  output_ = output[0];
  errors_ = errors[0];
  if (failure != 0) throw std::runtime_error("the program does not start");
}

Program::~Program() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(output_);
  ::close(errors_);
}

void Program::send(int signal) const { ::kill(process_, signal); }

void Program::close_output() { ::close(std::exchange(output_, -1)); }

void Program::wait_for_error_text(const std::string& text) {
  while (run_.errors.find(text) == run_.errors.npos && read_some(errors_, run_.errors)) {
  }
}

ProgramRun Program::finish() {
  std::array<pollfd, 2> pipes = {{{output_, POLLIN, 0}, {errors_, POLLIN, 0}}};
  while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
    if (::poll(pipes.data(), pipes.size(), -1) < 0) continue;
    if (pipes[0].revents != 0 && !read_some(output_, run_.output)) pipes[0].fd = -1;
    if (pipes[1].revents != 0 && !read_some(errors_, run_.errors)) pipes[1].fd = -1;
  }
  int status = 0;
  ::waitpid(std::exchange(process_, -1), &status, 0);
  run_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run_;
}

ProgramRun run_program(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
                       const std::string& program) {
  return Program(arguments, environment, program).finish();
}

}  // namespace cagewright::host
