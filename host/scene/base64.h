// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_BASE64_H
#define CAGEWRIGHT_HOST_SCENE_BASE64_H

#include <string>
#include <string_view>

namespace cagewright::host {

// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

}  // namespace cagewright::host

#endif
