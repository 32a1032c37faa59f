// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/painting_choice.hpp>

#include <CLI/CLI.hpp>

namespace fretwork::app {

/// The options that say how tiles are painted: of `tile` and `paint`. `choice` must outlive the verb.
void add_painting_options(CLI::App& verb, simulation::PaintingChoice& choice);

}  // namespace fretwork::app
