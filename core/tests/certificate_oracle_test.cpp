// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "core/enclose/certificate.h"
#include "core/parallel/parallel_for.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/meshes.h"
#include "core/tests/off_file.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"
#include "testdata/oracle/oracle.h"

// The certificate against an independent judge, with exact predicates of its own. CAGEWRIGHT_ORACLE comes from CMake
// and may be empty.
//
// What the judge's words mean, where they are not ours:
// - it repairs a cage before it judges it: it merges vertices at equal positions and equal triangles, drops triangles
//   that name a vertex twice, turns the triangles of a component as the first of them is, and gives the fans of a
//   bow-tie or non-manifold vertex vertices of their own;
// - closed: no edge with one triangle; which way a component faces is not asked;
// - self-intersecting: the same pairs as ours, and a triangle without area with itself, which meets no other;
// - outside: the solid angles of the cage's triangles at the vertex sum to less than half a turn. On the cage itself
//   that is about the angle there, or chance; to us a vertex on the cage is not inside.
namespace cagewright {
namespace {

std::string text_of(const Certificate& c) {
  return std::string(c.closed ? "closed" : "not closed") + ", " + std::to_string(c.degenerate_triangles.size()) +
         " degenerate, " + std::to_string(c.self_intersections.size()) + " pairs, " +
         std::to_string(c.model_cage_intersections.size()) + " crossing, " + std::to_string(c.vertices_outside.size()) +
         " outside";
}

std::string text_of(const OracleVerdict& v) {
  return std::string(v.closed ? "closed" : "not closed") + ", " + std::to_string(v.self_intersecting) + " pairs, " +
         std::to_string(v.crossing) + " crossing, " + std::to_string(v.outside) + " outside";
}

std::string text_of(const Certificate& ours, const OracleVerdict& theirs) {
  return "ours: " + text_of(ours) + "; the oracle's: " + text_of(theirs);
}

bool agree(const Certificate& ours, const OracleVerdict& theirs) {
  return ours.closed == theirs.closed && ours.self_intersections.size() == theirs.self_intersecting &&
         ours.degenerate_triangles.empty() && ours.model_cage_intersections.size() == theirs.crossing &&
         ours.vertices_outside.size() == theirs.outside && ours.encloses() == theirs.encloses();
}

// A trunk on four legs, coarser than those of shapes.h, since the judge takes its time.
shapes::SlidBody walker(int slides_on_each_leg) {
  const Vector3 hip(-0.6, 0.05, 0), chest(0.65, 0, 0.1);
  const std::vector<shapes::Tube> tubes = {{hip, chest, 0.5},
                                           {hip, {-1.3, 0.6, -1.4}, 0.3},
                                           {hip, {-1.1, -0.8, -1.5}, 0.32},
                                           {chest, {1.2, 0.7, -1.4}, 0.31},
                                           {chest, {1.4, -0.7, -1.5}, 0.3}};
  shapes::SlidBody body{"walker", shapes::body_of(tubes, 0.2), {}, 0};
  body.name += " with " + std::to_string(4 * slides_on_each_leg) + " slides";
  for (std::size_t leg = 1; leg < tubes.size(); ++leg)
    for (int k = 0; k < slides_on_each_leg; ++k)
      body.slides.push_back(shapes::slide_across("leg", tubes[leg], 0.55 + 0.3 * k));
  return body;
}

// A cage of the pipeline, refined or made to enclose, with noise on one vertex or on all.
struct Perturbed {
  std::size_t body = 0;
  std::string name;
  IndexedMesh cage;
  Certificate ours;
  std::optional<OracleVerdict> theirs;
};

constexpr std::array noise = {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1};  // of the diagonal, at most

void add_perturbed(std::vector<Perturbed>& all, std::size_t body, const std::string& name, const IndexedMesh& cage,
                   double diagonal, int trials) {
  Random random(static_cast<unsigned>(all.size()) + 1);
  for (int trial = 0; trial < trials; ++trial) {
    const double size = noise[static_cast<std::size_t>(trial / 2) % noise.size()];
    Perturbed perturbed{body, name, cage, {}, {}};
    const auto shake = [&](Eigen::Index v) {
      perturbed.cage.points.row(v) += size * diagonal * random.uniform(0.1, 1) * random.direction().transpose();
    };
    if (trial % 2 == 0) {
      shake(random.below(static_cast<int>(cage.points.rows())));
    } else {
      for (Eigen::Index v = 0; v < cage.points.rows(); ++v) shake(v);
    }
    perturbed.name += ", trial " + std::to_string(trial);
    all.push_back(std::move(perturbed));
  }
}

std::vector<Perturbed> perturbed_cages(const std::vector<shapes::SlidBody>& bodies) {
  std::vector<Perturbed> all;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const bool encloses : {false, true}) {
      PipelineOptions options;
      options.refine.in_plane = encloses;
      options.last_stage = encloses ? Stage::enclose : Stage::refine;
      const Model model = prepare_model(bodies[b].mesh);
      const PipelineResult result = make_cage(model, bodies[b].slides, options);
      add_perturbed(all, b, bodies[b].name + (encloses ? ", enclosing" : ", refined"),
                    {result.cage->points, result.cage->triangles}, model.diagonal,
                    1000 / (2 * static_cast<int>(bodies.size())));
    }
  return all;
}

TEST(CertificateOracle, AgreesOnAThousandPerturbedCages) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const std::vector<shapes::SlidBody> bodies = {walker(1), walker(2)};
  std::vector<std::unique_ptr<TemporaryOff>> models;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    models.push_back(std::make_unique<TemporaryOff>(bodies[b].mesh, "model" + std::to_string(b)));
  std::vector<Perturbed> all = perturbed_cages(bodies);
  ASSERT_EQ(all.size(), 1000u);
  parallel_for(all.size(), 0, [&](std::size_t i) {
    Perturbed& one = all[i];
    one.ours = certify(bodies[one.body].mesh, one.cage, 1);
    const TemporaryOff cage(one.cage, "perturbed" + std::to_string(i));
    one.theirs = OracleVerdict(ask_oracle(oracle, models[one.body]->path(), cage.path()));
  });
  int enclosing = 0, meeting_themselves = 0, crossing = 0, outside = 0;
  for (const Perturbed& one : all) {
    EXPECT_TRUE(agree(one.ours, *one.theirs)) << one.name << ": " << text_of(one.ours, *one.theirs);
    enclosing += one.ours.encloses();
    meeting_themselves += !one.ours.self_intersections.empty();
    crossing += !one.ours.model_cage_intersections.empty();
    outside += !one.ours.vertices_outside.empty();
  }
  // There is something of everything.
  EXPECT_GT(enclosing, 100);
  EXPECT_GT(meeting_themselves, 50);
  EXPECT_GT(crossing, 300);
  EXPECT_GT(outside, 300);
  EXPECT_LT(outside, crossing) << "some only have an edge or a face poking through";
}

