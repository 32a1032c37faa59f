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
              "The kind of an error, where programs do more than show its text.", "other", "nothing-held",
              "part-not-held", "moves-freely", "not-calibrated");

FRETWORK_ENUM(pattern::Region, "Region", "The region of the base triangle in which a node of a layout lies.",
              "center", "left-radial", "right-radial", "face", "interface", "corner");
FRETWORK_ENUM(pattern::FilterParameter, "FilterParameter", "The kind of number that a filter is set with.",
              "none", "angle", "count", "length");
FRETWORK_ENUM(pattern::GraphRule::Property, "GraphProperty", "A property of a fan as a graph.", "connected",
              "without-articulation");
FRETWORK_ENUM(pattern::Symmetry, "Symmetry", "Whether a pattern is its own mirror image.", "none", "mirror");

FRETWORK_ENUM(mechanics::Dof, "Dof", "A component of a node's displacement.", "ux", "uy", "uz", "rx", "ry",
              "rz");
FRETWORK_ENUM(mechanics::Termination, "Termination",
              "How a solve ended. Not converged is an outcome, not an error.", "converged", "limit-load",
              "diverged", "iterations-spent");
FRETWORK_ENUM(mechanics::StabilityTest, "StabilityTest", "How the stability of an equilibrium was decided.",
              "none", "tangent", "symmetric-part");
FRETWORK_ENUM(mechanics::Solver, "Solver", "Ways to an equilibrium.", "linear", "newton",
              "dynamic-relaxation");
FRETWORK_ENUM(mechanics::Branch, "Branch", "Which equilibria to follow where a path becomes unstable.",
              "primary", "stable", "snapping");
FRETWORK_ENUM(mechanics::RotationalMass, "RotationalMass", "How fictitious masses of rotations are chosen.",
              "natural", "published");
FRETWORK_ENUM(mechanics::FactorChange, "FactorChange", "The effect of an edit on a structure's factors.",
              "kept", "updated", "anew");
FRETWORK_ENUM(mechanics::StartingPoint, "StartingPoint", "Where an equilibrium was looked for from.", "rest",
              "last-equilibrium");
FRETWORK_ENUM(mechanics::StabilityCheck, "StabilityCheck",
              "Whether the stability of an equilibrium is decided.", "made", "left");
FRETWORK_ENUM(mechanics::DeckReader, "DeckReader", "Which program is to read an input deck.", "abaqus",
              "calculix");

FRETWORK_ENUM(optimization::Evaluation, "Evaluation", "The kinds of evaluation that a problem may offer.",
              "value", "gradient", "residuals", "curvature");
FRETWORK_ENUM(optimization::OptimizerClass, "OptimizerClass", "The claim of a method.", "local", "global",
              "random");
FRETWORK_ENUM(optimization::Ending, "Ending", "How a run of an optimizer ended.", "converged", "budget-spent",
              "stalled", "invalid");
FRETWORK_ENUM(optimization::AnnealingBounds, "AnnealingBounds", "The treatment of a move beyond a bound.",
              "reflect", "clamp", "reject");
FRETWORK_ENUM(optimization::AnnealingVariables, "AnnealingVariables", "The annealed state.", "problem",
              "quantities");
FRETWORK_ENUM(optimization::CeresStep, "CeresStep", "How Ceres chooses its steps.", "levenberg-marquardt",
              "dogleg", "subspace-dogleg");
FRETWORK_ENUM(optimization::CeresBounds, "CeresBounds", "How Ceres keeps bounds.", "projection", "sine");

FRETWORK_ENUM(reduction::SamplePolicy, "SamplePolicy",
              "Whether samples past the first loss of stability are fitted.", "paper", "stable");
FRETWORK_ENUM(reduction::Joints, "Joints", "Which part of a bar is flexible.", "centreline", "stiff");
FRETWORK_ENUM(reduction::Displacements, "Displacements", "Which displacements a tile model is made for.",
              "small", "large");
FRETWORK_ENUM(reduction::Role, "Role",
              "The reference is the full model; reduced models are compared with it.", "reference",
              "reduced");
FRETWORK_ENUM(reduction::Sharing, "Sharing", "Whether congruent tiles of a surface are built once.", "none",
              "congruent");
FRETWORK_ENUM(reduction::TileParameter::Scale, "ParameterScale",
              "How a search measures distances between two values.", "linear", "logarithmic");
FRETWORK_ENUM(reduction::TileBeams, "TileBeams", "Whether the beams of a tile are those of its pattern.",
              "of-the-pattern", "substitutes");

FRETWORK_ENUM(library::Access, "Access", "How a library's file is opened.", "read-only", "read-write");

FRETWORK_ENUM(tiling::Narrow, "Narrow", "The treatment of an outline that is narrower than a tile.", "refine",
              "merge", "refuse");
FRETWORK_ENUM(tiling::Dithering, "Dithering",
              "Whether the value that a tile's pattern misses is handed to its neighbours.", "none",
              "error-diffusion");

FRETWORK_ENUM(simulation::TilesFrom, "TilesFrom", "Where the tiles of a new project come from.", "outline",
              "mesh");
FRETWORK_ENUM(simulation::Side, "Side", "A side of the bounding box.", "left", "right", "bottom", "top");
FRETWORK_ENUM(simulation::LoadCase::Amount, "Amount",
              "Whether each picked node gets the load, or all of them together, or each length of the rim.",
              "each", "total", "per-length");
FRETWORK_ENUM(simulation::Analysis, "Analysis",
              "Whether equilibrium is sought in the deformed or in the flat state.", "of-the-model",
              "linear");
FRETWORK_ENUM(simulation::ModeKind, "ModeKind", "Which modes of a surface are wanted.", "vibration",
              "buckling");

FRETWORK_ENUM(fabrication::NarrowPlace::Kind, "NarrowKind",
              "A gap, or an opening of which a sliver falls out.", "gap", "opening");
FRETWORK_ENUM(design::NodesGoal::Quantity, "Quantity", "What a target gives of single nodes.",
              "displacements", "positions");
FRETWORK_ENUM(design::DesignEnd, "DesignEnd", "How the search for a painting ended.", "no-swap-improves",
              "solutions-spent", "time-spent", "stopped");
FRETWORK_ENUM(exports::Content, "Content", "The kind of content of a file.", "drawing", "centrelines", "cut",
              "solid", "facts");
FRETWORK_ENUM(exports::WriterRow::Kind, "WriterKind", "What a writer reads besides surface and results.",
              "data", "drawing", "picture", "made");
FRETWORK_ENUM(exports::DrawnLabels::Shown, "Shown", "Whether numbers are drawn.", "no", "yes");
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
