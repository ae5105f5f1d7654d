// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_CERTIFICATE_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_CERTIFICATE_H

#include <cagewright/cagewright.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cagewright::host {

// cgw_finding: one sentence of a certificate's message.
struct Finding {
  std::string sentence;
  std::vector<std::uint64_t> slides;           // ids of the session's
  std::optional<std::array<double, 3>> place;  // of the model
  bool is_advice = false;                      // nothing that was asked for is missing
};

// cgw_certificate with lists: rows of the meshes that the plug-in was given.
struct Certificate {
  bool encloses = false, closed = false, keeps_distance = false;
  std::vector<std::uint32_t> degenerate_triangles;               // of the cage
  std::vector<std::array<std::uint32_t, 2>> self_intersections;  // of cage triangles
  std::vector<std::array<std::uint32_t, 2>> model_cage_intersections;
  std::vector<std::uint32_t> vertices_outside;  // of the model
  std::string message;                          // "" or which slides are at fault, and what to do
  std::vector<Finding> findings;                // its sentences; none of a plug-in older than ABI 1.5
};

// cgw_measures without its lists; what the plug-in did not write is NaN.
using Measures = cgw_measures;

// `call` fills a struct of the plug-in and throws where that fails. It is called twice: for the counts, for the lists.
Certificate read_certificate(const std::function<void(cgw_certificate*)>& call);
Finding read_finding(const std::function<void(cgw_finding*)>& call);
Measures read_measures(const std::function<void(cgw_measures*)>& call);

}  // namespace cagewright::host

#endif
