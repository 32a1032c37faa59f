// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace fretwork::studio {

/// Where the page of this program lies: ../share/fretwork/studio.html, seen from the program. It may not be
/// there.
std::filesystem::path usual_page_path();

}  // namespace fretwork::studio
