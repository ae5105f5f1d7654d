// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_PICTURE_ACTORS_H
#define CAGEWRIGHT_HOST_VIEW_PICTURE_ACTORS_H

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "host/view/picture.h"
#include "host/view/polydata.h"

namespace cagewright::host {

// Every point that the picture has to hold: the model's and the cage's vertices, the slides' and sections' outlines.
std::vector<Point> outline_points(const PictureInput& input);

// The actors of one picture. `pixel` is the size of a pixel in model units; line widths are multiples of it, so lines
// look the same at every model size. Precondition: indices are in range and positions finite.
std::vector<vtkSmartPointer<vtkActor>> make_actors(const PictureInput& input, double pixel);

}  // namespace cagewright::host

#endif
