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

/// A load stage: changes of loads and held components. Everything else stays as at the end of the previous
/// load stage. A load stage may name a component in only one of `prescribed`, `keep` and `free`.
struct LoadStage {
    std::string name;  ///< name in reports; no other load stage has it
    /// Load cases with the new factors on their loads and prescribed displacements. 0 removes the loads, and
    /// holds the prescribed components at 0. Supports of these load cases are ignored.
    std::vector<LoadCase::Share> loads{};
    /// Components with their new values, which take precedence over `loads`. A support moves to its value.
    std::vector<LoadCase::PrescribedDisplacement> prescribed{};
    /// Components that are held at their present values.
    std::vector<LoadCase::Support> keep{};
    /// Prescribed or kept components that are released. Supports stay; a support that was moved is refused.
    std::vector<LoadCase::Support> free{};
    /// True if there is no entry of any kind.
    [[nodiscard]] bool is_empty() const {
        return loads.empty() && prescribed.empty() && keep.empty() && free.empty();
    }
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
/// Nodes are selected as in load cases; by a circle only in the format "fretwork/stages/2". Throws InputError
/// with source and place, also if there is no load stage, if one changes nothing, or if two have the same
/// name.
std::vector<LoadStage> parse_stages(std::string_view text, const std::string& source);
/// The text of a file of load stages. Throws NumericalError if a number is not finite.
std::string stages_text(std::span<const LoadStage> stages);
/// Read a file of load stages. Throws as parse_stages, and InputError if the file cannot be read.
std::vector<LoadStage> read_stages(const std::filesystem::path& path);

/// The names of the begun load stages, one for each of Result::load_steps. Empty for results without load
/// stages. Throws InputError as parse_stages.
std::vector<std::string> stage_names(const SurfaceResult& result);

/// Load stages with their load cases.
struct StagePlan {
    /// Load case with the surface's supports; its loads and prescribed displacements act only if a load stage
    /// names it.
    base::Borrowed<LoadCase> supports;
    std::span<const LoadCase> cases;    ///< the load cases that load stages may name
    std::span<const LoadStage> stages;  ///< load stages in order
};

/// Simulate load stages in order with a model for large displacements. Each load stage starts from the last
/// equilibrium of the previous one (mechanics::StagedPath). With Branch::Snapping, a load stage continues
/// beyond limit loads; with other branches, it ends at a limit load. Result::load_steps has one solution for
/// each begun load stage. The subject of the result contains the load stages and their load cases. The error
/// of corotational tiles is estimated by the same load stages with all beams in the worst tiles. The doubt
/// and the error in the result are the largest at the end of any load stage. Throws InputError for linear and
/// mixed models, several load steps and `estimate_error`; for `estimate_model_error` of a model that is not
/// `corotational`; if there is no load stage; and as check_stages() and SimulationOptions::validate(). Throws
/// NumericalError if the supports do not hold the surface; base::Stopped.
SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control = {});

}  // namespace fretwork::simulation
