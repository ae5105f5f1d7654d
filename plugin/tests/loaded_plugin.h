// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cagewright/cagewright.h"

// The plug-in as a host sees it: the tests link nothing of it.
namespace cagewright::plugin::test {

// The table of the plug-in, loaded at the first call and kept.
const cgw_api& api();

struct Mesh {
  std::vector<double> vertices;
  std::vector<std::uint32_t> triangles;
  cgw_mesh view() const;  // lives as long as the mesh
};

// Radius 1 along x, from -1 to 7; closed, outward.
Mesh capsule();
// Round z: the middle circle has radius 3, the tube 1; closed, outward.
Mesh torus();
Mesh tetrahedron();
Mesh turned_inside_out(Mesh mesh);

// A session that ends with its scope.
class Session {
 public:
  explicit Session(const cgw_host* host = nullptr);
  Session(const cgw_host* host, const Mesh& mesh);
  explicit Session(const Mesh& mesh) : Session(nullptr, mesh) {}
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  operator cgw_session*() const { return handle_; }
  std::string error() const;
  cgw_error_info error_info() const;

 private:
  cgw_session* handle_ = nullptr;
};

cgw_slide_input plane(const char* name, double x, double nx = 1, double ny = 0, double nz = 0);
cgw_slide_input ellipse(const char* name, double x, double radius);
cgw_slide_input point_alone(const char* name, double x);  // on the capsule's side, which faces along y
std::vector<double> stroke_points(double x, int count);   // on a circle of radius 1 round x
cgw_slide_input stroke(const char* name, const std::vector<double>& points);  // borrows them
std::uint64_t add(const Session& session, const cgw_slide_input& input);
cgw_slide_info info(const Session& session, std::uint64_t index);

// "left" at x = 1, "middle" at 3 and "right" at 5, solved.
struct SolvedCapsule {
  explicit SolvedCapsule(const cgw_host* host = nullptr);
  Session session;
  std::uint64_t left, middle, right;
};

struct Cage {
  std::vector<double> vertices;
  std::vector<std::uint32_t> triangles;
  bool operator==(const Cage&) const = default;
};
Cage cage_of(const Session& session);

}  // namespace cagewright::plugin::test
