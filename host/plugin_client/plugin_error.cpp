// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {

// The header gives each group of errors a range of its own.
Blame blame(cgw_status status) {
  if (status <= CGW_ERROR_MESH_EMPTY && status > CGW_ERROR_STROKE_TOO_SHORT) return Blame::model;
  if (status <= CGW_ERROR_STROKE_TOO_SHORT && status > CGW_ERROR_STATE_MAGIC) return Blame::slides;
  if (status == CGW_ERROR_UNKNOWN_PARAMETER || status == CGW_ERROR_PARAMETER_OUT_OF_RANGE) return Blame::parameter;
  return Blame::program;
}

}  // namespace cagewright::host
