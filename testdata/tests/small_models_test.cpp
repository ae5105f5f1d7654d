// SPDX-License-Identifier: BSD-3-Clause
// The files of testdata/small have the properties in their names, and counting facts finds them.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <string>

#include "testdata/generate/mesh_facts.h"

namespace cagewright::testdata {
namespace {

const std::filesystem::path kFolder = CAGEWRIGHT_SMALL_MODELS;

struct Expected {
  const char* file;
  std::size_t vertices, triangles;
  int genus;
  std::size_t open, non_manifold, inconsistent, bow_ties, components;
  std::size_t repeated, unused, degenerate;
  const char* complaint;  // what broken_promise says of it, asked for its own genus
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

constexpr Expected kExpected[] = {
    {"closed_tetrahedron.off", 4, 4, 0, 0, 0, 0, 0, 1, 0, 0, 0, ""},
    {"closed_cube.obj", 8, 12, 0, 0, 0, 0, 0, 1, 0, 0, 0, ""},
    {"closed_octahedron.off", 6, 8, 0, 0, 0, 0, 0, 1, 0, 0, 0, ""},
    {"closed_two_components.off", 8, 8, 0, 0, 0, 0, 0, 2, 0, 0, 0, "has 2 components instead of one"},
    {"genus1_torus.off", 9, 18, 1, 0, 0, 0, 0, 1, 0, 0, 0, ""},
    {"genus2_slab_with_two_holes.off", 48, 100, 2, 0, 0, 0, 0, 1, 0, 0, 0, ""},
    {"open_triangle.off", 3, 1, -1, 3, 0, 0, 0, 1, 0, 0, 0, "is not closed: 3 open edges"},
    {"open_cube_without_lid.obj", 8, 10, -1, 4, 0, 0, 0, 1, 0, 0, 0, "is not closed: 4 open edges"},
    {"bow_tie_two_tetrahedra.off", 7, 8, -1, 0, 0, 0, 1, 1, 0, 0, 0, "is not manifold: 1 bow-tie vertices"},
    {"non_manifold_edge_fin.off", 5, 5, -1, 2, 1, 0, 0, 1, 0, 0, 0, "is not closed: 2 open edges"},
    {"non_manifold_edge_two_tetrahedra.off", 6, 8, -1, 0, 1, 0, 0, 1, 0, 0, 0,
     "is not manifold: 1 edges with 3 triangles or more"},
    {"inside_out_tetrahedron.off", 4, 4, 0, 0, 0, 0, 0, 1, 0, 0, 0, "is inside out"},
    {"one_triangle_turned_tetrahedron.off", 4, 4, -1, 0, 0, 3, 0, 1, 0, 0, 0, "has 3 edges run twice the same way"},
    {"duplicated_vertices_cube.obj", 24, 12, -1, 24, 0, 0, 0, 6, 16, 0, 0, "is not closed: 24 open edges"},
    {"duplicated_vertices_tetrahedron.off", 12, 4, -1, 12, 0, 0, 0, 4, 8, 0, 0, "is not closed: 12 open edges"},
    {"degenerate_triangle_repeated_corner.off", 4, 5, -1, 1, 1, 0, 0, 1, 0, 0, 1, "is not closed: 1 open edges"},
    {"unused_vertex_tetrahedron.off", 5, 4, 0, 0, 0, 0, 0, 1, 0, 1, 0, "has 1 vertices that no triangle uses"},
    {"not_orientable_projective_plane.off", 6, 10, -1, 0, 0, 10, 0, 1, 0, 0, 0, "has 10 edges run twice the same way"},
};

constexpr const char* kBroken[] = {"broken_index_out_of_range.off", "broken_not_a_number.off", "broken_ends_early.off"};

class SmallModel : public testing::TestWithParam<Expected> {};

TEST_P(SmallModel, HasThePropertiesInItsName) {
  const Expected& expected = GetParam();
  const MeshFacts facts = count_facts(read_mesh(kFolder / expected.file));
  EXPECT_EQ(facts.vertices, expected.vertices);
  EXPECT_EQ(facts.triangles, expected.triangles);
  EXPECT_EQ(facts.genus, expected.genus);
  EXPECT_EQ(facts.open_edges, expected.open);
  EXPECT_EQ(facts.non_manifold_edges, expected.non_manifold);
  EXPECT_EQ(facts.inconsistent_edges, expected.inconsistent);
  EXPECT_EQ(facts.bow_tie_vertices, expected.bow_ties);
  EXPECT_EQ(facts.components, expected.components);
  EXPECT_EQ(facts.repeated_positions, expected.repeated);
  EXPECT_EQ(facts.unused_vertices, expected.unused);
  EXPECT_EQ(facts.degenerate_triangles, expected.degenerate);
}

TEST_P(SmallModel, IsRefusedForWhatItsNameSays) {
  const Expected& expected = GetParam();
  const MeshFacts facts = count_facts(read_mesh(kFolder / expected.file));
  EXPECT_EQ(broken_promise(facts, std::max(expected.genus, 0)), expected.complaint);
}

INSTANTIATE_TEST_SUITE_P(Testdata, SmallModel, testing::ValuesIn(kExpected), [](const auto& test) {
  std::string name = test.param.file;
  name.resize(name.find('.'));
  return name;
});

TEST(SmallModels, BrokenFilesAreRefusedByName) {
  for (const std::string file : kBroken) {
    try {
      read_mesh(kFolder / file);
      ADD_FAILURE() << file << " was read";
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
    }
  }
}

TEST(SmallModels, EveryFileIsTested) {
  std::set<std::string> tested{"README.md"};
  for (const Expected& expected : kExpected) tested.insert(expected.file);
  for (const char* file : kBroken) tested.insert(file);
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) there.insert(entry.path().filename().string());
  EXPECT_EQ(there, tested);
}

TEST(SmallModels, AnUnexpectedGenusIsRefused) {
  const MeshFacts facts = count_facts(read_mesh(kFolder / "genus1_torus.off"));
  EXPECT_EQ(broken_promise(facts, 0), "has genus 1 instead of 0");
}

TEST(SmallModels, WrittenNumbersReadBackToTheSameBits) {
  TriangleMesh mesh = read_mesh(kFolder / "closed_tetrahedron.off");
  mesh.vertices[0] = {0.1, 1.0 / 3, -1e-17};
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "cagewright_round_trip.off";
  write_off(file, mesh);
  const TriangleMesh again = read_mesh(file);
  std::filesystem::remove(file);
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.triangles, mesh.triangles);
}

TEST(SmallModels, AFileThatCannotBeWrittenIsNamed) {
  const std::filesystem::path file = kFolder / "no_such_folder" / "model.off";
  try {
    write_off(file, {});
    FAIL() << "it was written";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cagewright::testdata
