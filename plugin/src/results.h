// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "plugin/src/session.h"

// The readers of the C ABI's results. All throw AbiError: INVALID_ARGUMENT (NULL, struct_size, index past the end),
// NOT_READY; those with buffers BUFFER_TOO_SMALL, after the counts were set and before any array is written.
namespace cagewright::plugin {

void read_parts(const cgw_session& session, cgw_parts* out);
void read_section(const cgw_session& session, std::uint64_t index, cgw_section* out);
void read_loop(const cgw_session& session, std::uint64_t index, cgw_loop* out);
void read_cage(const cgw_session& session, cgw_cage* out);
void read_iteration(const cgw_session& session, std::uint64_t index, cgw_iteration* out);
void read_summary(const cgw_session& session, cgw_summary* out);

std::uint64_t section_count(const cgw_session& session) noexcept;
std::uint64_t iteration_count(const cgw_session& session) noexcept;

}  // namespace cagewright::plugin
