// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/internal/json_text.hpp>

#include <bit>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::exports::detail {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// The little-endian bytes of the numbers as Base64, for the data of a page.
template <class Number>
std::string packed(const std::vector<Number>& numbers) {
    return base::encode_base64(
        {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

/// The page with the data as JSON in place of its mark "@DATA@", safe inside a script element. Pre: the page
/// has the mark.
std::string page_with_data(std::string_view page, const base::Json& data);

}  // namespace fretwork::exports::detail
