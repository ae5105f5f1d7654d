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

// By a part of its distance, however near the clipping planes are. With n and f their distances, in perspective
// z = (f + n) / (f - n) w - 2 f n / (f - n): the last term, which changes with the distance alone, is read off the
// matrix, whose rows for z and w are parallel but for it. An orthographic w is 1: there by a part of the range.
void draw_slightly_nearer(vtkActor& actor) {
  add_after_position(actor,
                     "vec4 row_z = vec4(MCDCMatrix[0][2], MCDCMatrix[1][2], MCDCMatrix[2][2], MCDCMatrix[3][2]);\n"
                     "  vec4 row_w = vec4(MCDCMatrix[0][3], MCDCMatrix[1][3], MCDCMatrix[2][3], MCDCMatrix[3][3]);\n"
                     "  float square_w = dot(row_w.xyz, row_w.xyz);\n"
                     "  gl_Position.z += square_w > 0.0\n"
                     "      ? 0.0005 * (row_z.w - dot(row_z.xyz, row_w.xyz) / square_w * row_w.w)\n"
                     "      : -0.0004;");
}

}  // namespace cagewright::host
