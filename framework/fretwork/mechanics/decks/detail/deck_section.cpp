// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/decks/detail/deck_section.hpp>

namespace fretwork::mechanics::decks {
namespace {

/// Call `make`, and add the line to an error about a shape's dimensions.
template <class Make>
Section made_at(const InputDeck& deck, const Card::Line& line, const Make& make) {
    return base::located(deck.source(), "line " + std::to_string(line.number), make);
}

/// The diameter of a circle, for which Abaqus states the radius, and CalculiX the thicknesses along n1 and
/// n2.
double diameter_of(const InputDeck& deck, const Card::Line& line) {
    const auto size = deck.numbers(line, {1, 2});
    if (size.size() == 1) return 2.0 * size[0];
    if (size[0] != size[1])
        deck.fail(line.number, "gives a section of shape CIRC two thicknesses, " + line.words[0] + " and " +
                                   line.words[1] + ", which must be one diameter: no ellipse is understood");
    return size[0];
}

}  // namespace

Section deck_section(const InputDeck& deck, const std::string& shape, const Card::Line& line) {
    if (shape == "RECT") {  // sizes along n1, which is axis 3, and along n2
        const auto size = deck.numbers(line, {2, 2});
        return made_at(deck, line, [&] { return rectangle_section(size[1], size[0]); });
    }
    if (shape == "CIRC") {
        const double diameter = diameter_of(deck, line);
        return made_at(deck, line, [&] { return circle_section(diameter); });
    }
    if (shape == "PIPE") {  // outer radius and thickness
        const auto size = deck.numbers(line, {2, 2});
        return made_at(deck, line, [&] { return tube_section(2.0 * size[0], 2.0 * (size[0] - size[1])); });
    }
    if (shape == "GENERAL") {  // A, I11, I12, I22, J; I11 bends about n1
        const auto v = deck.numbers(line, {5, 5});
        if (v[2] != 0.0) deck.fail(line.number, "has a product of inertia, which must be zero");
        return {.area = v[0], .I2 = v[3], .I3 = v[1], .J = v[4]};
    }
    deck.fail(line.number,
              "belongs to a section of shape " + shape + "; RECT, CIRC, PIPE and GENERAL are understood");
}

}  // namespace fretwork::mechanics::decks
