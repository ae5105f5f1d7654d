// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_PLUGIN_ERROR_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_PLUGIN_ERROR_H

#include <cagewright/cagewright.h>

#include <stdexcept>
#include <string>

namespace cagewright::host {

// A call into the plug-in failed. what() is the plug-in's sentence, or one of ours where it gave none.
class PluginError : public std::runtime_error {
 public:
  PluginError(const cgw_error_info& info, const std::string& sentence) : std::runtime_error(sentence), info_(info) {}

  cgw_status status() const { return info_.code; }
  const cgw_error_info& info() const { return info_; }

 private:
  cgw_error_info info_;
};

// The plug-in's progress function answered nonzero, and the call ended with CGW_CANCELLED.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

// There is no plug-in, or what is there cannot be used. what() names the file.
class PluginLoadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What an error of the plug-in is about, by its status.
enum class Blame {
  model,      // the mesh that was given
  slides,     // one slide, or slides together
  parameter,  // an unknown one, or a value out of range
  program,    // this program or the plug-in; nothing that the user gave
};
Blame blame(cgw_status status);

}  // namespace cagewright::host

#endif
