// SPDX-License-Identifier: BSD-3-Clause
// Every face has two sides; sides that look into one space are joined round the edges. What is outside of a piece of
// surface is told by where a line enters it first, and pieces inside of others by where the line leaves them.
#include "core/enclose/outer_sides.h"

#include <algorithm>
#include <optional>

#include "core/enclose/disjoint_sets.h"
#include "core/enclose/edge_fans.h"
#include "core/error/error.h"

namespace cagewright {
namespace {

using Face = Arrangement::Face;

// Where a line along an axis passes a face, by its height along the axis: over / under, under > 0.
struct Crossing {
  ExactInteger over, under;
  int side = 0;   // of the face: the one that looks up the axis
  int other = 0;  // the one that looks down
  int piece = 0;
};

bool is_higher(const Crossing& a, const Crossing& b) { return a.over * b.under > b.over * a.under; }

class Sides {
 public:
  Sides(const IndexedMesh& mesh, const Arrangement& arrangement)
      : arrangement_(arrangement),
        fans_(find_edge_fans(mesh, arrangement)),
        spaces_(2 * arrangement.faces.size()),
        cells_(arrangement.faces.size()),
        pieces_(arrangement.corners.size()) {
    for (std::size_t f = 0; f < arrangement.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        if (const int g = arrangement.faces[f].neighbours[i]; g >= 0 && !arrangement.faces[f].is_constrained[i]) {
          const int here = static_cast<int>(f);
          spaces_.join(2 * here, 2 * g);
          spaces_.join(2 * here + 1, 2 * g + 1);
          cells_.join(here, g);
        }
    for (const auto& fan : fans_) join_round(fan);
  }

  OuterSides run() {
    find_outsides();
    OuterSides result;
    result.faces.assign(arrangement_.faces.size(), OuterSides::Kept::no);
    for (std::size_t f = 0; f < arrangement_.faces.size(); ++f) result.faces[f] = kept(static_cast<int>(f));
    keep_one_of_each(result);
    result.partners.assign(3 * arrangement_.faces.size(), -1);
    for (std::size_t f = 0; f < arrangement_.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Face& face = arrangement_.faces[f];
        if (!face.is_constrained[i])
          result.partners[3 * f + i] = edge_from(face.neighbours[i], face.points[(i + 1) % 3]);
      }
    for (const auto& fan : fans_) pair_round(fan, result);
    return result;
  }

 private:
  static int ahead(const FanFace& f) {
    return 2 * f.face + (f.is_left ? 0 : 1);
  }  // the side that looks on round the edge
  static int behind(const FanFace& f) { return 2 * f.face + (f.is_left ? 1 : 0); }
  int piece_of(int face) { return pieces_.of(arrangement_.faces[static_cast<std::size_t>(face)].source); }

  int edge_from(int face, int point) const {
    const auto& points = arrangement_.faces[static_cast<std::size_t>(face)].points;
    return 3 * face + static_cast<int>(std::find(points.begin(), points.end(), point) - points.begin());
  }

  void join_round(const std::vector<FanFace>& fan) {
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const FanFace &here = fan[k], &next = fan[(k + 1) % fan.size()];
      pieces_.join(arrangement_.faces[static_cast<std::size_t>(here.face)].source,
                   arrangement_.faces[static_cast<std::size_t>(next.face)].source);
      if (here.angle == next.angle && k + 1 < fan.size()) {
        spaces_.join(ahead(here), ahead(next));
        spaces_.join(behind(here), behind(next));
        cells_.join(here.face, next.face);
      } else {
        spaces_.join(ahead(here), behind(next));
      }
    }
  }

