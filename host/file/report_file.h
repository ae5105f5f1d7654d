// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_REPORT_FILE_H
#define CAGEWRIGHT_HOST_FILE_REPORT_FILE_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cagewright::host {

// What a run of the program found. What nobody computed is empty here and null in the file, never a stand-in.
struct Report {
  struct Mesh {
    std::optional<std::uint64_t> vertices, triangles, components;
    std::optional<std::int64_t> genus;
    std::optional<bool> closed;
  };
  struct Slide {
    std::string name;
    std::string status;   // the plug-in's name of it, "ok"
    std::string message;  // "" or a sentence
  };
  struct Cage {
    std::optional<std::uint64_t> vertices, triangles;
    std::optional<std::int64_t> genus;
  };
  struct Refinement {
    std::optional<std::uint64_t> iterations;
    std::optional<bool> converged;
    // Before each iteration and, last, of the final cage.
    std::vector<std::optional<double>> max_signed_distance_over_diagonal;
  };
  struct Certificate {
    std::optional<bool> closed;
    std::optional<std::uint64_t> self_intersections, model_cage_intersections, vertices_outside;
    std::optional<bool> encloses;
    std::optional<std::uint64_t> degenerate_triangles;
    std::optional<bool> keeps_distance;
    std::string message;  // "" or which slides are at fault, and what to do
    // The first of what fails, by rows of the files' meshes, counted from 0.
    std::vector<std::uint32_t> first_degenerate_triangles, first_vertices_outside;
    std::vector<std::array<std::uint32_t, 2>> first_self_intersections, first_model_cage_intersections;
  };
  struct Tightness {
    std::optional<double> volume_ratio, mean_gap_over_diagonal, max_gap_over_diagonal;
    std::optional<double> clearance_over_diagonal, coverage;
  };
  struct Quality {  // angles in radians
    std::optional<double> least_dihedral, greatest_dihedral, greatest_aspect;
    std::optional<double> mean_asymmetry_over_diagonal, max_asymmetry_over_diagonal;
    std::optional<double> worst_squareness, worst_planarity_over_diagonal, worst_twist;
  };
  struct Timings {  // milliseconds
    std::optional<double> read, prepare, segment, orient, meshing, refine, enclose, write, total;
  };
  using Option = std::variant<bool, std::int64_t, double, std::string>;

  std::string node;  // of the scene; "" where there is but one model
  Mesh model;
  std::vector<Slide> slides;
  std::optional<std::uint64_t> parts;
  Cage cage;
  Refinement refinement;
  Certificate certificate;
  Tightness tightness;
  Quality quality;
  Timings timings_ms;
  std::optional<double> peak_memory_mb;
  std::string version;
  std::vector<std::pair<std::string, Option>> options;  // what the run was asked for, defaults too
};

// The report as JSON with the keys of the structs above, indented. NaN and infinity become null.
std::string report_text(const Report& report);

// The same of a scene with several cages: the first one's report, and in the key "cages" for each its node, model,
// slides, parts, cage, refinement, certificate and tightness. Precondition: one at least.
std::string reports_text(const std::vector<Report>& reports);

// The object of the key "certificate" alone, on one line.
std::string certificate_text(const Report::Certificate& certificate);

}  // namespace cagewright::host

#endif
