// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/run_report.h"

#include "host/cli/text.h"
#include "host/file/file_error.h"

namespace cagewright::host {

RunOptions options_of(const CageCommand& command) {
  RunOptions options;
  options.emplace_back("model", command.model.string());
  if (command.slides) options.emplace_back("slides", command.slides->string());
  if (command.out) options.emplace_back("out", command.out->string());
  options.emplace_back("threads", static_cast<std::int64_t>(command.threads));
  return options;
}

namespace {

std::string pair_text(const std::vector<std::array<std::uint32_t, 2>>& pairs, const char* first, const char* second) {
  if (pairs.empty()) return "";
  return std::string(", the first: ") + first + " " + std::to_string(pairs[0][0]) + " and " + second + " " +
         std::to_string(pairs[0][1]);
}

std::string place_text(const std::vector<std::uint32_t>& rows) {
  return rows.empty() ? "" : ", the first: " + std::to_string(rows[0]);
}

}  // namespace

std::string certificate_summary(const Report::Certificate& c) {
  std::string text =
      std::string("certificate: ") + (c.encloses.value_or(false) ? "the cage encloses the model" : "NONE") + "\n";
  const auto add = [&](const std::optional<std::uint64_t>& count, const char* noun, const std::string& what) {
    if (count.value_or(0) > 0) text += "  " + counted(*count, noun) + what + "\n";
  };
  if (!c.closed.value_or(true))
    text += "  the cage is no closed, consistently oriented 2-manifold that faces outward\n";
  add(c.degenerate_triangles, "cage triangle", " without area" + place_text(c.first_degenerate_triangles));
  add(c.self_intersections, "pair",
      " of cage triangles that meet" + pair_text(c.first_self_intersections, "triangle", "triangle"));
  add(c.model_cage_intersections, "model triangle",
      " that meet the cage" + pair_text(c.first_model_cage_intersections, "model triangle", "cage triangle"));
  add(c.vertices_outside, "model vertex", " not inside" + place_text(c.first_vertices_outside));
  if (!c.message.empty()) text += "  " + one_line(c.message) + "\n";
  return text;
}

std::string tightness_text(const Report::Tightness& t) {
  const auto figure = [](const std::optional<double>& value) { return value ? figure_text(*value) : "unknown"; };
  return "volume ratio: " + figure(t.volume_ratio) + "\n" + "gap over the diagonal: mean " +
         figure(t.mean_gap_over_diagonal) + ", largest " + figure(t.max_gap_over_diagonal) + ", least " +
         figure(t.clearance_over_diagonal) + "\n";
}

}  // namespace cagewright::host
