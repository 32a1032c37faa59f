// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <span>
#include <typed/painting_text.hpp>

namespace fretwork::app {

/// The options that say how tiles are painted: of `tile`, `paint` and `retile`. `text` must outlive the verb.
void add_painting_options(CLI::App& verb, typed::PaintingText& text);

/// An error of simulation::paint() that names the option instead of the entry of the choice.
base::InputError with_option_name(base::InputError error);

/// Warns if tiles that a choice has just painted have no recipe, because the choice's image or drawing is too
/// large.
void warn_of_unkept_file(const simulation::Project& project, const simulation::PaintingChoice& choice,
                         std::span<const tiling::TileIndex> painted);

/// How many tiles are not painted yet.
std::size_t unpainted_count(const tiling::Tessellation& tessellation);

}  // namespace fretwork::app
