// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_GLB_SAMPLE_H
#define CAGEWRIGHT_HOST_TESTS_GLB_SAMPLE_H

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cagewright::host {

// A .glb that is put together piece by piece; `json` may be changed at will before bytes().
class GlbSample {
 public:
  GlbSample();

  // Appends the numbers to the binary chunk as a buffer view of their own; returns its index.
  template <class Number>
  int view(const std::vector<Number>& numbers, int stride = 0);
  // Appends an accessor on a view; returns its index.
  int accessor(int view, int component_type, int count, const std::string& type);
  // Appends a mesh of one primitive; returns its index. indices -1: none.
  int mesh(int positions, int indices, int mode = 4);
  // Appends a node that shows a mesh and is a root of the scene.
  int node(int mesh);
  // Positions, indices, mesh and node of one triangle (0,0,0) (1,0,0) (0,1,0).
  void one_triangle();

  std::string bytes() const;

  nlohmann::json json;

 private:
  std::string binary_;
};

constexpr int gl_byte = 5120, gl_ubyte = 5121, gl_short = 5122, gl_ushort = 5123, gl_uint = 5125, gl_float = 5126;

}  // namespace cagewright::host

#endif
