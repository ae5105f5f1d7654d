/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Compiles as C and as C++ of every standard: the header needs nothing before it, and its macros initialise. */
#include "cagewright/cagewright.h"

#define INITIALISES(type, name, macro) \
  type name = macro;                   \
  (void)name

int main(void) {
  INITIALISES(cgw_error_info, error, CGW_ERROR_INFO_INIT);
  INITIALISES(cgw_host, host, CGW_HOST_INIT);
  INITIALISES(cgw_parameter, parameter, CGW_PARAMETER_INIT);
  INITIALISES(cgw_mesh, mesh, CGW_MESH_INIT);
  INITIALISES(cgw_mesh_report, report, CGW_MESH_REPORT_INIT);
  INITIALISES(cgw_slide_input, input, CGW_SLIDE_INPUT_INIT);
  INITIALISES(cgw_slide_info, info, CGW_SLIDE_INFO_INIT);
  INITIALISES(cgw_solve_options, options, CGW_SOLVE_OPTIONS_INIT);
  INITIALISES(cgw_parts, parts, CGW_PARTS_INIT);
  INITIALISES(cgw_loop, loop, CGW_LOOP_INIT);
  INITIALISES(cgw_section, section, CGW_SECTION_INIT);
  INITIALISES(cgw_cage, cage, CGW_CAGE_INIT);
  INITIALISES(cgw_iteration, iteration, CGW_ITERATION_INIT);
  INITIALISES(cgw_summary, summary, CGW_SUMMARY_INIT);
  INITIALISES(cgw_stream, stream, CGW_STREAM_INIT);
  return 0;
}
