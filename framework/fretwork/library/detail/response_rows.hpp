// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>
#include <fretwork/reduction/response.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// The shape of a library's responses: the same for all of its patterns.
struct ResponseShape {
    const reduction::Setting* setting;
    int nodes;  ///< interface nodes of a tile
};

/// Throw InputError or NumericalError, with the pattern's name, unless there is one response for each
/// scenario of the setting, with all samples and rows, and all values are finite.
void check_responses(const Database& database, const std::string& pattern_id,
                     const std::vector<reduction::Response>& responses, const ResponseShape& shape);

/// Insert responses that passed check_responses. Samples that did not converge have a state and no rows of
/// displacements.
void insert_responses(const Database& database, const std::string& pattern_id,
                      const std::vector<reduction::Response>& responses);

/// The responses of a pattern in the order of the setting's scenarios; empty if they are not there.
std::vector<reduction::Response> read_responses(const Database& database, std::string_view pattern_id,
                                                const ResponseShape& shape);

/// True if all values are equal.
bool are_equal(const std::vector<reduction::Response>& left, const std::vector<reduction::Response>& right);

}  // namespace fretwork::library::detail
