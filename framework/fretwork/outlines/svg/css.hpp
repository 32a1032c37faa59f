// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

/// Style sheets as far as they decide what a drawing fills (CSS 2.1 with the attribute selectors of level 3).
namespace fretwork::outlines::detail {

/// `fill: none !important`.
struct CssDeclaration {
    std::string name;   ///< in small letters
    std::string value;  ///< trimmed
    enum class Weight { Normal, Important } weight = Weight::Normal;
};

/// The inside of a `style` attribute or of a rule's braces. Unreadable declarations are ignored, as CSS
/// requires.
std::vector<CssDeclaration> parse_css_declarations(std::string_view text);

/// A part of a selector without space or sign in it, such as `path.rim#a[x="1"]`.
struct CssCompound {
    struct Attribute {
        std::string name;
        std::string sign;  ///< empty: it is there; otherwise =, ~=, |=, ^=, $=, *=
        std::string value;
    };
    char relation = ' ';                ///< to the compound before it: ' ', '>', '+', '~'
    std::string type;                   ///< empty: any
    std::vector<Attribute> attributes;  ///< classes and ids included
    enum class Place { Any, First, Last, Root } place = Place::Any;
};

struct CssSelector {
    std::vector<CssCompound> compounds;
    int specificity = 0;
};

/// All style sheets of a document.
class CssRules {
  public:
    /// Add the rules of one style sheet: those for all media and for screens.
    void add(std::string_view text);
    /// The declarations that apply to an element, the strongest last. `!important` is not considered.
    [[nodiscard]] std::vector<const CssDeclaration*> of(pugi::xml_node node) const;
    /// Selectors that are not understood, such as `:hover`; they apply to nothing.
    [[nodiscard]] int unknown_selectors() const { return unknown_selectors_; }

  private:
    struct Rule {
        CssSelector selector;
        std::size_t block;
    };
    void add_rule(std::string_view selectors, std::string_view block);
    void collect(const std::string& key, pugi::xml_node node, std::vector<const Rule*>& rules) const;

    std::vector<std::vector<CssDeclaration>> blocks_;
    std::vector<Rule> rules_;
    std::unordered_map<std::string, std::vector<std::size_t>>
        rules_by_key_;  // "#id", ".class", "type" or "*"
    int unknown_selectors_ = 0;
    mutable long looks_ = 0;
};

/// One selector of a list, without the commas; nothing if it has something that is not understood.
std::optional<CssSelector> parse_css_selector(std::string_view text);

/// Whether an element is chosen. Every compound that is looked at counts as one of `looks`. Throws InputError
/// after ten million of them.
bool matches(const CssSelector& selector, pugi::xml_node node, long& looks);

/// A colour of CSS as "#rrggbb", without its opacity: hexadecimal, rgb() and names; nothing for others.
std::optional<std::string> css_colour(std::string_view text);

}  // namespace fretwork::outlines::detail
