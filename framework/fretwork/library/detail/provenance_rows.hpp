// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

namespace fretwork::library::detail {

/// Record this writer: the program's provenance, the host and the time, under the next session number.
void record_writer(const Database& database);

}  // namespace fretwork::library::detail
