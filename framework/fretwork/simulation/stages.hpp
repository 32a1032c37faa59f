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

/// The changes in one stage. Everything else stays as the stage before has left it.
struct Stage {
    std::string name;
    std::vector<LoadCase::Share> loads{};  ///< load cases whose loads come to this factor; 0 takes them off
    std::vector<LoadCase::PrescribedDisplacement> prescribed{};  ///< these components come to these values
    std::vector<LoadCase::Support> keep{};                       ///< these stay where they are
    std::vector<LoadCase::Support> free{};  ///< released, if they were prescribed or kept
};

/// Parse stages:
///
///     { "format": "fretwork/stages/1", "stages": [
///         { "name": "press",  "loads": [{ "load_case": "tip", "factor": 2 }] },
///         { "name": "clip",   "keep": [{ "side": "right", "fixed": ["uz"] }] },
///         { "name": "unload", "loads": [{ "load_case": "tip", "factor": 0 }] },
///         { "name": "push",   "prescribed": [{ "nearest": [[0.1, 0.2]], "uz": -0.01 }] },
///         { "name": "let go", "free": [{ "side": "right", "fixed": ["uz"] }] } ] }
///
/// Places are picked as in load cases. Throws InputError with source and place.
std::vector<Stage> parse_stages(std::string_view text, const std::string& source);
/// The text of a stages file.
std::string stages_text(std::span<const Stage> stages);
/// Throws as parse_stages.
std::vector<Stage> read_stages(const std::filesystem::path& path);

/// Stages, and what they are made of.
struct StagePlan {
    base::Borrowed<LoadCase>
        supports;                     ///< its supports hold the surface; its loads act where a stage names it
    std::span<const LoadCase> cases;  ///< those that stages may name
    std::span<const Stage> stages;
};

/// Simulate stage after stage, each from the equilibrium that the one before has led to
/// (mechanics::StagedPath), with a model for large displacements. With Branch::Snapping a stage goes on
/// beyond limit loads; with the others it ends there. Result::load_steps has one solution for each stage that
/// was begun; its subject names the stages and the load cases that they name. Throws InputError for other
/// models, for no stage, for a place that no node lies at, and for a load case that is not there.
SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control = {});

}  // namespace fretwork::simulation