  // All crossings of a line along `axis` through the faces, rising. Nothing where it meets an edge.
  std::optional<std::vector<Crossing>> cross(const Homogeneous& at, int axis) {
    const Projection plane{(axis + 1) % 3, (axis + 2) % 3};
    std::vector<Crossing> found;
    for (std::size_t s = 0; s < arrangement_.corners.size(); ++s) {
      const auto& corners = arrangement_.corners[s];
      if (corners[0] == corners[1]) continue;
      const std::optional<bool> passes = is_inside(corners, at, plane);
      if (!passes) return {};
      if (!*passes) continue;
      bool any = false;
      for (int f = arrangement_.first_face[s]; f < arrangement_.first_face[s + 1] && !any; ++f) {
        const auto inside = is_inside(arrangement_.faces[static_cast<std::size_t>(f)].points, at, plane);
        if (!inside) return {};
        any = *inside;
        if (any) found.push_back(crossing(f, at, axis));
      }
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return is_higher(b, a); });
    return found;
  }

  // Nothing for a point on the border.
  std::optional<bool> is_inside(const std::array<int, 3>& t, const Homogeneous& at, Projection plane) const {
    bool left = false, right = false, on = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const int side = arrangement_.points.orientation(t[i], t[(i + 1) % 3], at, plane);
      left = left || side > 0;
      right = right || side < 0;
      on = on || side == 0;
    }
    if (left && right) return false;
    if (on) return {};
    return true;
  }

