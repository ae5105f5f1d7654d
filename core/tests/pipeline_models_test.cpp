// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/enclose/enclose.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/meshes.h"
#include "core/tests/model_files.h"
#include "core/tests/shapes.h"

// The properties of the pipeline on models of tens of thousands of triangles; one that is in no folder is skipped.
namespace cagewright {
namespace {

class PipelineOnModel : public testing::TestWithParam<const char*> {};

TEST_P(PipelineOnModel, MakesAClosedConvergedCageThatMovesWithIt) {
  const auto mesh = find_model(GetParam());
  if (!mesh) GTEST_SKIP() << GetParam() << ".off is in no model folder (see testdata/README.md)";
  const std::vector<Slide> slides = read_slides(GetParam());
  const Model model = prepare_model(*mesh);
  const PipelineResult here = make_cage(model, slides, {});
  checks::expect_closed_manifold(here.cage->points, here.cage->triangles, checks::genus_of_slides(here.segmentation));
  EXPECT_EQ(checks::genus_of_slides(here.segmentation), *model.report.genus);
  EXPECT_TRUE(here.refinement->converged);

  const shapes::Motion motion = shapes::random_motion(1, 0.01, 3);
  Model moved = prepare_model(shapes::moved(*mesh, motion));
  moved.diagonal = motion.scale * model.diagonal;  // that of an axis-aligned box: it alone does not turn with the model
  const PipelineResult there = make_cage(moved, shapes::moved(slides, motion), {});
  checks::expect_same_cage(*here.cage, *there.cage, 1e-6 * moved.diagonal, motion);

  const PipelineResult shuffled = make_cage(prepare_model(meshes::shuffled(*mesh, 1)), slides, {});
  EXPECT_EQ(here.segmentation.slide_parts, shuffled.segmentation.slide_parts);
  checks::expect_same_cage(*here.cage, *shuffled.cage, 1e-9 * model.diagonal);

  PipelineOptions three;
  three.refine.threads = 3;
  EXPECT_EQ(make_cage(model, slides, three).cage->points, here.cage->points);
}

TEST_P(PipelineOnModel, MakesACertifiedCageInPlaneAndFree) {
  const auto mesh = find_model(GetParam());
  if (!mesh) GTEST_SKIP() << GetParam() << ".off is in no model folder (see testdata/README.md)";
  const std::vector<Slide> slides = read_slides(GetParam());
  const std::vector<std::string> names = checks::names_of(slides);
  const Model model = prepare_model(*mesh);
  for (const bool in_plane : {true, false}) {
    SCOPED_TRACE(in_plane ? "in plane" : "free");
    PipelineOptions pipeline;
    pipeline.refine.in_plane = in_plane;
    const PipelineResult refined = make_cage(model, slides, pipeline);
    EncloseOptions options;
    options.in_plane = in_plane;
    const Enclosure enclosure = enclose(model, refined.segmentation, refined.sections, *refined.cage, names, options);
    const IndexedMesh cage = {enclosure.points, refined.cage->triangles};
    EXPECT_EQ(certify(*mesh, cage).encloses(), enclosure.certificate.encloses());
    EXPECT_LE(enclosure.most_off_square, 15);
    EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
    if (in_plane && std::string(GetParam()) == "man") {  // its armpits: see docs/decisions.md
      EXPECT_LE(enclosure.sections_off_plane.size(), 4u);
      EXPECT_NE(enclosure.shortfall.find("could not stay in their planes"), std::string::npos);
      EXPECT_NE(enclosure.shortfall.find("'chest'"), std::string::npos) << enclosure.shortfall;
    } else {
      EXPECT_TRUE(enclosure.shortfall.empty()) << enclosure.shortfall;
    }
    EXPECT_LT(checks::volume_of(cage), enclosure.first_volume);
    EXPECT_LT(checks::volume_of(cage), (in_plane ? 1.8 : 1.6) * model.volume);
  }
}

INSTANTIATE_TEST_SUITE_P(Own, PipelineOnModel,
                         testing::Values("biped", "quadruped", "octopus", "genus3", "blob", "legs"));
INSTANTIATE_TEST_SUITE_P(Real, PipelineOnModel, testing::Values("armadillo", "elk", "man", "bunny00", "elephant"));

}  // namespace
}  // namespace cagewright
