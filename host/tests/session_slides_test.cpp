// SPDX-License-Identifier: BSD-3-Clause
//
// A session's slides, with the plug-in itself.
#include <gtest/gtest.h>

#include <cmath>

#include "host/plugin_client/plugin.h"
#include "host/plugin_client/plugin_error.h"
#include "host/plugin_client/session.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

// Closed, along x from 0 to `length`, 0.2 thick along y and z.
TriangleMesh bar(int length) {
  TriangleMesh mesh;
  for (int i = 0; i <= length; ++i)
    for (const auto& [y, z] : {std::pair{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}})
      mesh.points.insert(mesh.points.end(), {double(i), y, z});
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
  };
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(length); ++i)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      add(a, b + 4, b);
      add(a, a + 4, b + 4);
    }
  const auto end = static_cast<std::uint32_t>(4 * length);
  add(0, 1, 2);
  add(0, 2, 3);
  add(end, end + 2, end + 1);
  add(end, end + 3, end + 2);
  return mesh;
}

Slide across(const std::string& name, double x) { return {name, Slide::PointNormal{{x, 0, 0}, {1, 0, 0}}}; }

class SessionSlides : public ::testing::Test {
 protected:
  SessionSlides() : session(Plugin::load(REAL_PLUGIN), {}) { session.set_mesh(bar(10)); }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const SlideInfo& slide : session.slides()) names.push_back(slide.name);
    return names;
  }

  Session session;
};

using Names = std::vector<std::string>;

TEST_F(SessionSlides, KeepTheirIdsWhereTheyStayWhatTheyAre) {
  const auto first = session.set_slides({across("a", 1), across("b", 3), across("c", 5)});
  EXPECT_EQ(session.set_slides({across("a", 1), across("b", 3), across("c", 5)}), first);
  const auto more = session.set_slides({across("a", 1), across("b", 3.5), across("c", 5), across("d", 7)});
  EXPECT_EQ(std::vector(more.begin(), more.begin() + 3), first) << "one was moved, one is new";
  const auto renamed = session.set_slides({across("a", 1), across("x", 3.5), across("c", 5), across("d", 7)});
  EXPECT_EQ(renamed, more);
  const auto fewer = session.set_slides({across("a", 1), across("c", 5), across("d", 7)});
  EXPECT_EQ(fewer, (std::vector{more[0], more[2], more[3]}));
  EXPECT_EQ(names(), (Names{"a", "c", "d"}));
  EXPECT_EQ(session.slide_count(), 3u);
  EXPECT_TRUE(session.set_slides({}).empty());
  EXPECT_EQ(session.slide_count(), 0u);
}

TEST_F(SessionSlides, ComeInTheOrderGiven) {
  const auto first = session.set_slides({across("a", 1), across("c", 5)});
  const auto second = session.set_slides({across("a", 1), across("b", 3), across("c", 5)});
  EXPECT_EQ(names(), (Names{"a", "b", "c"}));
  EXPECT_EQ(second[0], first[0]);
  session.set_slides({across("c", 5), across("b", 3), across("a", 1)});
  EXPECT_EQ(names(), (Names{"c", "b", "a"}));
  session.set_slides({across("b", 3), across("a", 5), across("c", 1)});
  EXPECT_EQ(names(), (Names{"b", "a", "c"}));
  session.solve(1);
  ASSERT_EQ(session.sections().size(), 3u);
  EXPECT_NEAR(session.sections()[2].center[0], 1, 1e-9);
}

TEST_F(SessionSlides, StayWhereOneOfThoseGivenIsRefused) {
  session.set_slides({across("a", 1), across("b", 3), across("c", 5)});
  const auto ids = session.set_slides({across("a", 1), across("b", 3), across("c", 5)});
  const Slide flat{"d", Slide::PointNormal{{7, 0, 0}, {0, 0, 0}}};
  try {
    session.set_slides({across("a", 2), across("c", 5), flat});
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_SLIDE_DEGENERATE);
    EXPECT_NE(std::string(error.what()).find("'d'"), std::string::npos) << error.what();
  }
  EXPECT_EQ(names(), (Names{"a", "b", "c"}));
  EXPECT_EQ(session.slides()[0].info.id, ids[0]);
  EXPECT_EQ(session.set_slides({across("a", 1), across("b", 3), across("c", 5)})[0], ids[0]);
  EXPECT_THROW(session.set_slides({across("a", 1), across("a", 2)}), PluginError);
  EXPECT_EQ(names(), (Names{"a", "b", "c"}));
}

