// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_POINT_VECTOR_H
#define CAGEWRIGHT_HOST_WORKSPACE_POINT_VECTOR_H

#include <Eigen/Core>

#include "host/file/slides_file.h"

namespace cagewright::host {

// Points of files and commands as vectors to calculate with, and back.
inline Eigen::Vector3d vector(const Point3& point) { return Eigen::Vector3d::Map(point.data()); }
inline Point3 point(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace cagewright::host

#endif
