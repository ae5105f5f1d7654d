// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_DEPTH_ORDER_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_DEPTH_ORDER_H

class vtkActor;

namespace cagewright::host {

// What is drawn over all else, from below: lines that show through what hides them; handles.
enum class TopLayer { hidden_lines, handles };

// From now on the actor is drawn in front of all that is in no layer or in a lower one, and is hardly ever cut off by
// clipping. Actors of one layer still hide one another.
void draw_on_top(vtkActor& actor, TopLayer layer);

// From now on the actor wins over surfaces on which it lies.
void draw_slightly_nearer(vtkActor& actor);

}  // namespace cagewright::host

#endif
