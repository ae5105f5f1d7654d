// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/orientation_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/validate/orientation_search.h"

namespace cagewright::host {
namespace {

constexpr double agreement = 1e-8;       // of directions and, relative, of lengths
constexpr double allowed_excess = 1e-6;  // of (1) over the best found, where the plug-in went on to the minimum

std::string of_section(const ObservedSection& section) { return "the section of slide '" + section.slide + "': "; }

std::string text_of_x(const Eigen::Vector2d& x) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.6g, %.6g)", x.x(), x.y());
  return text;
}

Check check_linear(const ObservedCage& seen, const Equation1& equation) {
  Check check{"orient", "the linear solution of equation (1) is the one that Ceres finds", agreement, "of a direction"};
  const std::vector<Eigen::Vector2d> x = minimise_quadratic(equation);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const ObservedSection& section = seen.sections[k];
    const double apart = (x[k] - section.linear).norm();
    check.offer(apart, [&] {
      return of_section(section) + "the least of equation (1) is at x = " + text_of_x(x[k]) + ", the plug-in's is " +
             text_of_x(section.linear) + ", " + text_of(apart) + " apart";
    });
  }
  return check;
}

// Half the extent of the ellipse along a unit direction in its plane.
double reach(const ObservedSection& s, const Eigen::Vector3d& direction) {
  return std::hypot(s.u.dot(direction), s.v.dot(direction));
}

Check check_rectangles(const ObservedCage& seen) {
  Check check{"orient", "rectangles go round their ellipses, turned as x says", agreement, "relative"};
  for (const ObservedSection& s : seen.sections) {
    const double size = s.u.norm();
    check.offer(std::abs(s.p.dot(s.q)) / (size * size),
                [&] { return of_section(s) + "its half edges p and q are not perpendicular"; });
    check.offer(std::max(std::abs(s.p.dot(s.normal)), std::abs(s.q.dot(s.normal))) / size,
                [&] { return of_section(s) + "it does not lie in the plane of its slide"; });
    for (const Eigen::Vector3d& edge : {s.p, s.q}) {
      const double expected = reach(s, edge.normalized());
      check.offer(std::abs(edge.norm() - expected) / size, [&] {
        return of_section(s) + "a half edge has the length " + text_of(edge.norm()) + ", the ellipse reaches " +
               text_of(expected);
      });
    }
    const double angle = 4 * angle_of(s);
    const Eigen::Vector2d power(std::cos(angle), std::sin(angle));
    const double off = s.x.norm() > agreement ? (power - s.x.normalized()).norm() : 0;
    check.offer(off, [&] {
      return of_section(s) + "p to the fourth power is " + text_of_x(power) + ", x says " + text_of_x(s.x.normalized());
    });
  }
  return check;
}

// Above nothing, a share of the energy at stake is meant.
double excess(double energy, double best, double at_stake) {
  const double base = std::max(best, 1e-9 * at_stake);
  return base > 0 ? (energy - best) / base : 0;
}

double weight_of(const Equation1& equation) {
  double weight = 0;
  for (const Equation1::Pull& p : equation.pulls) weight += p.weight;
  for (const Equation1::Tie& t : equation.ties) weight += t.weight;
  return weight;
}

}  // namespace

OrientationReport check_orientation(const ObservedCage& seen, std::size_t starts) {
  OrientationReport report;
  const Equation1 equation = equation_1(seen);
  report.checks = {check_linear(seen, equation), check_rectangles(seen)};
  std::vector<double> linear, turned;
  for (const ObservedSection& section : seen.sections) {
    linear.push_back(std::atan2(section.linear.y(), section.linear.x()) / 4);
    turned.push_back(angle_of(section));
  }
  const OrientationSearch search = search_angles(equation, turned, starts);
  OrientationFigures& figures = report.figures;
  figures.linear = equation.at_angles(linear);
  figures.plugin = equation.at_angles(turned);
  figures.from_plugin = search.from_start;
  figures.best = search.best;
  figures.starts = search.starts;
  figures.reached = search.reached;
  figures.linear_off = excess(figures.linear, figures.best, weight_of(equation));
  figures.plugin_off = excess(figures.plugin, figures.best, weight_of(equation));
  if (!seen.is_over_angles) return report;  // the linear solution is what the paper has, and no minimum over angles
  Check best{"orient", "no turn of the sections is found that lowers equation (1) by more", allowed_excess,
             "of the best energy found"};
  best.offer(std::max(0.0, figures.plugin_off), [&] {
    return "equation (1) is " + text_of(figures.plugin) + " at the plug-in's sections, " + text_of(figures.best) +
           " at the best of " + std::to_string(figures.starts) +
           " random starts: " + text_of(100 * figures.plugin_off) + " % above it";
  });
  report.checks.push_back(std::move(best));
  return report;
}

}  // namespace cagewright::host
