// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::typed {

/// The source of a palette's patterns, as a person writes it: ids joined by commas; "library" for all
/// patterns of the library; "all" for all valid patterns of the layout; "sample:N" for N different valid
/// patterns of the layout, drawn at random, or fewer if a limited number of draws finds no more.
struct PaletteText {
    std::string text;
    std::uint64_t seed = 1;
    base::Control control{};
};

/// Read a palette. The result depends on the arguments alone. `library` may be null. Throws InputError that
/// names --palette, or names the library if the library has another layout. Throws Stopped.
std::vector<pattern::NamedPattern> read_palette(const PaletteText& palette, const pattern::NodeLayout& layout,
                                                const library::Library* library);

}  // namespace fretwork::typed
