// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_CAGE_STATE_H
#define CAGEWRIGHT_HOST_WORKSPACE_CAGE_STATE_H

#include <cagewright/cagewright.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/file/report_file.h"
#include "host/file/slides_file.h"
#include "host/file/triangle_mesh.h"
#include "host/plugin_client/certificate.h"

namespace cagewright::host {

// A sentence about what is wrong, or could be better, and where.
struct Problem {
  std::string sentence;
  std::vector<std::int64_t> slides;  // at fault; may be empty
  std::optional<Point3> place;       // in the mesh node's space
  bool is_advice = false;            // the cage could be better; nothing that was asked for is missing
};

// What the last solve of a mesh node came to.
struct CageState {
  // Of the last solve that succeeded, in the mesh node's space; no triangles: none has.
  TriangleMesh cage;
  std::vector<int> triangle_parts;   // of each triangle of the cage
  std::vector<int> vertex_sections;  // of each vertex: row of `sections`, or -1
  std::vector<std::array<Point3, 4>> sections;
  std::vector<std::int64_t> section_slides;  // of each section: the slide's id; -1: one that was only shown (a preview)
  std::vector<bool> sections_merged;         // of each section: corners of it are gone where limbs were merged
  TriangleMesh cut_model;                    // and its parts: for colours; empty while editing
  std::vector<int> cut_model_parts;          // of each of its triangles
  std::optional<Certificate> certificate;    // where the whole road was gone
  std::vector<Problem> findings;             // the certificate's, with the document's slides
  std::optional<Measures> measures;
  cgw_summary summary = CGW_SUMMARY_INIT;
  std::vector<double> max_signed_distances;     // before each refinement step and, last, of the cage; over the diagonal
  std::shared_ptr<const Report> report;         // of the whole, without "model" and memory; null while editing
  double milliseconds = 0;                      // of the solve
  std::chrono::steady_clock::time_point asked;  // when the change that it answers was made
  bool is_of_editing = false;                   // few steps, no certificate: the mouse is still down
  bool is_of_now = false;                       // made from the slides and parameters as they are now

  // Of the last solve, whether it succeeded or not.
  std::vector<Problem> problems;
  bool failed = false;  // what is shown is the last good cage
};

// How far a solve has come.
struct SolveProgress {
  bool is_solving = false;
  double fraction = 0;  // 1: it is done
  std::string stage;
};

}  // namespace cagewright::host

#endif
