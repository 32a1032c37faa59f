// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` that say how a surface is cut or printed.
#pragma once

#include <fretwork/exports/making/making_choice.hpp>

#include <CLI/CLI.hpp>

#include <span>

namespace fretwork::app {

void add_making_options(CLI::App& verb, exports::MakingChoice& texts);

/// Refuse options that none of the files which are written looks at.
void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers);

}  // namespace fretwork::app
