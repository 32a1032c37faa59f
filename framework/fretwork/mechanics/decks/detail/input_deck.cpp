// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/decks/detail/input_deck.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace fretwork::mechanics::decks {
namespace {

std::string trimmed_upper(std::string_view word) {
    std::string result;
    for (const char c : word) {
        if (c != ' ' && c != '\t' && c != '\r')
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return result;
}

Card card_of(const Words& words, std::size_t line) {
    Card card{words[0], {}, {}, line};
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i].empty()) continue;
        const auto equals = words[i].find('=');
        card.parameters[words[i].substr(0, equals)] =
            equals == std::string::npos ? "" : words[i].substr(equals + 1);
    }
    return card;
}

std::string list_of(std::initializer_list<const char*> words) {
    return base::join(std::vector<std::string>(words.begin(), words.end()), ", ");
}

}  // namespace

InputDeck::InputDeck(std::string_view text, std::string source) : source_(std::move(source)) {
    const auto lines = base::split(text, '\n');
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = trimmed_upper(lines[i]);
        if (line.empty() || line.starts_with("**")) continue;
        Words words = base::split(line, ',');
        if (line.starts_with("*")) {
            cards_.push_back(card_of(words, i + 1));
            continue;
        }
        if (cards_.empty()) fail(i + 1, "stands before the first keyword");
        const bool ends_with_comma = line.ends_with(',');
        while (words.size() > 1 && words.back().empty()) words.pop_back();
        cards_.back().lines.push_back({i + 1, std::move(words), ends_with_comma});
    }
}

void InputDeck::fail(std::size_t line, const std::string& message) const {
    throw base::InputError(source_ + ": line " + std::to_string(line) + " " + message);
}

double InputDeck::number(std::size_t line, const std::string& word) const {
    std::string text = word;
    if (const auto exponent = text.find('D'); exponent != std::string::npos) text[exponent] = 'E';
    const auto value = base::read_number<double>(text);
    if (!value || !std::isfinite(*value)) fail(line, "has '" + word + "' where a number is needed");
    return *value;
}

int InputDeck::integer(std::size_t line, const std::string& word) const {
    if (const auto value = base::read_number<int>(word)) return *value;
    fail(line, "has '" + word + "' where a whole number is needed");
}

std::vector<double> InputDeck::numbers(const Card::Line& line, Count count) const {
    std::vector<double> values;
    for (const std::string& word : line.words) {
        if (!word.empty()) values.push_back(number(line.number, word));
    }
    const std::string found = "has " + std::to_string(values.size()) + " numbers, where ";
    if (values.size() < count.least) fail(line.number, found + std::to_string(count.least) + " are needed");
    if (values.size() > count.most)
        fail(line.number, found + "no more than " + std::to_string(count.most) + " are understood");
    return values;
}

const std::string& InputDeck::parameter(const Card& card, const std::string& name) const {
    const auto found = card.parameters.find(name);
    if (found == card.parameters.end()) fail(card.line, "(" + card.keyword + ") needs the parameter " + name);
    if (found->second.empty())
        fail(card.line, "(" + card.keyword + ") has the parameter " + name + " without a value");
    return found->second;
}

void InputDeck::require_choice(const Card& card, const std::string& name,
                               std::initializer_list<const char*> choices) const {
    const auto found = card.parameters.find(name);
    if (found == card.parameters.end()) return;
    if (std::find(choices.begin(), choices.end(), found->second) == choices.end())
        fail(card.line, "(" + card.keyword + ") has " + name + "=" + found->second +
                            ", which is not understood: " + list_of(choices) +
                            (choices.size() > 1 ? " are" : " is"));
}

void InputDeck::allow_only(const Card& card, std::initializer_list<const char*> known) const {
    for (const auto& [name, value] : card.parameters) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        fail(card.line,
             "(" + card.keyword + ") has the parameter " + name + ", which is not understood: " +
                 (known.size() == 0 ? "none is" : list_of(known) + (known.size() > 1 ? " are" : " is")));
    }
}

const Card::Line& InputDeck::only_line(const Card& card, const std::string& why) const {
    if (card.lines.empty()) fail(card.line, "(" + card.keyword + ") has no values");
    if (card.lines.size() > 1) fail(card.lines[1].number, "is the second of " + card.keyword + ": " + why);
    return card.lines.front();
}

}  // namespace fretwork::mechanics::decks
