// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/utf8.h"

#include <nlohmann/json.hpp>

namespace cagewright::host {

bool is_utf8(const std::string& text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());  // strict, as saving is
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace cagewright::host
