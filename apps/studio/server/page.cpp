// SPDX-License-Identifier: GPL-3.0-or-later
#include <studio/server/page.hpp>

namespace fretwork::studio {

std::filesystem::path usual_page_path() {
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return program.parent_path().parent_path() / "share" / "fretwork" / "studio.html";
}

}  // namespace fretwork::studio
