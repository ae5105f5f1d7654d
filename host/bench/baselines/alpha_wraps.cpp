// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "host/bench/baselines/cage_search.h"
#include "host/bench/baselines/simplify.h"
#include "host/bench/baselines/stopwatch.h"

namespace cagewright::bench {
namespace {

Surface wrap(const Judge& judge, double alpha_divisor, double offset) {
  Surface cage;
  CGAL::alpha_wrap_3(judge.model(), judge.diagonal() / alpha_divisor, offset, cage);
  return cage;
}

std::string text(const char* format, double first, double second) {
  char buffer[128];
  std::snprintf(buffer, sizeof buffer, format, first, second);
  return buffer;
}

// Both collapses of the surface at that distance; true where one of them encloses.
bool offer_decimated(BestCage& best, const Judge& judge, std::size_t triangles, double alpha_divisor, double distance) {
  const Stopwatch making;
  const Surface fine = wrap(judge, alpha_divisor, distance * judge.diagonal());
  const double made = making.seconds();
  bool encloses = false;
  for (const Collapse collapse : {Collapse::lindstrom_turk, Collapse::quadrics}) {
    const Stopwatch simplifying;
    Surface cage = simplified(fine, triangles, collapse);
    const double seconds = made + simplifying.seconds();
    const std::string parameters =
        text("offset %.4f of the diagonal, alpha diagonal/%.0f, ", distance, alpha_divisor) + name_of(collapse);
    encloses = best.offer(std::move(cage), parameters, seconds) || encloses;
  }
  return encloses;
}

}  // namespace

void search_alpha_wraps(BestCage& best, const Judge& judge, std::size_t most_triangles) {
  constexpr int halvings = 8;
  for (const double offset_divisor : {20.0, 30.0, 40.0, 50.0, 75.0, 100.0, 150.0, 200.0, 400.0, 800.0}) {
    double few = 2, many = 40;  // alpha is the diagonal over this: more triangles, the larger it is
    for (int step = 0; step < halvings; ++step) {
      const double divisor = std::sqrt(few * many);
      const Stopwatch making;
      Surface cage = wrap(judge, divisor, judge.diagonal() / offset_divisor);
      const double seconds = making.seconds();
      (triangle_count(cage) <= most_triangles ? few : many) = divisor;
      best.offer(std::move(cage), text("alpha diagonal/%.2f, offset diagonal/%.0f", divisor, offset_divisor), seconds);
    }
  }
}

void search_decimated_offsets(BestCage& best, const Judge& judge, std::size_t most_triangles) {
  constexpr double least = 0.003, most = 0.12, factor = 1.35;
  constexpr int halvings = 4;
  for (const double alpha_divisor : {45.0, 90.0}) {
    const auto encloses = [&](double distance) {
      return offer_decimated(best, judge, most_triangles, alpha_divisor, distance);
    };
    double too_near = least / factor, far_enough = least;
    while (far_enough < most && !encloses(far_enough)) {
      too_near = far_enough;
      far_enough *= factor;
    }
    if (far_enough >= most) continue;
    for (int step = 0; step < halvings; ++step) {
      const double distance = (too_near + far_enough) / 2;
      (encloses(distance) ? far_enough : too_near) = distance;
    }
  }
}

}  // namespace cagewright::bench