TEST_F(SessionSlides, AreChangedAndRemovedById) {
  const std::uint64_t a = session.add_slide(across("a", 1)), b = session.add_slide(across("b", 3));
  session.change_slide(a, across("z", 2));
  EXPECT_EQ(names(), (Names{"z", "b"}));
  session.remove_slide(a);
  EXPECT_EQ(names(), Names{"b"});
  EXPECT_EQ(session.slides()[0].info.id, b);
  EXPECT_THROW(session.remove_slide(a), PluginError);
}

TEST_F(SessionSlides, AreFittedWithoutBeingAdded) {
  for (const Slide& slide : {across("", 2.25), Slide{"", Slide::Point{{2.25, 0.1, 0.02}}},
                             Slide{"", Slide::Ellipse{{2.25, 0, 0}, {0, 0.115, 0}, {0, 0, 0.115}}}}) {
    const Slide::Ellipse ellipse = session.fit(slide);
    EXPECT_NEAR(ellipse.center[0], 2.25, 1e-4);
    EXPECT_NEAR(ellipse.center[1], 0, 1e-4);
    EXPECT_NEAR(std::hypot(ellipse.u[0], ellipse.u[1], ellipse.u[2]), 0.115, 1e-3);
    EXPECT_NEAR(ellipse.u[0], 0, 1e-5);
    EXPECT_NEAR(ellipse.v[0], 0, 1e-5);
  }
  EXPECT_EQ(session.slide_count(), 0u);
  EXPECT_TRUE(session.slides().empty());
}

TEST_F(SessionSlides, ThatTouchAreBothMarkedAndThePlaceIsTold) {
  const auto ids =
      session.set_slides({across("a", 1), across("b", 5), {"c", Slide::PointNormal{{5, 0, 0}, {1, 1, 0}}}});
  try {
    session.solve(1);
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_SLIDES_TOUCH);
    EXPECT_EQ(error.info().slide, ids[1]);
    EXPECT_EQ(error.info().other_slide, ids[2]);
    ASSERT_EQ(error.info().has_point, 1u);
    EXPECT_NEAR(error.info().point[0], 5, 0.2);
    const std::vector<SlideInfo> slides = session.slides();
    EXPECT_EQ(slides[0].info.status, CGW_SLIDE_UNSOLVED);
    for (const std::size_t k : {1u, 2u}) {
      EXPECT_EQ(slides[k].info.status, CGW_ERROR_SLIDES_TOUCH);
      EXPECT_EQ(slides[k].message, error.what());
    }
  }
  session.change_slide(ids[2], across("c", 7));
  session.solve(1);
  for (const SlideInfo& slide : session.slides()) EXPECT_EQ(slide.info.status, CGW_OK) << slide.message;
}

TEST_F(SessionSlides, ThatMissTheModelTellWhere) {
  const auto ids = session.set_slides({across("a", 1), {"b", Slide::Point{{5, 2, 0}}}});
  try {
    session.solve(1);
    ADD_FAILURE();
  } catch (const PluginError& error) {
    EXPECT_EQ(error.status(), CGW_ERROR_SLIDE_MISSES_MODEL);
    EXPECT_EQ(error.info().slide, ids[1]);
    EXPECT_EQ(error.info().other_slide, CGW_NO_ID);
    ASSERT_EQ(error.info().has_point, 1u);
    EXPECT_EQ(error.info().point[1], 2);
  }
  EXPECT_EQ(session.slides()[1].info.status, CGW_ERROR_SLIDE_MISSES_MODEL);
}

TEST_F(SessionSlides, HaveTheLoopsThatTheyCut) {
  session.set_slides({across("a", 2.5), {"b", Slide::Point{{5.25, 0.1, 0.02}}}});
  session.solve(1, true);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<Point3> loop = session.loop(k);
    ASSERT_GE(loop.size(), 4u);
    for (const Point3& point : loop) EXPECT_NEAR(point[0], k == 0 ? 2.5 : 5.25, 1e-4);
  }
  EXPECT_THROW(session.loop(2), PluginError);
}

TEST_F(SessionSlides, AreNotEnclosedWhileEditing) {
  session.set_slides({across("a", 2.5), across("b", 6)});
  session.solve(1);
  EXPECT_EQ(session.summary().last_stage, CGW_STAGE_ENCLOSE);
  session.solve(1, true);
  EXPECT_EQ(session.summary().last_stage, CGW_STAGE_REFINE);
  EXPECT_LE(session.summary().iterations, 10u);
}

}  // namespace
}  // namespace cagewright::host
