// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` that say how a surface is cut or printed.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <typed/making_choice.hpp>

namespace fretwork::app {

void add_making_options(CLI::App& verb, typed::MakingChoice& texts);

/// Throw InputError if an option is given that no writer uses.
void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers);

}  // namespace fretwork::app