struct Posed {
  std::string name;
  IndexedMesh model, cage;
  bool encloses = false;
  bool same_closed = true, same_pairs = true, same_crossing = true, same_outside = true;  // those figures agree, too
};

void expect_agreement(const std::vector<Posed>& all) {
  for (const Posed& posed : all) {
    const TemporaryOff model(posed.model, "posed_model"), cage(posed.cage, "posed_cage");
    const Certificate ours = certify(posed.model, posed.cage);
    const OracleVerdict theirs(ask_oracle(oracle, model.path(), cage.path()));
    SCOPED_TRACE(posed.name + ": " + text_of(ours, theirs));
    EXPECT_EQ(ours.encloses(), posed.encloses);
    EXPECT_EQ(theirs.encloses(), posed.encloses);
    if (posed.same_closed) {
      EXPECT_EQ(ours.closed, theirs.closed);
    }
    if (posed.same_pairs) {
      EXPECT_EQ(ours.self_intersections.size(), theirs.self_intersecting);
    }
    if (posed.same_crossing) {
      EXPECT_EQ(ours.model_cage_intersections.size(), theirs.crossing);
    }
    if (posed.same_outside) {
      EXPECT_EQ(ours.vertices_outside.size(), theirs.outside);
    }
  }
}

IndexedMesh cube(double half) { return meshes::box(Vector3::Constant(-half), Vector3::Constant(half)); }

