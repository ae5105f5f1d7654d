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
  const Finding finding = merged_finding({{0, 1}, {2, 3}}, {1, 5}, true, names);
  EXPECT_EQ(
      finding.sentence,
      "the cages of the limbs at 'hip' and 'knee', and those at 'heel' and 'wrist' run into each other and were "
      "made one there, which took away the sections of the slides 'knee', 'neck': let sections leave their slides' "
      "planes (enclose.in_plane=false), or move or turn these slides, or add one beside them, to keep them apart");
  EXPECT_EQ(finding.slides, (std::vector<int>{0, 1, 2, 3, 5}));
  EXPECT_EQ(
      merged_finding({{0, 1}}, {}, false, names).sentence,
      "the cages of the limbs at 'hip' and 'knee' run into each other and were made one there: move or turn these "
      "slides, or add one beside them, to keep them apart");
}

TEST(Finding, OfManyMergedLimbsNamesThreePairs) {
  const Finding finding = merged_finding({{0, 1}, {2, 3}, {4, 5}, {6, 7}}, {}, true, names);
  EXPECT_NE(finding.sentence.find("and those at 'elbow' and 'neck', and others run into"), std::string::npos)
      << finding.sentence;
  EXPECT_EQ(finding.slides, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(Finding, OfACageThatDoesNotEncloseNamesOnlyWhatIsThere) {
  Certificate certificate;
  certificate.closed = true;
  certificate.self_intersections = {{0, 1}};
  certificate.vertices_outside = {4, 7};
  const Finding finding = not_enclosing_finding(certificate, {1, 5}, true, false, names);
  EXPECT_EQ(finding.sentence,
            "the cage could not be made to enclose the model: 1 pair of its triangles crosses, 2 vertices of the model "
            "are outside; that is near the slides 'knee', 'neck': move or turn one of them, or add one between them");
  EXPECT_EQ(finding.slides, (std::vector<int>{1, 5}));
  EXPECT_FALSE(finding.is_advice);
  certificate.self_intersections.clear();
  certificate.vertices_outside = {4};
  certificate.model_cage_intersections = {{2, 0}, {3, 0}};
  certificate.degenerate_triangles = {9};
  EXPECT_EQ(
      not_enclosing_finding(certificate, {2}, false, true, names).sentence,
      "the cage could not be made to enclose the model: 1 of its triangles has no area, 2 triangles of the model "
      "cross it, 1 vertex of the model is outside; most of that is near the slide 'heel': move or turn it, or add "
      "one beside it, or let sections leave their slides' planes (enclose.in_plane=false)");
  EXPECT_EQ(not_enclosing_finding({}, {}, true, true, names).sentence,
            "the cage could not be made to enclose the model: it is not closed; add slides");
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
  EXPECT_TRUE(merged_finding({{0, 1}}, {}, false, names).is_advice);
}

}  // namespace
}  // namespace cagewright
