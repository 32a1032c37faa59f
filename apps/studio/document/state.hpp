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
    /// null: it was painted by hand.
    std::vector<std::shared_ptr<const simulation::PaintingChoice>> recipes;
    friend bool operator==(const Painting&, const Painting&) = default;
};

/// The path of the pattern library, and the hash that it had. Both empty: there is none.
struct LibraryLink {
    std::filesystem::path path;  ///< absolute
    std::string hash;
};

/// A document at one moment. Its parts are immutable and shared between moments: an edit replaces one part,
/// and to undo is to go back to the moment before. A part has changed if its address has.
struct State {
    template <class Value>
    using Part = std::shared_ptr<const Value>;

    Part<simulation::Project> ground;  ///< layout, outline and tiles; its painting and all else is not used
    Part<Painting> painting;
    Part<std::vector<std::string>> tile_models;  ///< own model of each tile; "": none
    Part<std::vector<simulation::LoadCase>> load_cases;
    Part<reduction::Setting> setting;
    Part<LibraryLink> library;
    Part<std::string> model;  ///< the live tile model
    simulation::Analysis analysis = simulation::Analysis::OfTheModel;

    [[nodiscard]] std::size_t tile_count() const { return painting->patterns.size(); }
    /// Whether all parts are the same objects.
    friend bool operator==(const State&, const State&) = default;
};
using StatePtr = std::shared_ptr<const State>;

/// The document of a project whose file lies in `folder`.
State make_state(const simulation::Project& project, const std::filesystem::path& folder);

/// The project of a document whose file is to lie in `folder`.
simulation::Project make_project(const State& state, const std::filesystem::path& folder);

/// The tile model that a document begins with: the last reduced model in the catalogue without fitted
/// parameters; among these, one for large displacements if there is any.
std::string first_model();

/// A rough size of what two states do not share, in bytes.
std::size_t size_of_difference(const State& state, const State& other);

}  // namespace fretwork::studio