IndexedMesh moved_vertex(IndexedMesh mesh, Eigen::Index v, const Vector3& to) {
  mesh.points.row(v) = to.transpose();
  return mesh;
}

Eigen::Index highest(const IndexedMesh& mesh) {
  Eigen::Index row = 0;
  mesh.points.col(2).maxCoeff(&row);
  return row;
}

// The triangle t of the mesh in three, round a new vertex, the last row.
IndexedMesh with_vertex_in(const IndexedMesh& mesh, Eigen::Index t, const Vector3& point) {
  IndexedMesh result{Points(mesh.points.rows() + 1, 3), Triangles(mesh.triangles.rows() + 2, 3)};
  result.points << mesh.points, point.transpose();
  result.triangles.topRows(mesh.triangles.rows()) = mesh.triangles;
  const auto corners = mesh.triangles.row(t).eval();
  const int middle = static_cast<int>(mesh.points.rows());
  result.triangles.row(t) << corners(0), corners(1), middle;
  result.triangles.bottomRows(2) << corners(1), corners(2), middle, corners(2), corners(0), middle;
  return result;
}

Vector3 inside_triangle(const IndexedMesh& mesh, Eigen::Index t, const Vector3& weights) {
  return mesh.points(Eigen::Vector3i(mesh.triangles.row(t)), Eigen::all).transpose() * weights;
}

TEST(CertificateOracle, AgreesOnModelsThatTouchTheCage) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const IndexedMesh cage = cube(2), ball = meshes::icosphere(1);
  const auto tetrahedron = [](const Vector3& apex) { return moved_vertex(meshes::tetrahedron(), 3, apex); };
  const double above = std::nextafter(1.0, 2.0);
  // Of vertices on the cage the judge's solid angles tell nothing.
  const auto touching = [](const std::string& name, const IndexedMesh& model, const IndexedMesh& round) {
    return Posed{name, model, round, false, true, true, true, false};
  };
  const IndexedMesh beside = meshes::box({-1, -1, -1}, {1, 1, 1});
  expect_agreement({
      touching("a vertex in a face", tetrahedron({0.3, -0.7, 2}), cage),
      touching("a vertex on an edge", tetrahedron({0.5, 2, 2}), cage),
      touching("a vertex on the diagonal of a face", tetrahedron({0.5, 0.5, 2}), cage),
      touching("a vertex on a vertex", tetrahedron({2, 2, 2}), cage),
      touching("an edge in a face", moved_vertex(tetrahedron({0.3, -0.7, 2}), 2, {-0.9, 0.2, 2}), cage),
      touching("an edge on an edge", moved_vertex(tetrahedron({1, 2, 2}), 1, {-1, 2, 2}), cage),
      touching("an edge across a face", moved_vertex(tetrahedron({2, 0.3, 2}), 1, {-2, 1, 2}), cage),
      touching("a face in a face", meshes::box({-1, -1, -1}, {1, 1, 2}), cage),
      touching("a face on the same face", meshes::box({-2, -2, -1}, {2, 2, 2}), cage),
      touching("faces in all faces but one", meshes::box({-2, -2, -2}, {2, 2, 1}), cage),
      touching("a cage vertex in a model face", beside,
               moved_vertex(meshes::moved(ball, 3, Vector3::Zero()), highest(ball), {0.25, 0.5, 1})),
      touching("a cage vertex on a model vertex", beside,
               moved_vertex(meshes::moved(ball, 3, Vector3::Zero()), highest(ball), {1, 1, 1})),
      touching("a cage edge across a model edge", beside,
               moved_vertex(moved_vertex(meshes::moved(ball, 3, Vector3::Zero()), 0, {0.5, 0.25, 1.5}), 5,
                            {1.5, 0.25, 0.5})),
      {"by the smallest number inside", beside, meshes::box({-2, -2, -2}, {2, 2, above}), true},
      {"by the smallest number outside", beside, meshes::box({-2, -2, -2}, {2, 2, std::nextafter(1.0, 0.0)}), false},
      {"by a hair in a skew face", tetrahedron({0.3, -0.7, std::nextafter(2.0, 0.0)}), cage, true},
      touching("the model itself, a box", beside, beside),
      touching("the model itself, a ball", ball, ball),
      {"the model itself, turned inside out", ball, meshes::inside_out(ball), false, false, true, true, false},
      touching("the model itself, walking", walker(1).mesh, walker(1).mesh),
  });
}

