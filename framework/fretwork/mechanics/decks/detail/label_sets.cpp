// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/quantity.hpp>
#include <fretwork/mechanics/decks/detail/label_sets.hpp>

#include <optional>

namespace fretwork::mechanics::decks {
namespace {

/// The largest number of labels that ranges and other sets put into sets, which take a gigabyte.
constexpr std::size_t kMostMembers = 20'000'000;
/// The largest number of labels in the sets that lines name, which take seconds: a million nodes in a hundred
/// lines.
constexpr std::size_t kMostUses = 100'000'000;

/// A range of labels.
struct Range {
    long first;
    long last;
    long step;
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>((last - first) / step + 1); }
};

Range read_range(const InputDeck& deck, const Card::Line& line) {
    const auto& [number, words, ends_with_comma] = line;
    if (words.size() < 2) deck.fail(number, "needs a first and a last label");
    const long step = words.size() > 2 && !words[2].empty() ? deck.integer(number, words[2]) : 1;
    if (step < 1) deck.fail(number, "steps by " + std::to_string(step) + ", and must step forward");
    const long first = deck.integer(number, words[0]);
    const long last = deck.integer(number, words[1]);
    if (last < first)
        deck.fail(number, "generates labels up to " + words[1] +
                              ", which must not be below the first label, " + words[0]);
    return {first, last, step};
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
            const Range range = read_range(deck, line);
            count_members(deck, line.number, range.size());
            for (long label = range.first; label <= range.last; label += range.step)
                members.insert(static_cast<int>(label));
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
            count_members(deck, line.number, inner->size());
            members.insert(inner->begin(), inner->end());
        }
    }
}

void LabelSets::count_members(const InputDeck& deck, std::size_t line, std::size_t labels) {
    members_ += labels;
    if (members_ > kMostMembers)
        deck.fail(line, "puts " + std::to_string(labels) +
                            " labels into a set; with those before, these are " + std::to_string(members_) +
                            ", where " + std::to_string(kMostMembers) + " at most are understood");
}

void LabelSets::count_use(const InputDeck& deck, std::size_t line, std::size_t labels) {
    uses_ += labels;
    if (uses_ > kMostUses)
        deck.fail(line, "names a set of " + std::to_string(labels) + " labels; the deck names sets of " +
                            std::to_string(uses_) + " labels by then, where " + std::to_string(kMostUses) +
                            " at most are understood");
}

const std::set<int>* LabelSets::find(const std::string& name) const {
    const auto found = sets_.find(name);
    return found == sets_.end() ? nullptr : &found->second;
}

}  // namespace fretwork::mechanics::decks
