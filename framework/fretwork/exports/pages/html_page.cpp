// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/pages/html_page.hpp>

namespace fretwork::exports::detail {
namespace {

/// JSON for a script element of an HTML page, which a text "</script>" would otherwise end.
std::string text_in_page(const base::Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, base::Json::error_handler_t::replace)) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace

std::string page_with_data(std::string_view page, const base::Json& data) {
    constexpr std::string_view kMark = "@DATA@";
    const std::size_t at = page.find(kMark);
    return std::string(page.substr(0, at)) + text_in_page(data) + std::string(page.substr(at + kMark.size()));
}

}  // namespace fretwork::exports::detail
