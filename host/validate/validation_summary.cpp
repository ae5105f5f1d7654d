// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/file_error.h"
#include "host/validate/validation_file.h"

namespace cagewright::host {
namespace {

std::string percent(double share) { return text_of(100 * share) + " %"; }

std::string tighter_text(const char* name, const TighterCage& tighter) {
  return std::string("optimality gap, ") + name + ": " + percent(tighter.gap) + " (volume ratio " +
         text_of(tighter.volume_ratio) + (tighter.settled ? "" : ", stopped by the clock") + ")\n";
}

const Check* equation_8_of(const Validation& validation) {
  for (const Check& check : validation.checks) {
    if (check.claim.find("equation (8)") != check.claim.npos && check.unit == "of the diagonal") return &check;
  }
  return nullptr;
}

}  // namespace

std::string validation_summary(const Validation& v) {
  std::string text;
  if (!v.node.empty()) text += v.node + "\n";
  std::size_t comparisons = 0, faults = 0;
  for (const Check& check : v.checks) {
    comparisons += check.count;
    faults += check.holds() ? 0 : 1;
  }
  text += "checks: " + std::to_string(v.checks.size() - faults) + " of " + std::to_string(v.checks.size()) + " hold, " +
          std::to_string(comparisons) + " comparisons\n";
  for (const Check& check : v.checks) {
    if (!check.holds()) text += "  " + check.fault + "\n";
  }
  if (const Check* check = equation_8_of(v)) {
    text += "equation (8): " + counted(v.iterations, "iteration") + ", at most " + text_of(check->worst) +
            " of the diagonal apart\n";
  }
  const OrientationFigures& o = v.orientation;
  text += "equation (1): sections " + percent(o.plugin_off) + ", linear solution " + percent(o.linear_off) +
          " above the best of " + std::to_string(o.starts) + " random starts\n";
  if (v.optimality) {
    text += "volume ratio: " + text_of(v.optimality->volume_ratio) + "\n" +
            tighter_text("sections as they have to be", v.optimality->shaped) +
            tighter_text("sections free", v.optimality->free);
  } else if (!v.certified) {
    text += "optimality gap: none, for the cage, whose limbs are not merged here (enclose.merge), is not certified\n";
  }
  return text;
}

}  // namespace cagewright::host
