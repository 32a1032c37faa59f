// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The enums of the framework with their words in Python, in the order of their values. A word is the C++ name
// in small letters with hyphens: what commands and files call it.

#include "core/casters.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/exports/scene.hpp>
#include <fretwork/exports/tables/library_meshes.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/optimization/methods/ceres_residuals.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/sameness.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>

#include <array>

namespace fretwork::python {

// NOLINTBEGIN(cppcoreguidelines-macro-usage): a template cannot take the words
#define FRETWORK_ENUM(Type, name, doc, ...)                                       \
    template <>                                                                   \
    struct Words<Type> {                                                          \
        static constexpr char kName[] = name;                                     \
        static constexpr const char* kDoc = doc;                                  \
        static constexpr auto kWords = std::to_array<const char*>({__VA_ARGS__}); \
    }
// NOLINTEND(cppcoreguidelines-macro-usage)

FRETWORK_ENUM(base::ErrorKind, "ErrorKind",
              "The kind of an error, for programs that do more than show its text.", "other", "nothing-held",
              "part-not-held", "moves-freely", "not-calibrated");

FRETWORK_ENUM(pattern::Region, "Region", "The region of the base triangle in which a node of a layout lies.",
              "center", "left-radial", "right-radial", "face", "interface", "corner");
FRETWORK_ENUM(pattern::FilterParameter, "FilterParameter", "The kind of number that sets a filter.", "none",
              "angle", "count", "length");
FRETWORK_ENUM(pattern::GraphRule::Property, "GraphProperty", "A property of the graph of a fan.", "connected",
              "without-articulation");
FRETWORK_ENUM(pattern::Symmetry, "Symmetry", "The symmetries of a pattern's fan beside its rotations.",
              "none", "mirror");

FRETWORK_ENUM(mechanics::Dof, "Dof", "A component of a node's displacement.", "ux", "uy", "uz", "rx", "ry",
              "rz");
FRETWORK_ENUM(mechanics::Termination, "Termination",
              "The way in which the search for a solution ended. A solution that has not converged is an "
              "outcome, not an error.",
              "converged", "limit-load", "diverged", "iterations-spent");
FRETWORK_ENUM(mechanics::StabilityTest, "StabilityTest",
              "The test that decided whether an equilibrium is stable.", "none", "tangent", "symmetric-part");
FRETWORK_ENUM(mechanics::Solver, "Solver", "The solvers that find an equilibrium.", "linear", "newton",
              "dynamic-relaxation");
FRETWORK_ENUM(mechanics::Branch, "Branch", "The equilibria to follow when a path becomes unstable.",
              "primary", "stable", "snapping");
FRETWORK_ENUM(mechanics::RotationalMass, "RotationalMass",
              "The growth of the fictitious masses of rotations as elements get shorter.", "natural",
              "published");
FRETWORK_ENUM(mechanics::FactorChange, "FactorChange", "The effect of an edit on a structure's factors.",
              "kept", "updated", "refactorized");
FRETWORK_ENUM(mechanics::StartingPoint, "StartingPoint", "The state from which an equilibrium was found.",
              "rest", "last-equilibrium");
FRETWORK_ENUM(mechanics::StabilityCheck, "StabilityCheck",
              "The choice whether to check the stability of an equilibrium.", "made", "skipped");
FRETWORK_ENUM(mechanics::DeckProgram, "DeckProgram", "The program that is to read an input deck.", "abaqus",
              "calculix");

FRETWORK_ENUM(optimization::Evaluation, "Evaluation", "The kinds of evaluation that a problem may offer.",
              "value", "gradient", "residuals", "curvature");
FRETWORK_ENUM(optimization::OptimizerClass, "OptimizerClass", "The kind of search that a method performs.",
              "local", "global", "random");
FRETWORK_ENUM(optimization::Ending, "Ending", "The way in which a run of an optimizer ended.", "converged",
              "budget-spent", "stalled", "invalid", "stopped");
FRETWORK_ENUM(optimization::AnnealingBounds, "AnnealingBounds", "The treatment of a move beyond a bound.",
              "reflect", "clamp", "reject");
FRETWORK_ENUM(optimization::AnnealingVariables, "AnnealingVariables",
              "The variables in which annealing moves.", "problem", "quantities");
FRETWORK_ENUM(optimization::CeresStep, "CeresStep", "The method by which Ceres chooses its steps.",
              "levenberg-marquardt", "dogleg", "subspace-dogleg");
FRETWORK_ENUM(optimization::CeresBounds, "CeresBounds",
              "The way in which variables are kept within their bounds.", "projection", "sine");

FRETWORK_ENUM(reduction::SamplePolicy, "SamplePolicy",
              "The treatment of samples past the first loss of stability.", "paper", "stable");
FRETWORK_ENUM(reduction::Joints, "Joints", "The part of a bar that is flexible.", "centreline", "stiff");
FRETWORK_ENUM(reduction::Displacements, "Displacements",
              "The size of the displacements for which a tile model is made.", "small", "large");
FRETWORK_ENUM(reduction::Role, "Role",
              "The reference is the full model; reduced models are compared with it.", "reference",
              "reduced");
FRETWORK_ENUM(reduction::Sharing, "Sharing",
              "The choice whether congruent tiles of a surface are built once.", "none", "congruent");
FRETWORK_ENUM(reduction::TileParameter::Scale, "ParameterScale",
              "The scale on which a search measures the distance between two values.", "linear",
              "logarithmic");
FRETWORK_ENUM(reduction::TileBeams, "TileBeams", "The meaning of a tile's beams.", "of-the-pattern",
              "substitutes");

FRETWORK_ENUM(library::Access, "Access", "The access to a library's file.", "read-only", "read-write");

FRETWORK_ENUM(tiling::Narrow, "Narrow", "The treatment of an outline that is narrower than a tile.", "refine",
              "merge", "refuse");
FRETWORK_ENUM(tiling::Dithering, "Dithering",
              "The choice whether a tile passes its error to its neighbours that are not painted yet.",
              "none", "error-diffusion");

FRETWORK_ENUM(simulation::TilesFrom, "TilesFrom", "The source of the tiles of a new project.", "outline",
              "mesh");
FRETWORK_ENUM(simulation::Side, "Side", "A side of the bounding box.", "left", "right", "bottom", "top");
FRETWORK_ENUM(
    simulation::LoadCase::Amount, "Amount",
    "The meaning of a load's value: for each node, for all nodes together, or for each metre of the rim.",
    "each", "total", "per-length");
FRETWORK_ENUM(simulation::Analysis, "Analysis",
              "The choice whether equilibrium is sought in the deformed or in the flat state.",
              "of-the-model", "linear");
FRETWORK_ENUM(simulation::ModeKind, "ModeKind", "The kind of modes of a surface.", "vibration", "buckling");

FRETWORK_ENUM(fabrication::NarrowPlace::Kind, "NarrowKind",
              "The kind of a narrow place: a gap, or an opening from which a sliver falls out.", "gap",
              "opening");
FRETWORK_ENUM(design::NodesGoal::Quantity, "Quantity", "The quantity that a target states for single nodes.",
              "displacements", "positions");
FRETWORK_ENUM(design::DesignEnd, "DesignEnd", "The way in which the search for a painting ended.",
              "no-swap-improves", "solutions-spent", "time-spent", "stopped", "unreachable");
FRETWORK_ENUM(exports::Content, "Content", "The kind of content of a file.", "drawing", "centrelines", "cut",
              "solid", "facts");
FRETWORK_ENUM(exports::WriterRow::Kind, "WriterKind",
              "The input of a writer in addition to surface and results.", "data", "drawing", "picture",
              "motion", "made");
FRETWORK_ENUM(exports::DrawnLabels::Shown, "Shown", "The choice whether numbers are drawn.", "no", "yes");
FRETWORK_ENUM(exports::MeshKind, "MeshKind", "Kinds of files for meshes of lines.", "obj", "ply");

#undef FRETWORK_ENUM

/// Makes the Python class of an enum, a StrEnum: members have the words in capitals as names.
py::object make_enum_class(py::module_& module, const char* name, const char* doc,
                           std::span<const char* const> words);

template <class Enum>
void bind_enum(py::module_& module) {
    using W = Words<Enum>;
    py::detail::type_caster<Enum>::type =
        make_enum_class(module, W::kName, W::kDoc, W::kWords).release().ptr();
}

}  // namespace fretwork::python
