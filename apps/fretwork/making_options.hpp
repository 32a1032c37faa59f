// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fretwork export` that say how a surface is cut or printed.
#pragma once

#include <fretwork/exports/writer_catalogue.hpp>

#include <CLI/CLI.hpp>

#include <span>
#include <string>

namespace fretwork::app {

/// As they are typed; empty: not given.
struct MakingTexts {
    std::string fillet;
    std::string kerf;
    std::string frame;
    std::string bolts;
    std::string eye;
    std::string bed;
    std::string fit;
    std::string clearance;
    std::string layer;
};

void add_making_options(CLI::App& verb, MakingTexts& texts);

/// Refuse options that none of the files which are written looks at.
void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers);

/// Throws InputError that names the option. `conditions` of the load case, or null: bolts are at its
/// supports.
exports::Making read_making(const MakingTexts& texts, const simulation::Conditions* conditions);

}  // namespace fretwork::app
