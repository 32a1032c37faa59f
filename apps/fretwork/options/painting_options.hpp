// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <CLI/CLI.hpp>

namespace fretwork::app {

/// The options that say how tiles are painted: of `tile` and `paint`. `choice` must outlive the verb.
void add_painting_options(CLI::App& verb, simulation::PaintingChoice& choice);

/// How many tiles are not painted yet.
std::size_t unpainted_count(const tiling::Tessellation& tessellation);

}  // namespace fretwork::app
