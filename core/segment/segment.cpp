// SPDX-License-Identifier: BSD-3-Clause
#include "core/segment/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/segment/cut_mesh.h"
#include "core/segment/enclosed.h"

namespace cagewright {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;

// Connected components of the triangles, with the loops as walls.
std::vector<int> flood(const CutMesh& cut, int& count) {
  const HalfEdgeMesh& mesh = cut.mesh();
  std::vector<int> component(mesh.n_faces(), -1);
  std::vector<int> stack;
  count = 0;
  for (std::size_t seed = 0; seed < component.size(); ++seed) {
    if (component[seed] >= 0) continue;
    component[seed] = count;
    stack.push_back(static_cast<int>(seed));
    while (!stack.empty()) {
      const FaceHandle face(stack.back());
      stack.pop_back();
      HalfedgeHandle h = mesh.halfedge_handle(face);
      for (int i = 0; i < 3; ++i, h = mesh.next_halfedge_handle(h)) {
        if (cut.slide_of(mesh.edge_handle(h)) >= 0) continue;
        const auto neighbour = static_cast<std::size_t>(mesh.face_handle(mesh.opposite_halfedge_handle(h)).idx());
        if (component[neighbour] >= 0) continue;
        component[neighbour] = count;
        stack.push_back(static_cast<int>(neighbour));
      }
    }
    ++count;
  }
  return component;
}

// Parts in an order that depends on geometry and slides only: by the first slide (behind before ahead) that bounds
// them; those without a slide come last, by the lowest corner of their vertices.
std::vector<int> canonical_order(const IndexedMesh& cut, const std::vector<int>& component, int count,
                                 const std::vector<std::array<int, 2>>& slide_components) {
  using Key = std::tuple<std::size_t, double, double, double>;
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Key> keys(static_cast<std::size_t>(count),
                        Key{std::numeric_limits<std::size_t>::max(), infinity, infinity, infinity});
  for (std::size_t k = slide_components.size(); k-- > 0;)
    for (std::size_t side : {std::size_t{1}, std::size_t{0}})
      std::get<0>(keys[static_cast<std::size_t>(slide_components[k][side])]) = 2 * k + side;
  for (std::size_t f = 0; f < component.size(); ++f) {
    Key& key = keys[static_cast<std::size_t>(component[f])];
    if (std::get<0>(key) != std::numeric_limits<std::size_t>::max()) continue;
    for (int i = 0; i < 3; ++i) {
      const auto p = cut.points.row(cut.triangles(static_cast<Eigen::Index>(f), i));
      key = std::min(key, Key{std::get<0>(key), p.x(), p.y(), p.z()});
    }
  }
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)]; });
  std::vector<int> rank(keys.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return rank;
}

// Of each part, ascending. Most vertices are of one part only; those of loops are of more.
void collect_vertices(const IndexedMesh& cut, const std::vector<int>& triangle_part, std::vector<Part>& parts) {
  std::vector<int> first_part(static_cast<std::size_t>(cut.points.rows()), -1);
  std::vector<std::pair<int, int>> others;  // vertex and part
  for (std::size_t f = 0; f < triangle_part.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int v = cut.triangles(static_cast<Eigen::Index>(f), i);
      int& first = first_part[static_cast<std::size_t>(v)];
      if (first < 0) first = triangle_part[f];
      if (first != triangle_part[f]) others.emplace_back(v, triangle_part[f]);
    }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  auto other = others.begin();
  for (std::size_t v = 0; v < first_part.size(); ++v) {
    const int row = static_cast<int>(v);
    if (first_part[v] >= 0) parts[static_cast<std::size_t>(first_part[v])].vertices.push_back(row);
    for (; other != others.end() && other->first == row; ++other)
      parts[static_cast<std::size_t>(other->second)].vertices.push_back(row);
  }
}

void check_two_sides(const Segmentation& result, const std::vector<bool>& hollow,
                     const std::vector<std::string>& names) {
  for (std::size_t k = 0; k < result.slide_parts.size(); ++k) {
    if (result.slide_parts[k][0] != result.slide_parts[k][1]) continue;
    ErrorPlace place;
    place.slide = k;
    place.part = static_cast<std::size_t>(result.slide_parts[k][0]);
    place.point = result.ellipses[k].center;
    throw Error(
        ErrorCode::part_sees_slide_twice,
        "slide '" + names[k] + "' has the same part on both sides: " +
            (hollow[k] ? "the model is a pipe there, and its inside wall joins the two; close the pipe's ends, "
                         "or remove the slide"
                       : "the model is a ring there that is cut only once; add two more slides round it, for a ring "
                         "needs three"),
        place);
  }
}

