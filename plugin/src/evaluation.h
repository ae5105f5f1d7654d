// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cagewright/cagewright.h"
#include "core/enclose/certificate.h"
#include "core/enclose/finding.h"
#include "core/measure/measure_cage.h"
#include "core/measure/section_quality.h"

// Certificate and measures, of a session's cage and of any other.
namespace cagewright::plugin {

// By rows of the meshes that the host gave.
struct CageCertificate {
  Certificate found;
  bool keeps_distance = false;
  std::string message;
  std::vector<Finding> findings;  // its sentences; slides by their places among those of the solve
};

struct CageFigures {
  CageMeasures measures;
  std::optional<SectionQuality> sections;
  NeighbourPairs neighbours;  // of the sections
};

}  // namespace cagewright::plugin

// What any cage is to any model. Immutable.
struct cgw_evaluation {
  cagewright::plugin::CageCertificate certificate;
  cagewright::plugin::CageFigures figures;
};

namespace cagewright::plugin {

// Throws AbiError: MESH_*, with the mesh that is at fault; INVALID_ARGUMENT.
std::unique_ptr<cgw_evaluation> evaluate(const cgw_mesh* model, const cgw_mesh* cage, std::uint32_t threads);

// Of the session's cage; found once for each solve. Throw AbiError(NOT_READY) where there is none.
const CageCertificate& certificate_of(const cgw_session& session);
const CageFigures& figures_of(const cgw_session& session);

// Throw AbiError: BUFFER_TOO_SMALL, INVALID_ARGUMENT.
void read_certificate(const CageCertificate& certificate, cgw_certificate* out);
// `slide_ids`: of the slides of the solve.
void read_finding(const CageCertificate& certificate, const std::vector<std::uint64_t>& slide_ids, std::uint64_t index,
                  cgw_finding* out);
void read_measures(const CageFigures& figures, cgw_measures* out);

}  // namespace cagewright::plugin
