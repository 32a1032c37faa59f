// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/project.hpp>
#include <fretwork/simulation/simulation_options.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fretwork::studio {

/// Which pattern lies in each tile, and how it is turned.
struct Painting {
    std::vector<pattern::NamedPattern> palette;
    std::vector<int> patterns;  ///< of each tile: an index into the palette; -1: not painted
    std::vector<int> turns;     ///< by how many vertices each tile is turned relative to `ground`
    /// For each tile the choice by place or by chance that painted it, as simulation::recipe_of() has it;
    /// null: the tile has no such recipe.
    std::vector<std::shared_ptr<const simulation::PaintingChoice>> recipes;
    friend bool operator==(const Painting&, const Painting&) = default;
};

/// The path and the content hash of the document's pattern library. Both empty: the document has no library.
struct LibraryLink {
    std::filesystem::path path;  ///< absolute
    std::string hash;
};

/// A document at one moment. Its parts are immutable and shared between moments: an edit replaces the parts
/// that it changes, and undo restores the state of the moment before. A part has changed if its address has
/// changed.
struct State {
    template <class Value>
    using Part = std::shared_ptr<const Value>;

    Part<simulation::Project> ground;  ///< layout, outlines and tiles; other members are not used
    Part<Painting> painting;
    Part<std::vector<std::string>> tile_models;  ///< own model of each tile; "": none
    Part<std::vector<simulation::LoadCase>> load_cases;
    Part<reduction::Setting> setting;
    Part<LibraryLink> library;
    Part<std::string> model;  ///< the live tile model
    simulation::Analysis analysis = simulation::Analysis::OfTheModel;

    [[nodiscard]] std::size_t tile_count() const { return painting->patterns.size(); }
    /// Whether all parts are the same objects, and the analysis is the same.
    friend bool operator==(const State&, const State&) = default;
};
using StatePtr = std::shared_ptr<const State>;

/// The document of a project whose file lies in `folder`. If the project has no setting, the document has the
/// paper's setting.
State make_state(const simulation::Project& project, const std::filesystem::path& folder);

/// The project of a document whose file is to lie in `folder`.
simulation::Project make_project(const State& state, const std::filesystem::path& folder);

/// The tile model that a document begins with: a reduced model without fitted parameters, if possible for
/// large displacements. If there are several, it is the last one in the catalogue.
std::string first_model();

/// The rough size, in bytes, of the parts of `state` that `other` does not share.
std::size_t size_of_difference(const State& state, const State& other);

}  // namespace fretwork::studio
