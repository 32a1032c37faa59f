// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/base/control.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::simulation {

/// The changes in one load stage. Everything else stays as the previous load stage left it.
struct Stage {
    std::string name;                      ///< for reports
    std::vector<LoadCase::Share> loads{};  ///< load cases whose loads change to this factor; 0 removes them
    std::vector<LoadCase::PrescribedDisplacement> prescribed{};  ///< components that change to these values
    std::vector<LoadCase::Support> keep{};                       ///< components held where they are
    std::vector<LoadCase::Support> free{};  ///< components released, if they were prescribed or kept
};

/// Parse load stages:
///
///     { "format": "fretwork/stages/1", "stages": [
///         { "name": "press",  "loads": [{ "load_case": "tip", "factor": 2 }] },
///         { "name": "clip",   "keep": [{ "side": "right", "fixed": ["uz"] }] },
///         { "name": "unload", "loads": [{ "load_case": "tip", "factor": 0 }] },
///         { "name": "push",   "prescribed": [{ "nearest": [[0.1, 0.2]], "uz": -0.01 }] },
///         { "name": "let go", "free": [{ "side": "right", "fixed": ["uz"] }] } ] }
///
/// Nodes are selected as in load cases. Throws InputError with source and place.
std::vector<Stage> parse_stages(std::string_view text, const std::string& source);
/// The text of a file of load stages.
std::string stages_text(std::span<const Stage> stages);
/// Read a file of load stages. Throws as parse_stages.
std::vector<Stage> read_stages(const std::filesystem::path& path);

/// Load stages with the load cases that they need.
struct StagePlan {
    base::Borrowed<LoadCase> supports;  ///< its supports hold the surface; its loads act only if a load stage
                                        ///< names it
    std::span<const LoadCase> cases;    ///< the load cases that load stages may name
    std::span<const Stage> stages;      ///< one after the other
};

/// Simulate load stages, each from the equilibrium at the end of the previous one (mechanics::StagedPath),
/// with a model for large displacements. With Branch::Snapping a load stage continues beyond limit loads;
/// with other branches it ends there. Result::load_steps has one solution for each load stage that was begun.
/// The result's subject has the load stages and their load cases. Throws InputError if the model is for small
/// displacements, if there is no load stage, if a selection has no node, or if a load case is missing.
SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control = {});

}  // namespace fretwork::simulation