TEST(CertificateOracle, AgreesOnCagesThatTouchThemselves) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const IndexedMesh model = meshes::moved(meshes::icosphere(1), 0.1, {0.2, 0.2, 0.2}), box = cube(2);
  const auto boxes = [&](const Vector3& min, const Vector3& max) {
    return meshes::together(box, meshes::box(min, max));
  };
  // To us a bow-tie, or a vertex or an edge that two shells both have by position, is no closed 2-manifold, and what
  // triangles have in common by number is not a place where they meet. The judge parts the shells, says that each is
  // closed and finds that they touch, or the other way round joins them first.
  const auto joined = [&](const std::string& name, const IndexedMesh& inside, const IndexedMesh& cage) {
    return Posed{name, inside, cage, false, false, false};
  };
  const auto in = [](const Vector3& center) { return meshes::moved(meshes::icosphere(1), 0.1, center); };
  expect_agreement({
      {"two boxes, a vertex in a face", model,
       meshes::together(box, meshes::moved(moved_vertex(meshes::tetrahedron(), 0, {-1, 0.25, 0.25}), 1, {3, 0, 0})),
       false},
      {"two boxes, an edge in a face", model,
       meshes::together(
           box, moved_vertex(moved_vertex(meshes::moved(meshes::tetrahedron(), 1, {3, 0, 0}), 0, {2, 0.25, 0.5}), 3,
                             {2, 0.5, 1.25})),
       false},
      {"two boxes, a part of a face in common", model, boxes({2, -1, -1}, {3, 1, 1}), false},
      {"two boxes, coplanar faces that overlap", model, boxes({2, 1, 1}, {3, 3, 3}), false},
      {"two boxes, faces in one plane side by side", model, boxes({3, -2, -2}, {4, 2, 2}), true},
      joined("two boxes, the same face", model, boxes({2, -2, -2}, {4, 2, 2})),
      joined("two boxes, the same edge", model, boxes({2, 2, -2}, {4, 4, 2})),
      joined("two boxes, the same vertex", model, boxes({2, 2, 2}, {4, 4, 4})),
      joined("a bow-tie", in({0.2, 0.2, 0.2}), meshes::bow_tie()),
      joined("an edge with four triangles", in({0.5, 0.5, 0.5}), meshes::bow_tie_edge()),
      joined("an edge with four triangles, vertices apart", in({0.5, 0.5, 0.5}), meshes::touching_boxes()),
      joined("a pinched ring", in({0.5, 0.5, 0.5}), meshes::pinched_ring()),
      joined("a seam", in({0.5, 0.5, 0.5}), meshes::seamed_pinch()),
      {"a fold, flat over the vertex between two edges", model,
       with_vertex_in(box, 0, inside_triangle(box, 0, {1.25, 0.5, -0.75})), false},
      {"a fold, flat over an edge", model, with_vertex_in(box, 0, inside_triangle(box, 0, {-0.5, 0.75, 0.75})), false},
      {"coplanar triangles that do not overlap", model,
       with_vertex_in(box, 0, inside_triangle(box, 0, {0.5, 0.25, 0.25})), true},
      // Without area: no certificate. The judge counts each as a pair with itself.
      {"a triangle without area", model, with_vertex_in(box, 0, inside_triangle(box, 0, {0.5, 0.5, 0})), false, false,
       false},
  });
}

