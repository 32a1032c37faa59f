// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "verbs/library/library_find.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fretwork::app {
namespace {

using base::Json;
using library::FoundPattern;
using library::FoundPatterns;

FoundPatterns found_by(const library::Library& library, const library::PatternQuery& query) {
    try {
        return library.find(query);
    } catch (const base::InputError& error) {
        throw base::renamed(base::renamed(error, "where", "--where"), "sort", "--sort");
    }
}

Json found_json(const FoundPatterns& found) {
    Json patterns = Json::array();
    for (const FoundPattern& pattern : found.patterns) {
        Json row = {{"id", pattern.id}, {"mirror", pattern.mirror.empty() ? Json() : Json(pattern.mirror)}};
        for (std::size_t c = 0; c < found.columns.size(); ++c)
            row[found.columns[c]] = base::or_null(pattern.values[c]);
        patterns.push_back(std::move(row));
    }
    return {{"columns", found.columns}, {"patterns", std::move(patterns)}};
}

void print_table(const FoundPatterns& found) {
    std::size_t width = 2;
    for (const FoundPattern& pattern : found.patterns) width = std::max(width, pattern.id.size());
    std::printf("%-*s", static_cast<int>(width), "id");
    for (const std::string& column : found.columns) std::printf("  %s", column.c_str());
    std::puts("");
    for (const FoundPattern& pattern : found.patterns) {
        std::printf("%-*s", static_cast<int>(width), pattern.id.c_str());
        for (std::size_t c = 0; c < found.columns.size(); ++c)
            std::printf("  %*s", static_cast<int>(found.columns[c].size()),
                        pattern.values[c] ? base::format_number(*pattern.values[c], 4).c_str() : "");
        std::puts("");
    }
}

}  // namespace

void print_found(const library::Library& library, const library::PatternQuery& query, bool as_json) {
    const FoundPatterns found = found_by(library, query);
    if (as_json) return print_document(found_json(found));
    print_table(found);
    std::printf(
        "\n%zu of %zu patterns whose behaviour is known; the library has %zu, and calibrate computes "
        "the behaviour\n",
        found.patterns.size(), found.known, library.pattern_count());
}

}  // namespace fretwork::app
