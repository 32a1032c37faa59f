// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` that say how a surface is cut or printed.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <typed/making_choice.hpp>

namespace fretwork::app {

void add_making_options(CLI::App& verb, typed::MakingChoice& texts);

/// Refuse options that none of the files which are written looks at.
void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers);

}  // namespace fretwork::app
