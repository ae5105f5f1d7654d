// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "core/error/error.h"

namespace cagewright {
namespace {

TEST(PointInSentences, ShowsNoRounding) {
  EXPECT_EQ(to_text({1.2, 0.4, 3}), "(1.2, 0.4, 3)");
  EXPECT_EQ(to_text({4.7e-17, 1.115, -0.119233}), "(0, 1.115, -0.119233)");
  EXPECT_EQ(to_text({-1e-12, 2e-12, 0}), "(-1e-12, 2e-12, 0)");
  EXPECT_EQ(to_text({0, 0, 0}), "(0, 0, 0)");
}

TEST(PointInSentences, ShowsWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_text({1e-20, infinity, -infinity}), "(1e-20, inf, -inf)");
}

}  // namespace
}  // namespace cagewright
