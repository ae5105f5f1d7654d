// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/certificate.h"

#include <limits>

namespace cagewright::host {

Certificate read_certificate(const std::function<void(cgw_certificate*)>& call) {
  cgw_certificate c = CGW_CERTIFICATE_INIT;
  call(&c);
  Certificate result;
  result.degenerate_triangles.resize(c.degenerate_count);
  result.self_intersections.resize(c.self_intersection_count);
  result.model_cage_intersections.resize(c.model_intersection_count);
  result.vertices_outside.resize(c.outside_count);
  const auto rows = [](auto& list) { return list.empty() ? nullptr : reinterpret_cast<std::uint32_t*>(list.data()); };
  c.degenerate_triangles = rows(result.degenerate_triangles);
  c.degenerate_capacity = c.degenerate_count;
  c.self_intersections = rows(result.self_intersections);
  c.self_intersection_capacity = c.self_intersection_count;
  c.model_intersections = rows(result.model_cage_intersections);
  c.model_intersection_capacity = c.model_intersection_count;
  c.outside_vertices = rows(result.vertices_outside);
  c.outside_capacity = c.outside_count;
  call(&c);
  result.encloses = c.encloses == 1;
  result.closed = c.closed == 1;
  result.keeps_distance = c.keeps_distance == 1;
  if (c.message != nullptr) result.message = c.message;
  return result;
}

Finding read_finding(const std::function<void(cgw_finding*)>& call) {
  cgw_finding f = CGW_FINDING_INIT;
  call(&f);
  Finding finding;
  finding.slides.resize(f.slide_count);
  f.slides = finding.slides.empty() ? nullptr : finding.slides.data();
  f.slide_capacity = f.slide_count;
  call(&f);
  if (f.message != nullptr) finding.sentence = f.message;
  if (f.has_point == 1) finding.place = std::to_array(f.point);
  finding.is_advice = f.is_advice == 1;
  return finding;
}

Measures read_measures(const std::function<void(cgw_measures*)>& call) {
  Measures measures = CGW_MEASURES_INIT;
  for (double* figure = &measures.volume_ratio; figure <= &measures.worst_twist; ++figure) {
    *figure = std::numeric_limits<double>::quiet_NaN();
  }
  call(&measures);
  return measures;
}

}  // namespace cagewright::host
