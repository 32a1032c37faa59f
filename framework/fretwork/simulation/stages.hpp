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
    base::Borrowed<LoadCase>
        supports;                     ///< its supports hold the surface; its loads act where a stage names it
    std::span<const LoadCase> cases;  ///< the load cases that load stages may name
    std::span<const Stage> stages;    ///< one after the other
};

/// Simulate stage after stage, each from the equilibrium that the one before has led to
/// (mechanics::StagedPath), with a model for large displacements. With Branch::Snapping a stage goes on
/// beyond limit loads; with the others it ends there. Result::load_steps has one solution for each stage that
/// was begun; its subject names the stages and the load cases that they name. The error of corotational tiles
/// is estimated by the same stages with the worst tiles in full; the doubt and the error are the largest at
/// the end of any stage. Throws InputError for other models, for no stage, for a place that no node lies at,
/// and for a load case that is not there.
SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control = {});

}  // namespace fretwork::simulation
