// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/decks/detail/input_deck.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace fretwork::mechanics::decks {

/// The label that a word means where a label or a set may stand; none if the word is the name of a set. A
/// number is always a label, as in ccx, even if a set has this number as its name.
std::optional<int> label_of(const std::string& word);

/// The named sets of nodes, or of elements, of an input deck. A set contains each label once.
class LabelSets {
  public:
    /// @param kind  the parameter that names a set, NSET or ELSET
    explicit LabelSets(std::string kind) : kind_(std::move(kind)) {}

    /// Add the entries of a card *NSET or *ELSET: labels, names of sets that are defined before, or ranges
    /// (GENERATE).
    void read(const InputDeck& deck, const Card& card);
    void add(const std::string& set, int label) { sets_[set].insert(label); }
    /// The labels of a set; null if the set does not exist.
    [[nodiscard]] const std::set<int>* find(const std::string& name) const;
    /// Count the labels of a set that a line names. Large sets in very many lines, which would take hours,
    /// are refused.
    void count_use(const InputDeck& deck, std::size_t line, std::size_t labels);

  private:
    void count_members(const InputDeck& deck, std::size_t line, std::size_t labels);

    std::string kind_;
    std::size_t members_ = 0;  ///< labels that were put into sets by ranges and by other sets
    std::size_t uses_ = 0;     ///< labels of the sets that lines have named
    std::map<std::string, std::set<int>> sets_;
};

}  // namespace fretwork::mechanics::decks
