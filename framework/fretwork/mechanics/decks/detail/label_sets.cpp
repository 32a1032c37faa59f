// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/quantity.hpp>
#include <fretwork/mechanics/decks/detail/label_sets.hpp>

#include <optional>

namespace fretwork::mechanics::decks {
namespace {

/// The largest number of labels that the lines of a deck look at together. A deck of a million nodes in a
/// dozen sets stays below it.
constexpr std::size_t kMostLabels = 20'000'000;

void generate(const InputDeck& deck, const Card::Line& line, LabelSets& sets, std::set<int>& members) {
    const auto& [number, words, ends_with_comma] = line;
    if (words.size() < 2) deck.fail(number, "needs a first and a last label");
    const long step = words.size() > 2 && !words[2].empty() ? deck.integer(number, words[2]) : 1;
    if (step < 1) deck.fail(number, "steps by " + std::to_string(step) + ", and must step forward");
    const long first = deck.integer(number, words[0]);
    const long last = deck.integer(number, words[1]);
    if (last < first)
        deck.fail(number, "generates labels up to " + words[1] +
                              ", which must not be below the first label, " + words[0]);
    sets.count(deck, number, static_cast<std::size_t>((last - first) / step + 1));
    for (long label = first; label <= last; label += step) members.insert(static_cast<int>(label));
}

}  // namespace

std::optional<int> label_of(const std::string& word) {
    return base::read_number<int>(word);
}

void LabelSets::read(const InputDeck& deck, const Card& card) {
    deck.allow_only(card, {kind_.c_str(), "GENERATE", "INTERNAL", "UNSORTED"});
    const std::string& name = deck.parameter(card, kind_);
    std::set<int>& members = sets_[name];
    for (const Card::Line& line : card.lines) {
        if (card.has("GENERATE")) {
            generate(deck, line, *this, members);
            continue;
        }
        for (const std::string& word : line.words) {
            if (word.empty()) continue;
            if (const std::optional<int> label = label_of(word)) {
                members.insert(*label);
                continue;
            }
            if (word == name) deck.fail(line.number, "puts the set " + name + " into itself");
            const std::set<int>* inner = find(word);
            if (inner == nullptr)
                deck.fail(line.number, "puts " + word + " into the set " + name +
                                           ", where labels and sets that are defined before are possible");
            count(deck, line.number, inner->size());
            members.insert(inner->begin(), inner->end());
        }
    }
}

void LabelSets::count(const InputDeck& deck, std::size_t line, std::size_t labels) {
    counted_ += labels;
    if (counted_ > kMostLabels)
        deck.fail(line, "names sets (" + kind_ + ") of " + std::to_string(counted_) +
                            " labels, counted in all lines so far, where " + std::to_string(kMostLabels) +
                            " at most are understood");
}

const std::set<int>* LabelSets::find(const std::string& name) const {
    const auto found = sets_.find(name);
    return found == sets_.end() ? nullptr : &found->second;
}

}  // namespace fretwork::mechanics::decks
