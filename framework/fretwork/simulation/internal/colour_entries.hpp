// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <map>
#include <span>
#include <string>
#include <utility>

namespace fretwork::simulation {

/// Refuse a palette with two entries for one colour. `entries` are colours as "#rrggbb", each with its entry
/// or its pattern; the message quotes both and names `source`.
inline void refuse_repeated_colours(std::span<const std::pair<std::string, std::string>> entries,
                                    const std::string& source) {
    std::map<std::string, std::string> known;
    for (const auto& [colour, entry] : entries) {
        const auto [first, is_new] = known.emplace(colour, entry);
        if (!is_new)
            throw base::InputError(source, "",
                                   "'" + first->second + "' and '" + entry + "' are for one colour, " +
                                       colour + ": keep one of them");
    }
}

}  // namespace fretwork::simulation
