// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/outlines/svg/css.hpp>

#include <pugixml.hpp>

#include <string>
#include <string_view>
#include <unordered_map>

namespace fretwork::outlines::detail {

class SvgDocument;

/// The style of one element, from style sheets, the attribute `style` and presentation attributes.
class SvgProperties {
  public:
    /// Charges the document for the element. Throws as CssRules::of() and SvgDocument::charge().
    SvgProperties(pugi::xml_node node, const SvgDocument& document);
    /// The value of a property by the cascade; empty if it is not set.
    [[nodiscard]] std::string_view find(std::string_view name) const;

  private:
    pugi::xml_node node_;
    std::vector<CssDeclaration> own_;
    std::vector<const CssDeclaration*> ascending_;
};

/// A drawing as XML, with its elements by id, its style sheets, and the places of elements for messages.
class SvgDocument {
  public:
    /// Throws InputError if the text is not XML, or not SVG, and as with_entities_replaced().
    SvgDocument(std::string source, std::string text);

    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] const CssRules& rules() const { return rules_; }
    /// The name of an SVG element without its prefix; empty for an element with another prefix.
    [[nodiscard]] std::string_view name_of(pugi::xml_node node) const;
    /// The element that `#id` or `url(#id)` refers to; null if the document has no such element.
    [[nodiscard]] pugi::xml_node referred(std::string_view reference) const;

    /// The place of an element in messages: "line 3, path 'rim'".
    [[nodiscard]] std::string place(pugi::xml_node node) const;
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const;
    /// Count characters or elements that are read at `node`. They are read again for every copy, so that the
    /// size of the file does not limit the work. Throws InputError after 200 million.
    void charge(pugi::xml_node node, std::size_t steps) const;
    /// Count the characters of an element's name and attributes.
    void charge(pugi::xml_node node) const;
    /// Read the value of an attribute or property. An error of the reader gets file, place and `name`.
    template <class Reader>
    auto read(pugi::xml_node node, std::string_view name, std::string_view value, Reader reader) const {
        try {
            return reader(value);
        } catch (const base::InputError& error) {
            fail(node, std::string(name) + ": " + error.what());
        }
    }

  private:
    void collect_ids_and_styles();

    std::string source_;
    std::string text_;
    pugi::xml_document document_;
    std::string prefix_;  // prefix of SVG's elements, with its colon
    std::unordered_map<std::string_view, pugi::xml_node> ids_;
    CssRules rules_;
    mutable std::size_t charged_ = 0;
};

}  // namespace fretwork::outlines::detail
