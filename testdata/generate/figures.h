// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "testdata/generate/field.h"

namespace cagewright::testdata {

// A model of our own: what it is called, the genus it was designed with, the resolution that gives it 15,000 to 30,000
// triangles, and its surface. All stand on y = 0 or float about the origin, y up, facing +z, and are 1.5 to 5 units
// across. None is mirror symmetric.
struct Figure {
  std::string name;
  int genus;
  int resolution;
  Field field;
};

Figure make_biped();      // a person with arms held out, one higher than the other
Figure make_quadruped();  // a humped animal with one foreleg lifted
Figure make_octopus();    // a mantle, two eyes and eight curling arms
Figure make_genus3();     // a figure with its hands on its hips whose legs run into one base: three rings
Figure make_blob();       // an egg with nine bumps
Figure make_legs();  // two legs side by side, each thick where the other is thin, as near as figure 18's of the paper

// All of the above, in that order.
std::vector<Figure> all_figures();

}  // namespace cagewright::testdata
