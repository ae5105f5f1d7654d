// SPDX-License-Identifier: BSD-3-Clause
//
// What the report and the page say.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/validate/validation_file.h"

namespace cagewright::host {
namespace {

ValidationReport report_with(const Check& check) {
  Validation validation;
  validation.checks = {check};
  validation.max_signed_distances = {0.02, 0.005, 0.0007};
  return {"a<b>.off", "1.0", {{"starts", "5"}}, {validation}};
}

Check failed_check() {
  Check check{"refine", "vertices are <there>", 1e-9, "of the diagonal"};
  check.offer(1e-12, [] { return std::string("unused"); });
  check.offer(2e-3, [] { return std::string("iteration 3, vertex 17"); });
  check.offer(1e-3, [] { return std::string("iteration 4, vertex 2"); });
  return check;
}

TEST(Check, KeepsTheWorstAndNamesItsStage) {
  const Check check = failed_check();
  EXPECT_FALSE(check.holds());
  EXPECT_EQ(check.fault, "refine: iteration 3, vertex 17");
  EXPECT_EQ(check.worst, 2e-3);
  EXPECT_EQ(check.count, 3u);
}

TEST(Check, TakesWhatIsNoNumberForTheWorst) {
  Check check = failed_check();
  check.offer(std::numeric_limits<double>::quiet_NaN(), [] { return std::string("no number"); });
  check.offer(1, [] { return std::string("later"); });
  EXPECT_EQ(check.fault, "refine: no number");
}

TEST(ValidationReport, HasTheFaultInTextJsonAndPage) {
  const ValidationReport report = report_with(failed_check());
  EXPECT_FALSE(report.agrees());
  EXPECT_NE(validation_summary(report.cages[0]).find("  refine: iteration 3, vertex 17\n"), std::string::npos);
  const auto json = nlohmann::json::parse(validation_json(report));
  EXPECT_EQ(json["agrees"], false);
  EXPECT_EQ(json["cages"][0]["checks"][0]["fault"], "refine: iteration 3, vertex 17");
  EXPECT_NE(validation_page(report, {}, "").find("refine: iteration 3, vertex 17"), std::string::npos);
}

TEST(ValidationPage, NeedsNoOtherFileAndEscapesNames) {
  const std::string page = validation_page(report_with(failed_check()), {{{"A picture", "\x89PNG"}}}, "");
  EXPECT_EQ(page.find("http"), page.npos);
  EXPECT_EQ(page.find("<b>.off"), page.npos);
  EXPECT_NE(page.find("a&lt;b&gt;.off"), page.npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,iVBORw==\""), page.npos);
  EXPECT_NE(page.find("vertices are &lt;there&gt;"), page.npos);
}

}  // namespace
}  // namespace cagewright::host
