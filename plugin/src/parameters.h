// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "cagewright/cagewright.h"
#include "core/pipeline/pipeline.h"

namespace cagewright::plugin {

// The values of the plug-in's parameters, and the list that describes them. Their defaults are the core's.
class Parameters {
 public:
  static constexpr std::size_t count = 14;

  // In the order of parameter_info. The strings are static.
  static std::span<const cgw_parameter, count> list() noexcept;

  Parameters() noexcept;  // the defaults

  // Throws AbiError: UNKNOWN_PARAMETER, PARAMETER_OUT_OF_RANGE (not finite, out of the range, no whole number where one
  // is needed, or not offered by this version). A throw leaves the values as they were.
  void set(std::string_view id, double value);
  // A number, true/false, or a choice's name. Throws as set.
  void set_text(std::string_view id, std::string_view text);
  // Throws AbiError(UNKNOWN_PARAMETER).
  double get(std::string_view id) const;

  // What the core needs of them. `editing` takes refine.editing_iterations.
  PipelineOptions options(bool editing) const;

 private:
  std::array<double, count> values_;
};

}  // namespace cagewright::plugin
