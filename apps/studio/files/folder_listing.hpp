// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/internal/json_text.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::studio {

/// What lies in a folder of this machine, for a page that chooses a file: `path`, `parent` (null at the top),
/// `home` (null if unknown), `folders` and `files` by name, and `left_out`, the number of entries beyond the
/// first 2,000. Hidden entries are left out, and files with other endings.
///
/// @param endings  such as ".json"; none: all files
/// Throws InputError if there is no such folder, or if it cannot be read.
base::Json folder_listing(const std::filesystem::path& folder, const std::vector<std::string>& endings,
                          const base::Control& control);

}  // namespace fretwork::studio
