// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace fretwork::mechanics::decks {

/// The meaning of a card's parameter OP for the values of earlier steps.
enum class StepOperation {
    Mod,  ///< values of earlier steps stay unless a card gives a new value
    /// Values of earlier steps are removed; only the first card of a kind in a step can have this effect.
    New
};

/// The values of one kind (supports, forces or gravity) through the steps of a deck.
template <class Key, class Value>
class StepValues {
  public:
    void begin_step() {
        ++step_;
        is_first_card_ = true;
    }
    void begin_card(StepOperation operation) {
        if (operation == StepOperation::New && is_first_card_) entries_.clear();
        is_first_card_ = false;
    }
    /// Set a value, in place of any earlier value.
    void replace(const Key& key, const Value& value) { entries_[key] = {value, step_}; }
    /// Add to a value of this step, or replace a value of an earlier step.
    void add(const Key& key, const Value& value) {
        const auto found = entries_.find(key);
        if (found != entries_.end() && found->second.step == step_)
            found->second.value += value;
        else
            replace(key, value);
    }
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const auto& [key, entry] : entries_) visit(key, entry.value);
    }

  private:
    struct Entry {
        Value value;
        int step = 0;
    };
    std::map<Key, Entry> entries_;
    int step_ = 0;
    bool is_first_card_ = true;
};

/// The supports and loads of a structure after all steps of a deck. The rules are from the CalculiX CrunchiX
/// User's Manual (Dhondt; *BOUNDARY, *CLOAD and *DLOAD). With OP=MOD, the default, values of earlier steps
/// stay, and a new value for the same node and direction replaces the old value. With OP=NEW on the first
/// such card of a step, earlier values of that kind are removed. Within one step forces on one node and
/// direction add up, and the last displacement holds. Gravity is identified by its set and direction:
/// CalculiX adds gravity in another direction to the gravity of an earlier step.
class DeckHistory {
  public:
    void begin_step();
    void begin_boundary(StepOperation operation) { held_.begin_card(operation); }
    void begin_loads(StepOperation operation) { loads_.begin_card(operation); }
    void begin_gravity(StepOperation operation) { gravity_.begin_card(operation); }

    /// @param value  metres or radians; zero for a support
    void hold(NodeIndex node, Dof dof, double value) { held_.replace({node, dof}, value); }
    /// @param value  newtons or newton metres
    void load(NodeIndex node, Dof dof, double value) { loads_.add({node, dof}, value); }
    /// @param magnitude  m/s^2, along a direction of any length but zero
    void pull(const std::string& set, double magnitude, const Eigen::Vector3d& direction);

    /// Give a frame its supports, prescribed displacements, loads and gravity.
    void put_into(Frame& frame) const;

  private:
    using Place = std::pair<NodeIndex, Dof>;
    /// A set, and the direction to within rounding.
    using Pull = std::pair<std::string, std::array<long long, 3>>;

    StepValues<Place, double> held_;
    StepValues<Place, double> loads_;
    StepValues<Pull, Eigen::Vector3d> gravity_;
};

}  // namespace fretwork::mechanics::decks
