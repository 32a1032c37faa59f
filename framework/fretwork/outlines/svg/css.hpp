// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

/// Style sheets, as far as they affect the filled areas of a drawing (CSS 2.1 with the attribute selectors of
/// level 3).
namespace fretwork::outlines::detail {

/// A text without the space at its ends.
std::string_view trimmed(std::string_view text);

/// A declaration, such as `fill: none !important`.
struct CssDeclaration {
    std::string name;   ///< name of the property, in lower case
    std::string value;  ///< trimmed
    enum class Weight { Normal, Important } weight = Weight::Normal;
};

/// Parse the content of a `style` attribute or of the braces of a rule. Unreadable declarations are ignored,
/// as CSS requires.
std::vector<CssDeclaration> parse_css_declarations(std::string_view text);

/// A compound selector, which has no space or combinator, such as `path.rim#a[x="1"]`.
struct CssCompound {
    struct Attribute {
        std::string name;
        std::string sign;  ///< empty: the attribute exists; otherwise =, ~=, |=, ^=, $=, *=
        std::string value;
    };
    char relation = ' ';                ///< combinator with the previous compound: ' ', '>', '+', '~'
    std::string type;                   ///< element type; empty: any
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
    /// Add the rules of one style sheet that hold for all media or for screens. Rules with unsupported
    /// selectors, such as `:hover`, are left out.
    void add(std::string_view text);
    /// The declarations that apply to an element, the strongest last. `!important` is not considered. Throws
    /// as count_looks(); all calls share one count.
    [[nodiscard]] std::vector<const CssDeclaration*> of(pugi::xml_node node) const;

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
    mutable long looks_ = 0;
};

/// Parse one selector of a list, without the commas. Nothing if it contains something unsupported.
std::optional<CssSelector> parse_css_selector(std::string_view text);

/// Add the steps of choosing rules to `looks`. Throws InputError after ten million.
void count_looks(std::size_t steps, long& looks);

/// True if the selector matches an element. Its steps are counted; throws as count_looks().
bool matches(const CssSelector& selector, pugi::xml_node node, long& looks);

/// A CSS colour as "#rrggbb", without its opacity. Hexadecimal colours, rgb() and names are supported.
/// Nothing for other colours.
std::optional<std::string> css_colour(std::string_view text);

}  // namespace fretwork::outlines::detail
