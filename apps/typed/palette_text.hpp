// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::typed {

/// Where the patterns of a palette come from, as people write it: ids with commas between; "library" for all
/// patterns of the library; "all" for all valid ones of the layout; "sample:N" for N of these, drawn at
/// random.
struct PaletteText {
    std::string text;
    std::uint64_t seed = 1;
    base::Control control{};
};

/// Read a palette. The result depends on the arguments alone. `library` may be null. Throws InputError that
/// names --palette, or the library if it has another layout; Stopped.
std::vector<pattern::NamedPattern> read_palette(const PaletteText& palette, const pattern::NodeLayout& layout,
                                                const library::Library* library);

}  // namespace fretwork::typed
