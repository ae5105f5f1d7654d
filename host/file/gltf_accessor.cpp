// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_accessor.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/file/byte_order.h"

namespace cagewright::host {
namespace {

// Rows of bytes in a buffer, checked to lie in it.
struct Rows {
  const char* first = nullptr;
  std::size_t stride = 0;
};

class AccessorReader {
 public:
  AccessorReader(const tinygltf::Model& model, int accessor)
      : model_(model), name_("accessor " + std::to_string(accessor)), accessor_(find(accessor)) {}

  const tinygltf::Accessor& accessor() const { return accessor_; }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(name_ + " " + reason + "; export it again");
  }

  // count x components, sparse values in place; of those that are not sparse only the first `most` rows.
  std::vector<double> read(std::size_t most = std::numeric_limits<std::size_t>::max()) const {
    const std::size_t width = components();
    std::vector<double> values;
    if (accessor_.bufferView >= 0) {
      const Rows rows = rows_of(accessor_.bufferView, accessor_.byteOffset, accessor_.count, width * component_size());
      const std::size_t count = accessor_.sparse.isSparse ? accessor_.count : std::min(accessor_.count, most);
      values.resize(count * width);
      for (std::size_t i = 0; i < count; ++i) copy_row(rows.first + i * rows.stride, &values[i * width]);
    } else {
      if (!accessor_.sparse.isSparse) fail("has no buffer view; it may need an extension that cannot be read");
      if (accessor_.count > most_zeros) fail("promises too many values");
      values.assign(accessor_.count * width, 0.0);
    }
    if (accessor_.sparse.isSparse) apply_sparse(values);
    return values;
  }

 private:
  // A sparse accessor without a buffer view costs no bytes in the file, so its count is no sign of its truth.
  static constexpr std::size_t most_zeros = std::size_t{1} << 24;

  const tinygltf::Accessor& find(int index) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) fail("is not there");
    return model_.accessors[static_cast<std::size_t>(index)];
  }

  std::size_t components() const {
    return accessor_.type == TINYGLTF_TYPE_MAT4 ? 16 : accessor_.type == TINYGLTF_TYPE_VEC3 ? 3 : 1;
  }

  std::size_t component_size() const { return component_size(accessor_.componentType); }

  std::size_t component_size(int type) const {
    switch (type) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
      case TINYGLTF_COMPONENT_TYPE_SHORT:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
      default:
        fail("has the unknown component type " + std::to_string(type));
    }
  }

  Rows rows_of(int view_index, std::size_t offset, std::size_t count, std::size_t row_bytes) const {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size()) {
      fail("names buffer view " + std::to_string(view_index) + ", which is not there");
    }
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) {
      fail("lies in buffer " + std::to_string(view.buffer) + ", which is not there");
    }
    const std::vector<unsigned char>& bytes = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const std::size_t stride = view.byteStride == 0 ? row_bytes : view.byteStride;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
      fail("lies in a buffer view that is longer than its buffer");
    }
    const bool fits =
        offset <= view.byteLength && (count == 0 || (row_bytes <= view.byteLength - offset &&
                                                     count - 1 <= (view.byteLength - offset - row_bytes) / stride));
    if (!fits) fail("does not fit in its buffer view");
    if (stride < row_bytes) fail("has rows that overlap");
    return {reinterpret_cast<const char*>(bytes.data()) + view.byteOffset + offset, stride};
  }

  void copy_row(const char* from, double* to) const {
    for (std::size_t k = 0; k < components(); ++k) to[k] = component(from + k * component_size());
  }

  template <class Integer>
  double integer(const char* from) const {
    const double value = load<Integer>(from, std::endian::little);
    // glTF 2.0, 3.6.2.2: -128 and -127 both mean -1.
    return accessor_.normalized ? std::max(value / std::numeric_limits<Integer>::max(), -1.0) : value;
  }

  double component(const char* from) const {
    switch (accessor_.componentType) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return integer<std::int8_t>(from);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return integer<std::uint8_t>(from);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return integer<std::int16_t>(from);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return integer<std::uint16_t>(from);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return integer<std::uint32_t>(from);
      default:
        return double{load<float>(from, std::endian::little)};
    }
  }

  std::size_t sparse_index(const char* from, int type) const {
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(from, std::endian::little);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(from, std::endian::little);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return load<std::uint32_t>(from, std::endian::little);
    fail("has sparse indices of the unknown component type " + std::to_string(type));
  }

  void apply_sparse(std::vector<double>& values) const {
    const auto& sparse = accessor_.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
      fail("has a negative sparse count or offset");
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    const std::size_t width = components();
    const int index_type = sparse.indices.componentType;
    const Rows indices = rows_of(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                                 component_size(index_type));
    const Rows rows = rows_of(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                              width * component_size());
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = sparse_index(indices.first + i * indices.stride, index_type);
      if (row >= accessor_.count) fail("has the sparse index " + std::to_string(row) + ", out of range");
      if (before && row <= *before) fail("has sparse indices that do not rise");
      before = row;
      copy_row(rows.first + i * rows.stride, &values[row * width]);
    }
  }

  const tinygltf::Model& model_;
  std::string name_;
  const tinygltf::Accessor& accessor_;
};

}  // namespace

std::vector<double> read_positions(const tinygltf::Model& model, int accessor) {
  const AccessorReader reader(model, accessor);
  if (reader.accessor().type != TINYGLTF_TYPE_VEC3) reader.fail("holds positions, but is not of type VEC3");
  return reader.read();
}

std::vector<double> read_first_matrix(const tinygltf::Model& model, int accessor) {
  const AccessorReader reader(model, accessor);
  const bool is_float = reader.accessor().componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (reader.accessor().type != TINYGLTF_TYPE_MAT4 || !is_float) {
    reader.fail("holds matrices, but is not a MAT4 of floats");
  }
  return reader.read(1);
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor) {
  const AccessorReader reader(model, accessor);
  const int type = reader.accessor().componentType;
  const bool is_unsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (reader.accessor().type != TINYGLTF_TYPE_SCALAR || !is_unsigned || reader.accessor().normalized) {
    reader.fail("holds indices, but is not a SCALAR of unsigned integers");
  }
  const std::vector<double> values = reader.read();
  return {values.begin(), values.end()};
}

}  // namespace cagewright::host
