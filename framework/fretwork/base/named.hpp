// SPDX-License-Identifier: GPL-3.0-or-later
// Tables whose rows have names.
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <functional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// The names of all rows of a table.
/// @param name_of  a member or a function that gives the name of a row
template <std::ranges::input_range Rows, class NameOf>
std::vector<std::string> names_of(const Rows& rows, NameOf name_of) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(std::invoke(name_of, row));
    return names;
}

/// The row of a table that has this name. Throws InputError that suggests the nearest name or, if none is
/// near, lists all names.
/// @param name_of  a member or a function that gives the name of a row
/// @param kind     what a row is, as the error calls it: "optimizer"
template <std::ranges::forward_range Rows, class NameOf>
auto& find_named(std::string_view name, Rows&& rows, NameOf name_of, std::string_view kind) {
    const auto row = std::ranges::find(rows, name, name_of);
    if (row == std::ranges::end(rows))
        throw InputError(unknown_name_message(kind, name, names_of(rows, name_of)));
    return *row;
}

}  // namespace fretwork::base
