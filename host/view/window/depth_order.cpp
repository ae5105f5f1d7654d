// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/depth_order.h"

#include <vtkActor.h>
#include <vtkShaderProperty.h>

#include <string>

namespace cagewright::host {
namespace {

void add_after_position(vtkActor& actor, const std::string& statement) {
  actor.GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                                        "//VTK::PositionVC::Impl\n  " + statement + "\n", false);
}

}  // namespace

// Squeezes depth, -1 to 1 between the clipping planes, into what lies just behind the near plane; what is before the
// near plane by up to five times the range is then drawn, too.
void draw_on_top(vtkActor& actor, TopLayer layer) {
  add_after_position(actor, layer == TopLayer::handles
                                ? "gl_Position.z = 0.001 * gl_Position.z - 0.994 * gl_Position.w;"
                                : "gl_Position.z = 0.001 * gl_Position.z - 0.99 * gl_Position.w;");
}

void draw_slightly_nearer(vtkActor& actor) { add_after_position(actor, "gl_Position.z -= 0.0004 * gl_Position.w;"); }

}  // namespace cagewright::host
