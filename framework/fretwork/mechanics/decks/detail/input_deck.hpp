// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics::decks {

using Words = std::vector<std::string>;

/// A keyword of an input deck, its parameters, and the data lines under it; all texts are without blanks and
/// in capitals.
struct Card {
    struct Line {
        std::size_t number = 0;  ///< number of the line in the file
        Words words;             ///< without the empty words after the last value
        bool ends_with_comma = false;
    };
    std::string keyword;
    /// Values of parameters; empty for a parameter without a value.
    std::map<std::string, std::string> parameters;
    std::vector<Line> lines;
    std::size_t line = 0;

    [[nodiscard]] bool has(const std::string& parameter) const { return parameters.contains(parameter); }
};

/// The cards of a CalculiX or Abaqus input deck, with functions that read their words. All errors are
/// InputErrors with source and line.
class InputDeck {
  public:
    /// @param source  name of the text in messages
    InputDeck(std::string_view text, std::string source);

    [[nodiscard]] const std::string& source() const { return source_; }
    [[nodiscard]] const std::vector<Card>& cards() const { return cards_; }

    [[noreturn]] void fail(std::size_t line, const std::string& message) const;

    /// The value of a word, a finite number, also with an exponent as in Fortran (1.0D9).
    [[nodiscard]] double number(std::size_t line, const std::string& word) const;
    [[nodiscard]] int integer(std::size_t line, const std::string& word) const;

    struct Count {
        std::size_t least = 0;
        std::size_t most = std::numeric_limits<std::size_t>::max();
    };
    /// The numbers of a line; empty words are skipped.
    [[nodiscard]] std::vector<double> numbers(const Card::Line& line, Count count) const;

    /// The value of a parameter. Throws InputError if the card lacks the parameter or its value.
    [[nodiscard]] const std::string& parameter(const Card& card, const std::string& name) const;
    /// Check that an optional parameter, if present, has one of these values.
    void require_choice(const Card& card, const std::string& name,
                        std::initializer_list<const char*> choices) const;
    /// Refuse unknown parameters, which may change the meaning of a card.
    void allow_only(const Card& card, std::initializer_list<const char*> known) const;
    /// The only data line of a card. Throws InputError with the reason `why` if there is not exactly one.
    [[nodiscard]] const Card::Line& only_line(const Card& card, const std::string& why) const;

  private:
    std::string source_;
    std::vector<Card> cards_;
};

}  // namespace fretwork::mechanics::decks