// A slide in a flat end cuts off a part without height, which nothing can be meshed round.
void check_heights(const Segmentation& result, double diagonal, const std::vector<std::string>& names) {
  for (const Part& part : result.parts) {
    if (part.sections.size() != 1) continue;
    const auto k = static_cast<std::size_t>(part.sections.front().slide);
    const Ellipse& slide = result.ellipses[k];
    const bool flat = std::all_of(part.vertices.begin(), part.vertices.end(), [&](int v) {
      return std::abs(slide.normal.dot(Vector3(result.cut.points.row(v)) - slide.center)) <=
             tolerance::on_plane * diagonal;
    });
    if (!flat) continue;
    ErrorPlace place;
    place.slide = k;
    place.point = slide.center;
    throw Error(ErrorCode::slide_misses_model,
                "slide '" + names[k] + "' only touches the model, at " + to_text(slide.center) +
                    ": move it into the limb to cut",
                place);
  }
}

// Of each slide the half-edges of its loop, the triangles ahead of the slide on their left.
using LoopWalls = std::vector<std::vector<HalfedgeHandle>>;

LoopWalls cut_along_slides(const Model& model, CutMesh& cut, const std::vector<Slide>& slides,
                           const std::vector<std::string>& names, Segmentation& result, std::vector<bool>& hollow,
                           const Progress& progress) {
  LoopWalls walls;
  std::optional<Error> failed;
  for (std::size_t k = 0; k < slides.size(); ++k) {
    if (progress && !progress(static_cast<double>(k) / static_cast<double>(slides.size())))
      throw Error(ErrorCode::cancelled, "cancelled while the model was cut");
    try {
      SlideOnModel placed = place_slide(cut.mesh(), cut.edge_blocks(), with_plane(model.mesh, slides[k], k), k);
      walls.push_back(cut.cut(placed.loop, static_cast<int>(k), names));
      result.ellipses.push_back(placed.ellipse);
      hollow.push_back(placed.hollow);
      result.loops.push_back(std::move(placed.loop.points));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal && !failed) throw;
      failed ? failed->add_other(error) : static_cast<void>(failed = error);
    }
  }
  if (failed) throw *failed;
  return walls;
}

}  // namespace

Segmentation segment(const Model& model, const std::vector<Slide>& slides, const Progress& progress) {
  std::vector<std::string> names;
  for (const Slide& slide : slides) names.push_back(slide.name);
  Segmentation result;
  CutMesh cut(model);
  std::vector<bool> hollow;
  const LoopWalls walls = cut_along_slides(model, cut, slides, names, result, hollow, progress);
  const HalfEdgeMesh& mesh = cut.mesh();
  result.cut = to_indexed_mesh(mesh);

  int count = 1;  // without any slide the whole model is one part, whatever it consists of
  const std::vector<int> component = slides.empty() ? std::vector<int>(mesh.n_faces(), 0) : flood(cut, count);
  const auto component_of = [&](HalfedgeHandle h) {
    return component[static_cast<std::size_t>(mesh.face_handle(h).idx())];
  };
  for (const auto& wall : walls)
    result.slide_parts.push_back(
        {component_of(mesh.opposite_halfedge_handle(wall.front())), component_of(wall.front())});

  const std::vector<int> rank = canonical_order(result.cut, component, count, result.slide_parts);
  result.triangle_part.resize(component.size());
  for (std::size_t f = 0; f < component.size(); ++f)
    result.triangle_part[f] = rank[static_cast<std::size_t>(component[f])];
  result.parts.resize(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < result.slide_parts.size(); ++k)
    for (std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      int& part = result.slide_parts[k][side];
      part = rank[static_cast<std::size_t>(part)];
    }
  check_two_sides(result, hollow, names);
  for (std::size_t k = 0; k < result.slide_parts.size(); ++k)
    for (std::size_t side : {std::size_t{0}, std::size_t{1}})
      result.parts[static_cast<std::size_t>(result.slide_parts[k][side])].sections.push_back(
          {static_cast<int>(k), side == 0});
  collect_vertices(result.cut, result.triangle_part, result.parts);
  check_heights(result, model.diagonal, names);
  mark_enclosed(result);
  return result;
}

}  // namespace cagewright
