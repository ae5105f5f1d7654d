// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_COLOURS_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_COLOURS_H

#include "host/file/slides_file.h"

namespace cagewright::host {

// Red, green, blue from 0 to 1; for dark backgrounds, and told apart on light ones.
namespace colours {

constexpr Point3 model{0.66, 0.66, 0.68};
constexpr Point3 other_model{0.31, 0.31, 0.33};
constexpr Point3 other_model_on_light{0.72, 0.72, 0.74};
constexpr Point3 outside{0.95, 0.08, 0.08};

constexpr Point3 slide{0.93, 0.10, 0.10};
constexpr Point3 selected_slide{1.00, 0.80, 0.10};
constexpr Point3 preview_slide{1.00, 0.50, 0.48};
constexpr Point3 failed_slide{1.00, 0.36, 0.05};
constexpr Point3 stroke{1.00, 0.88, 0.45};

constexpr Point3 section{0.15, 0.85, 0.30};
constexpr Point3 cage_edge{0.35, 0.66, 1.00};
constexpr Point3 cage_face{0.35, 0.60, 1.00};
constexpr Point3 stale_edge{0.52, 0.58, 0.65};
constexpr Point3 stale_section{0.45, 0.60, 0.48};

}  // namespace colours

// Of a model's part: parts next to one another in number differ most. Negative: none, grey.
Point3 colour_of_part(int part);

}  // namespace cagewright::host

#endif
