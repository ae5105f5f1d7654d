// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/types.h"
#include "core/slide/slide.h"

// Models of our own and real ones, by name, and the slides that testdata has for them. CAGEWRIGHT_MODEL_FOLDERS (own,
// real) and CAGEWRIGHT_SLIDE_FILES come from CMake.
namespace cagewright {

// Empty where it is in none of the folders.
std::optional<IndexedMesh> find_model(const std::string& name);

// Throws what the JSON reader throws.
std::vector<Slide> read_slides(const std::string& name);

}  // namespace cagewright
