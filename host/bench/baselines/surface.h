// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <filesystem>

namespace cagewright::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

// The triangles of an .obj, .off or .ply file. Throws std::runtime_error, naming the file, where it is not a surface
// mesh.
Surface read_surface(const std::filesystem::path& file);

// The coordinates are rounded to floats first, as a mesh file of another program would hold them, and so that what is
// judged is what is written. Throws std::runtime_error where the file cannot be written.
void write_surface(const std::filesystem::path& file, const Surface& surface);

// In place, to the nearest float.
void round_to_floats(Surface& surface);

// Of the axis-parallel bounding box.
double diagonal_of(const Surface& surface);

std::size_t triangle_count(const Surface& surface);

}  // namespace cagewright::bench
