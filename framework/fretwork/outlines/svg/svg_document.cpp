// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/svg/svg_document.hpp>
#include <fretwork/outlines/svg/xml_entities.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

constexpr std::size_t kLongestName = 60;
/// A drawing has at most 200,000 elements, with all copies: a thousand characters for each of them.
constexpr std::size_t kMostCharged = 200'000'000;

std::string line_of(std::string_view text, std::ptrdiff_t offset) {
    const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, text.size());
    return "line " + std::to_string(std::count(text.begin(), end, '\n') + 1);
}

std::string for_message(std::string_view name) {
    return base::shortened(base::printable(name), kLongestName);
}

std::string text_in(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node child : node.children()) text += child.value();
    return text;
}

std::string replaced(const std::string& source, std::string text) {
    return base::located(source, "", [&] { return with_entities_replaced(std::move(text)); });
}

/// Visits every element in the order of the file.
struct Elements : pugi::xml_tree_walker {
    std::vector<pugi::xml_node> found;
    bool for_each(pugi::xml_node& node) override {
        if (node.type() == pugi::node_element) found.push_back(node);
        return true;
    }
};

}  // namespace

SvgProperties::SvgProperties(pugi::xml_node node, const SvgDocument& document) : node_(node) {
    document.charge(node);
    own_ = parse_css_declarations(node.attribute("style").value());
    ascending_ = document.rules().of(node);
    for (const CssDeclaration& declaration : own_) ascending_.push_back(&declaration);
    std::ranges::stable_sort(ascending_, {},
                             [](const CssDeclaration* declaration) { return declaration->weight; });
}

std::string_view SvgProperties::find(std::string_view name) const {
    for (auto declaration = ascending_.rbegin(); declaration != ascending_.rend(); ++declaration)
        if ((*declaration)->name == name) return (*declaration)->value;
    return node_.attribute(std::string(name).c_str()).value();
}

SvgDocument::SvgDocument(std::string source, std::string text)
    : source_(std::move(source)), text_(replaced(source_, std::move(text))) {
    const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed)
        throw base::InputError(source_, line_of(text_, parsed.offset),
                               std::string("malformed XML: ") + parsed.description());
    const std::string_view name = root().name();
    const std::size_t colon = name.find(':');
    if (colon != std::string_view::npos) prefix_ = name.substr(0, colon + 1);
    if (name.substr(prefix_.size()) != "svg")
        throw base::InputError(source_, place(root()),
                               "the document is no SVG drawing: its root is not 'svg'");
    collect_ids_and_styles();
}

std::string_view SvgDocument::name_of(pugi::xml_node node) const {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos) return name;
    const std::string_view prefix = name.substr(0, colon + 1);
    return prefix == prefix_ || prefix == "svg:" ? name.substr(colon + 1) : std::string_view();
}

void SvgDocument::collect_ids_and_styles() {
    Elements elements;
    document_.traverse(elements);
    for (const pugi::xml_node node : elements.found) {
        if (const std::string_view id = node.attribute("id").value(); !id.empty()) ids_.emplace(id, node);
        if (name_of(node) != "style") continue;
        const std::string_view media = node.attribute("media").value();
        if (media.empty() || media == "all" || media == "screen") rules_.add(text_in(node));
    }
}

pugi::xml_node SvgDocument::referred(std::string_view reference) const {
    if (reference.starts_with("url(")) {
        reference.remove_prefix(4);
        reference = reference.substr(0, reference.find(')'));
        while (!reference.empty() &&
               std::string_view(" '\"").find(reference.front()) != std::string_view::npos)
            reference.remove_prefix(1);
        while (!reference.empty() &&
               std::string_view(" '\"").find(reference.back()) != std::string_view::npos)
            reference.remove_suffix(1);
    }
    if (!reference.starts_with('#')) return {};
    const auto found = ids_.find(reference.substr(1));
    return found == ids_.end() ? pugi::xml_node() : found->second;
}

std::string SvgDocument::place(pugi::xml_node node) const {
    const std::string_view name = name_of(node);
    const std::string id = node.attribute("id").value();
    return line_of(text_, node.offset_debug()) + ", " + for_message(name.empty() ? node.name() : name) +
           (id.empty() ? "" : " '" + for_message(id) + "'");
}

void SvgDocument::charge(pugi::xml_node node, std::size_t steps) const {
    charged_ += steps;
    if (charged_ > kMostCharged)
        fail(node, "with all copies, more than " + std::to_string(kMostCharged) +
                       " characters of elements are read; copy simpler elements");
}

void SvgDocument::charge(pugi::xml_node node) const {
    const bool is_image = name_of(node) == "image";
    std::size_t characters = std::string_view(node.name()).size();
    for (const pugi::xml_attribute attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        characters += name.size();
        // The picture in an image, which may have megabytes, is not read.
        if (!is_image || !name.ends_with("href")) characters += std::string_view(attribute.value()).size();
    }
    charge(node, characters);
}

void SvgDocument::fail(pugi::xml_node node, const std::string& message) const {
    throw base::InputError(source_, place(node), message);
}

}  // namespace fretwork::outlines::detail