  Crossing crossing(int f, const Homogeneous& at, int axis) {
    const auto& c =
        arrangement_.corners[static_cast<std::size_t>(arrangement_.faces[static_cast<std::size_t>(f)].source)];
    const Homogeneous &a = arrangement_.points.exact(c[0]), &b = arrangement_.points.exact(c[1]);
    const Homogeneous& d = arrangement_.points.exact(c[2]);
    std::array<ExactInteger, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = (b[j] - a[j]) * (d[k] - a[k]) - (b[k] - a[k]) * (d[j] - a[j]);
    }
    const auto i = static_cast<std::size_t>(axis), j = (i + 1) % 3, k = (i + 2) % 3;
    Crossing crossing;
    crossing.over = (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) * at[3] - n[j] * at[j] - n[k] * at[k];
    crossing.under = n[i] * at[3];
    const bool is_up = crossing.under > 0;
    if (!is_up) {
      crossing.over = -crossing.over;
      crossing.under = -crossing.under;
    }
    crossing.side = spaces_.of(2 * f + (is_up ? 0 : 1));
    crossing.other = spaces_.of(2 * f + (is_up ? 1 : 0));
    crossing.piece = piece_of(f);
    return crossing;
  }

  // A line through a triangle of the piece that meets no edge of any and no two pieces in one place.
  std::vector<Crossing> line_through(int piece) {
    constexpr int tries = 40;
    for (int attempt = 0; attempt < tries; ++attempt)
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t s = 0; s < arrangement_.corners.size(); ++s) {
          const auto& corners = arrangement_.corners[s];
          if (corners[0] == corners[1] || pieces_.of(static_cast<int>(s)) != piece) continue;
          const Homogeneous at = arrangement_.points.mean(
              corners, {101 + 17 * (attempt % 7), 97 + 13 * (attempt % 5), 103 + 29 * (attempt % 3)});
          const auto found = cross(at, axis);
          if (!found || found->empty()) continue;
          bool is_sound =
              std::any_of(found->begin(), found->end(), [&](const Crossing& c) { return c.piece == piece; });
          for (std::size_t k = 0; k + 1 < found->size(); ++k)
            is_sound =
                is_sound && ((*found)[k].piece == (*found)[k + 1].piece || is_higher((*found)[k + 1], (*found)[k]));
          if (is_sound) return *found;
        }
    throw Error(ErrorCode::internal, "hull: no line passes all edges");
  }

  void find_outsides() {
    std::vector<int> all;
    for (int s = 0; s < static_cast<int>(arrangement_.corners.size()); ++s)
      if (pieces_.of(s) == s &&
          arrangement_.corners[static_cast<std::size_t>(s)][0] != arrangement_.corners[static_cast<std::size_t>(s)][1])
        all.push_back(s);
    outside_.assign(arrangement_.corners.size(), -1);
    is_inside_.assign(arrangement_.corners.size(), 0);
    std::vector<std::vector<Crossing>> lines;
    std::vector<std::size_t> tops;
    for (const int piece : all) {
      lines.push_back(line_through(piece));
      std::size_t top = lines.back().size() - 1;
      while (lines.back()[top].piece != piece) --top;
      tops.push_back(top);
      outside_[static_cast<std::size_t>(piece)] = lines.back()[top].side;
    }
    // Above its top a piece is inside of another where the next crossing of that one is from within.
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::vector<char> seen(arrangement_.corners.size(), 0);
      for (std::size_t i = tops[k] + 1; i < lines[k].size(); ++i) {
        const Crossing& crossing = lines[k][i];
        const auto piece = static_cast<std::size_t>(crossing.piece);
        if (seen[piece]) continue;
        seen[piece] = 1;
        if (crossing.other != outside_[piece]) is_inside_[static_cast<std::size_t>(all[k])] = 1;
      }
    }
  }

  OuterSides::Kept kept(int f) {
    const auto piece = static_cast<std::size_t>(piece_of(f));
    if (is_inside_[piece]) return OuterSides::Kept::no;
    const bool up = spaces_.of(2 * f) == outside_[piece], down = spaces_.of(2 * f + 1) == outside_[piece];
    if (up == down) return OuterSides::Kept::no;
    return up ? OuterSides::Kept::as_it_is : OuterSides::Kept::turned;
  }

  // Of sources that overlap in a cell: one that is as it is before one that is turned, then the first.
  void keep_one_of_each(OuterSides& result) {
    std::vector<std::pair<int, int>> best(arrangement_.faces.size(), {2, 0});
    const auto rank = [&](std::size_t f) -> std::pair<int, int> {
      return {result.faces[f] == OuterSides::Kept::turned ? 1 : 0, arrangement_.faces[f].source};
    };
    for (std::size_t f = 0; f < result.faces.size(); ++f) {
      if (result.faces[f] == OuterSides::Kept::no) continue;
      auto& of_cell = best[static_cast<std::size_t>(cells_.of(static_cast<int>(f)))];
      of_cell = std::min(of_cell, rank(f));
    }
    for (std::size_t f = 0; f < result.faces.size(); ++f)
      if (result.faces[f] != OuterSides::Kept::no &&
          rank(f) != best[static_cast<std::size_t>(cells_.of(static_cast<int>(f)))])
        result.faces[f] = OuterSides::Kept::no;
  }

  void pair_round(const std::vector<FanFace>& fan, OuterSides& result) {
    std::vector<FanFace> round;
    for (const FanFace& f : fan)
      if (result.faces[static_cast<std::size_t>(f.face)] != OuterSides::Kept::no) round.push_back(f);
    for (std::size_t k = 0; k < round.size(); ++k) {
      const FanFace &here = round[k], &next = round[(k + 1) % round.size()];
      const bool looks_out = spaces_.of(ahead(here)) == outside_[static_cast<std::size_t>(piece_of(here.face))];
      if (looks_out) continue;
      result.partners[static_cast<std::size_t>(3 * here.face + here.edge)] = 3 * next.face + next.edge;
      result.partners[static_cast<std::size_t>(3 * next.face + next.edge)] = 3 * here.face + here.edge;
    }
  }

  const Arrangement& arrangement_;
  std::vector<std::vector<FanFace>> fans_;
  DisjointSets spaces_;          // of sides: 2 f looks along the normal of face f, 2 f + 1 against it
  DisjointSets cells_;           // of faces: those that no edge parts, and those that lie on them
  DisjointSets pieces_;          // of sources: surface that hangs together by edges
  std::vector<int> outside_;     // of each piece, by its first source: the space round it
  std::vector<char> is_inside_;  // of another piece
};

}  // namespace

OuterSides find_outer_sides(const IndexedMesh& mesh, const Arrangement& arrangement) {
  return Sides(mesh, arrangement).run();
}

}  // namespace cagewright
