// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_ENVIRONMENT_H
#define CAGEWRIGHT_HOST_TESTS_ENVIRONMENT_H

#include <cstdlib>
#include <string>

namespace cagewright::host {

// An environment variable for as long as the object lives; unset afterwards.
class Environment {
 public:
  Environment(std::string name, const std::string& value) : name_(std::move(name)) {
    ::setenv(name_.c_str(), value.c_str(), 1);
  }
  ~Environment() { ::unsetenv(name_.c_str()); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::string name_;
};

}  // namespace cagewright::host

#endif
