// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

namespace fretwork::library::detail {

/// Record who writes: the program's provenance, the host and the time, as a new session.
void record_session(const Database& database);

}  // namespace fretwork::library::detail