TEST(CertificateOracle, AgreesOnComponents) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const IndexedMesh ball = meshes::icosphere(1), box = cube(3);
  const IndexedMesh far = meshes::moved(ball, 1, {9, 0, 0});
  const IndexedMesh small = meshes::moved(ball, 0.2, {2.5, 2.5, 2.5});
  const IndexedMesh shell = cube(2);
  const IndexedMesh two = meshes::together(ball, far);
  expect_agreement({
      {"one box round each", two, meshes::together(box, meshes::moved(shell, 1, {9, 0, 0})), true},
      {"a box round one of two", two, box, false},
      {"a box with an empty one beside it", ball, meshes::together(box, far), true},
      {"a box with a cavity beside the model", ball, meshes::together(box, meshes::inside_out(small)), true},
      {"the model in the cavity", ball, meshes::together(box, meshes::inside_out(shell)), false},
      {"a box in a box", ball, meshes::together(box, shell), true},
      {"a cavity in a box in a box", ball,
       meshes::together(meshes::together(box, shell), meshes::inside_out(meshes::moved(small, 1, {-0.9, -0.9, -0.9}))),
       true},
      {"two boxes that cross, the model in both", ball, meshes::together(box, meshes::moved(box, 1, {0.5, 0.5, 0.5})),
       false},
      // Which way a component faces is ours to ask.
      {"an inward box", ball, meshes::inside_out(box), false, false},
      {"an outward box in an inward one", ball, meshes::together(meshes::inside_out(box), shell), false, false},
      {"a box round another place", ball, far, false},
      {"a torus with the model in its hole", meshes::moved(ball, 0.3, Vector3::Zero()), meshes::torus(2, 0.5, 16, 8),
       false},
      {"a torus with the model in its ring", meshes::moved(ball, 0.2, {2, 0, 0}), meshes::torus(2, 0.7, 16, 8), true},
  });
}

// What the judge's repair makes good, and which way a component faces: the one kind of disagreement. It goes one way:
// we refuse what it would let pass.
TEST(CertificateOracle, LetsPassWhatIsRefusedForHowTheCageIsWritten) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const IndexedMesh ball = meshes::icosphere(1), box = cube(3);
  IndexedMesh turned = box, doubled = box, with_edge = box;
  turned.triangles.row(5).reverseInPlace();
  for (IndexedMesh* mesh : {&doubled, &with_edge}) mesh->triangles.conservativeResize(box.triangles.rows() + 1, 3);
  doubled.triangles.bottomRows(1) = box.triangles.row(4);
  with_edge.triangles.bottomRows(1) << 0, 1, 1;
  const std::vector<std::pair<std::string, IndexedMesh>> cages = {
      {"a triangle turned over", turned},
      {"a triangle twice", doubled},
      {"all triangles twice", meshes::together(box, box)},
      {"a triangle that names a vertex twice", with_edge},
      {"a vertex for every corner", meshes::with_own_vertices(box)},
      {"an inward component beside", meshes::together(box, meshes::inside_out(meshes::moved(ball, 1, {9, 0, 0})))},
  };
  for (const auto& [name, mesh] : cages) {
    const TemporaryOff model(ball, "ball"), cage(mesh, "written");
    const Certificate ours = certify(ball, mesh);
    const OracleVerdict theirs(ask_oracle(oracle, model.path(), cage.path()));
    SCOPED_TRACE(name + ": " + text_of(ours, theirs));
    EXPECT_FALSE(ours.encloses());
    EXPECT_FALSE(ours.closed);
    EXPECT_TRUE(theirs.encloses());
  }
}

TEST(CertificateOracle, AgreesThatAnOpenCageEnclosesNothing) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const IndexedMesh ball = meshes::moved(meshes::icosphere(1), 0.1, {2, 0, 0});
  // Of a cage that is not closed what is inside is up to the ray, or to the angle.
  const auto open = [&](const std::string& name, const IndexedMesh& cage) {
    return Posed{name, ball, cage, false, true, true, true, false};
  };
  expect_agreement(
      {open("a box with a hole", meshes::without_triangle(cube(3), 3)),
       // The judge cuts it open where it turns over, and finds that the two sides of the cut touch.
       {"a Moebius band", ball, meshes::moebius_band(12), false, true, false, true, false},
       open("a box with a hole beside a whole one",
            meshes::together(cube(3), meshes::without_triangle(meshes::moved(cube(1), 1, {9, 0, 0}), 0)))});
}

}  // namespace
}  // namespace cagewright
