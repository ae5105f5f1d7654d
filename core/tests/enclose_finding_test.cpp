// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/enclose/finding.h"

namespace cagewright {
namespace {

const std::vector<std::string> names = {"hip", "knee", "heel", "wrist", "elbow", "neck", "tail", "ear"};

TEST(Finding, OfOneSectionOffItsPlaneIsInTheSingular) {
  EXPECT_EQ(off_plane_finding({1}, names).sentence,
            "the cage encloses the model, but the section of the slide 'knee' could not stay in its plane and near to "
            "square: move or turn this slide, or add one beside it");
  EXPECT_EQ(
      off_plane_finding({1, 3}, names).sentence,
      "the cage encloses the model, but the sections of the slides 'knee', 'wrist' could not stay in their planes "
      "and near to square: move or turn these slides, or add one beside them");
}

TEST(Finding, OfMergedLimbsNamesEverySlideThatLostItsSection) {
  const Finding finding = merged_finding({{0, 1}, {2, 3}}, {1, 5}, names);
  EXPECT_EQ(finding.sentence,
            "the cages of the limbs at 'hip' and 'knee', and those at 'heel' and 'wrist' run into each other and were "
            "made one there, which took away the sections of the slides 'knee', 'neck': move or turn these slides, or "
            "add one beside them, to keep them apart");
  EXPECT_EQ(finding.slides, (std::vector<int>{0, 1, 2, 3, 5}));
  EXPECT_EQ(
      merged_finding({{0, 1}}, {}, names).sentence,
      "the cages of the limbs at 'hip' and 'knee' run into each other and were made one there: move or turn these "
      "slides, or add one beside them, to keep them apart");
}

TEST(Finding, OfManyMergedLimbsNamesThreePairs) {
  const Finding finding = merged_finding({{0, 1}, {2, 3}, {4, 5}, {6, 7}}, {}, names);
  EXPECT_NE(finding.sentence.find("and those at 'elbow' and 'neck', and others run into"), std::string::npos)
      << finding.sentence;
  EXPECT_EQ(finding.slides, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(Finding, OnlyADistanceThatIsNotKeptIsNoAdvice) {
  TooNear near;
  near.slides = {2};
  near.conflicts = {{2, 4}};
  const Finding finding = too_near_finding(near, 0.01, Vector3::Zero(), names);
  EXPECT_FALSE(finding.is_advice);
  EXPECT_EQ(finding.slides, (std::vector<int>{2, 4}));
  EXPECT_NE(finding.sentence.find("; in each other's way may be the limbs at 'heel' and 'elbow'"), std::string::npos);
  EXPECT_TRUE(off_plane_finding({1}, names).is_advice);
  EXPECT_TRUE(too_large_finding(3, Vector3::Zero(), {1}, names).is_advice);
  EXPECT_TRUE(merged_finding({{0, 1}}, {}, names).is_advice);
}

}  // namespace
}  // namespace cagewright
