// SPDX-License-Identifier: GPL-3.0-or-later
// What a fuzzer may not ask a studio for: it would do what it is told.
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <filesystem>

namespace fretwork::fuzz {

/// Whether a message names a file outside of the folder, to be read or written: in `path`, or instead of the
/// name of a shipped layout in `from` and `layout`.
bool leaves(const base::Json& message, const std::filesystem::path& folder);

}  // namespace fretwork::fuzz
