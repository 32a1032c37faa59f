// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>

#include <algorithm>

namespace fretwork::base {

std::string text_of(const ErrorData& data) {
    std::string text;
    for (const auto& [source, place] : data.where) {
        if (!source.empty()) text += source + ": ";
        if (!place.empty()) text += place + ": ";
    }
    return text + data.problem;
}

std::string defect_text(const std::exception& defect) {
    return std::string("a defect of the program; please report it with what led to it: ") + defect.what();
}

bool names_source(const Error& error, const std::string& source) {
    return std::ranges::find(error.data().where, source, &ErrorPlace::source) != error.data().where.end();
}

}  // namespace fretwork::base
