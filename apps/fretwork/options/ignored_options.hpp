// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string>

namespace fretwork::app {

/// Options without an effect are a misunderstanding: refuse those of these that are given.
/// @param why  what they are for: "is for drawings, .."
inline void refuse_given(const CLI::App& verb, std::initializer_list<const char*> options,
                         const std::string& why) {
    for (const char* option : options) {
        if (verb.count(option) > 0) throw base::InputError(option, "", why);
    }
}

}  // namespace fretwork::app
