// SPDX-License-Identifier: BSD-3-Clause
#include "host/bench/baselines/surface.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <cmath>
#include <stdexcept>

namespace cagewright::bench {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;

double to_float(double value) { return static_cast<double>(static_cast<float>(value)); }

}  // namespace

Surface read_surface(const std::filesystem::path& file) {
  Surface surface;
  if (!processing::IO::read_polygon_mesh(file.string(), surface) || surface.is_empty()) {
    throw std::runtime_error(file.string() + ": is not a mesh of a surface that CGAL can read");
  }
  processing::triangulate_faces(surface);
  return surface;
}

void write_surface(const std::filesystem::path& file, const Surface& surface) {
  Surface rounded = surface;
  round_to_floats(rounded);
  if (!CGAL::IO::write_polygon_mesh(file.string(), rounded, CGAL::parameters::stream_precision(17))) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

void round_to_floats(Surface& surface) {
  for (const auto v : surface.vertices()) {
    const Kernel::Point_3& p = surface.point(v);
    surface.point(v) = Kernel::Point_3(to_float(p.x()), to_float(p.y()), to_float(p.z()));
  }
}

double diagonal_of(const Surface& surface) {
  const CGAL::Bbox_3 box = processing::bbox(surface);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

std::size_t triangle_count(const Surface& surface) { return surface.number_of_faces(); }

}  // namespace cagewright::bench
