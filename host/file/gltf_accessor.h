// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_ACCESSOR_H
#define CAGEWRIGHT_HOST_FILE_GLTF_ACCESSOR_H

#include <cstdint>
#include <vector>

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// All decode what tinygltf leaves to its users: strides, integer and normalised components, and sparse accessors.
// `accessor` is an index of `model`. Throw std::runtime_error with a reason that names the accessor where it does not
// fit its buffers or is of another type.

// A VEC3 accessor, count x 3, as it is: not checked for NaN. O(count).
std::vector<double> read_positions(const tinygltf::Model& model, int accessor);
// The first of a MAT4 accessor of floats, column by column: 16 numbers, not checked for NaN, or none. O(1) where it is
// not sparse.
std::vector<double> read_first_matrix(const tinygltf::Model& model, int accessor);
// A SCALAR accessor of unsigned integers. O(count).
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

}  // namespace cagewright::host

#endif
