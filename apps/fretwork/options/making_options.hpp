// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` that say how a surface is cut or printed.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <typed/making_choice.hpp>

namespace fretwork::app {

/// Add these options to a verb. The verb writes the texts of the options to `texts`, which must live as long
/// as the verb.
void add_making_options(CLI::App& verb, typed::MakingChoice& texts);

/// Throw InputError if an option is given that none of `writers` uses.
void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers);

}  // namespace fretwork::app
