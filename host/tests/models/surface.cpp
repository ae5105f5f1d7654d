// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/models/surface.h"

#include <Eigen/Geometry>
#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace cagewright::host {
namespace {

using DirectedEdge = std::pair<std::size_t, std::size_t>;

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

void require_known_vertices(const Surface& surface, const std::string& file) {
  for (const auto& triangle : surface.triangles) {
    for (const std::size_t vertex : triangle) {
      if (vertex >= surface.vertices.size()) throw std::runtime_error(file + " has a triangle of unknown vertices");
    }
  }
}

// The triangles round `vertex`, as links from the second corner to the third, are one circle.
bool is_one_fan(const std::map<std::size_t, std::size_t>& links, std::size_t triangles) {
  if (triangles == 0 || links.size() != triangles) return false;
  const std::size_t start = links.begin()->first;
  std::size_t at = start, steps = 0;
  do {
    const auto link = links.find(at);
    if (link == links.end() || ++steps > triangles) return false;
    at = link->second;
  } while (at != start);
  return steps == triangles;
}

}  // namespace

Surface obj_surface(const std::string& text) {
  Surface surface;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string kind, rest;
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3d& point = surface.vertices.emplace_back();
      words >> point.x() >> point.y() >> point.z();
    } else if (kind == "f") {
      auto& triangle = surface.triangles.emplace_back();
      for (std::size_t& corner : triangle) {
        words >> corner;
        --corner;  // 0 becomes an unknown vertex
      }
    } else {
      throw std::runtime_error("neither v nor f: " + line);
    }
    if (!words || words >> rest) throw std::runtime_error("not three numbers: " + line);
  }
  require_known_vertices(surface, "the cage");
  return surface;
}

Surface read_off(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream words;
  for (std::string line; std::getline(stream, line);) words << line.substr(0, line.find('#')) << '\n';
  std::string magic;
  std::size_t vertices = 0, triangles = 0, edges = 0, corners = 3;
  words >> magic >> vertices >> triangles >> edges;
  if (magic != "OFF" || !words) throw std::runtime_error(file.string() + " is not an OFF file");
  Surface surface;
  for (std::size_t i = 0; i < vertices && words; ++i) {
    Eigen::Vector3d& point = surface.vertices.emplace_back();
    words >> point.x() >> point.y() >> point.z();
  }
  for (std::size_t i = 0; i < triangles && words && corners == 3; ++i) {
    auto& triangle = surface.triangles.emplace_back();
    words >> corners >> triangle[0] >> triangle[1] >> triangle[2];
  }
  if (!words || corners != 3) throw std::runtime_error(file.string() + " is not of triangles alone, or ends early");
  require_known_vertices(surface, file.string());
  return surface;
}

std::string off_text(const Surface& surface) {
  std::string text =
      "OFF\n" + std::to_string(surface.vertices.size()) + " " + std::to_string(surface.triangles.size()) + " 0\n";
  for (const Eigen::Vector3d& point : surface.vertices) {
    for (const double x : point) {
      append(text, x);
      text += ' ';
    }
    text += '\n';
  }
  for (const auto& [a, b, c] : surface.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

Surface welded(const Surface& surface) {
  Surface result;
  std::map<std::array<double, 3>, std::size_t> places;
  std::vector<std::size_t> new_index;
  for (const Eigen::Vector3d& point : surface.vertices) {
    const auto [place, is_new] = places.try_emplace({point.x(), point.y(), point.z()}, result.vertices.size());
    if (is_new) result.vertices.push_back(point);
    new_index.push_back(place->second);
  }
  for (const auto& [a, b, c] : surface.triangles) {
    result.triangles.push_back({new_index[a], new_index[b], new_index[c]});
  }
  return result;
}

double diagonal(const Surface& surface) {
  Eigen::Vector3d low = surface.vertices.front(), high = low;
  for (const Eigen::Vector3d& point : surface.vertices) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}

SurfaceFacts facts_of(const Surface& surface) {
  std::map<DirectedEdge, std::size_t> edges;
  std::vector<std::map<std::size_t, std::size_t>> links(surface.vertices.size());
  std::vector<std::size_t> valence(surface.vertices.size(), 0);
  SurfaceFacts facts;
  for (const auto& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = triangle[k], next = triangle[(k + 1) % 3], last = triangle[(k + 2) % 3];
      ++edges[{vertex, next}];
      ++valence[vertex];
      links[vertex][next] = last;
    }
    // From a vertex, not from the origin, which may be far away.
    const Eigen::Vector3d origin = surface.vertices.front();
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d { return surface.vertices[triangle[k]] - origin; };
    facts.volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  std::size_t undirected = 0;
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    const bool has_opposite = opposite != edges.end();
    if (count != 1 || !has_opposite || opposite->second != 1) ++facts.unpaired_edges;
    if (!has_opposite || edge.first < edge.second) ++undirected;
  }
  for (std::size_t vertex = 0; vertex < links.size(); ++vertex) {
    if (!is_one_fan(links[vertex], valence[vertex])) ++facts.torn_vertices;
  }
  facts.euler = static_cast<std::ptrdiff_t>(surface.vertices.size() + surface.triangles.size()) -
                static_cast<std::ptrdiff_t>(undirected);
  return facts;
}

}  // namespace cagewright::host
