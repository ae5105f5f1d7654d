// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/contact.h"

namespace cagewright {

struct StepProblem {
  Points pull;                   // per vertex: the step that it would take alone
  std::vector<double> mobility;  // per vertex, > 0, about 1: how easily it gives way
  Points plane_normals;          // per vertex: it moves across this unit normal only; zero: free
  double longest = 0;            // of a vertex's step, model units
};

// Finds the step d of all vertices that minimises sum |d_v - pull_v|^2 / mobility_v under contacts, nearly: by
// Gauss-Seidel over the contacts' forces. More contacts may come after a first solution; the next starts from it.
class StepSolver {
 public:
  explicit StepSolver(const StepProblem& problem);

  void add(const Contacts& contacts);
  // O(sweeps * contacts). Steps longer than problem.longest are cut.
  Points solve(int sweeps);

 private:
  struct Row {  // a contact with its gradients across the planes, and how far one unit of force moves it
    Contact contact;
    double give = 0, force = 0;
  };
  double change_force(Row& row);

  const StepProblem& problem_;
  Points step_;
  std::vector<Row> rows_;
};

}  // namespace cagewright
