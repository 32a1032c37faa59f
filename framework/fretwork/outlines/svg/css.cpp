// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/svg/css.hpp>

#include <algorithm>
#include <cctype>

namespace fretwork::outlines::detail {
namespace {

/// A sheet without /* comments */ and without the <!-- --> that hide it from old programs.
std::string without_comments(std::string_view text) {
    std::string kept;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find("/*"), text.size());
        kept += text.substr(0, begin);
        const std::size_t end = text.find("*/", std::min(begin + 2, text.size()));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
    for (const std::string_view mark : {"<!--", "-->"})
        for (auto at = kept.find(mark); at != std::string::npos; at = kept.find(mark, at))
            kept.replace(at, mark.size(), mark.size(), ' ');
    return kept;
}

/// The position after the closing brace of a block that begins with a brace.
std::size_t end_of_block(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i + 1;
    }
    return text.size();
}

/// True for "@media" with the media that a picture is shown on.
bool is_for_screens(std::string_view head) {
    constexpr std::string_view kMedia = "@media";
    if (!head.starts_with(kMedia)) return false;
    const std::string_view media = trimmed(head.substr(kMedia.size()));
    return media == "all" || media == "screen" || media.empty();
}

CssDeclaration declaration_of(std::string_view name, std::string_view value) {
    CssDeclaration declaration{base::in_small_letters(trimmed(name)), std::string(trimmed(value))};
    const std::size_t mark = declaration.value.rfind('!');
    if (mark != std::string::npos &&
        trimmed(std::string_view(declaration.value).substr(mark + 1)) == "important") {
        declaration.value = std::string(trimmed(std::string_view(declaration.value).substr(0, mark)));
        declaration.weight = CssDeclaration::Weight::Important;
    }
    return declaration;
}

/// The key under which a rule is stored: the most selective word of its last compound.
std::string key_of(const CssSelector& selector) {
    const CssCompound& last = selector.compounds.back();
    for (const auto& attribute : last.attributes)
        if (attribute.name == "id" && attribute.sign == "=") return "#" + attribute.value;
    for (const auto& attribute : last.attributes)
        if (attribute.name == "class" && attribute.sign == "~=") return "." + attribute.value;
    return last.type.empty() ? "*" : last.type;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n\f";
    const auto first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<CssDeclaration> parse_css_declarations(std::string_view text) {
    const std::string plain = without_comments(text);
    std::vector<CssDeclaration> declarations;
    for (std::string_view rest = plain; !rest.empty();) {
        const std::size_t end = base::find_outside(rest, ';');
        const std::string_view one = rest.substr(0, end);
        const std::size_t colon = one.find(':');
        if (colon != std::string_view::npos)
            declarations.push_back(declaration_of(one.substr(0, colon), one.substr(colon + 1)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return declarations;
}

void CssRules::add(std::string_view text) {
    const std::string plain = without_comments(text);
    // The number of @media blocks around this place. Those for screens are entered, not cut out, so that the
    // text is read once however deep they lie in one another.
    int open = 0;
    for (std::string_view sheet = trimmed(plain); !sheet.empty(); sheet = trimmed(sheet)) {
        std::string ends = "{";
        if (open > 0) ends += '}';
        if (sheet.front() == '@') ends += ';';  // such as @import
        const std::size_t end = sheet.find_first_of(ends);
        if (end == std::string_view::npos) return;
        const std::string_view head = trimmed(sheet.substr(0, end));
        const char found = sheet[end];
        sheet.remove_prefix(end);
        if (found == '{' && !is_for_screens(head)) {
            std::string_view inside = sheet.substr(0, end_of_block(sheet));
            sheet.remove_prefix(inside.size());
            inside.remove_prefix(1);
            if (inside.ends_with('}')) inside.remove_suffix(1);
            if (!head.starts_with('@')) add_rule(head, inside);
            continue;
        }
        sheet.remove_prefix(1);
        if (found == '{') ++open;
        if (found == '}') --open;
    }
}

void CssRules::add_rule(std::string_view selectors, std::string_view block) {
    blocks_.push_back(parse_css_declarations(block));
    while (!selectors.empty()) {
        const std::size_t end = base::find_outside(selectors, ',');
        if (auto selector = parse_css_selector(selectors.substr(0, end))) {
            rules_by_key_[key_of(*selector)].push_back(rules_.size());
            rules_.push_back({std::move(*selector), blocks_.size() - 1});
        }
        selectors.remove_prefix(std::min(end + 1, selectors.size()));
    }
}

void CssRules::collect(const std::string& key, pugi::xml_node node, std::vector<const Rule*>& rules) const {
    const auto found = rules_by_key_.find(key);
    if (found == rules_by_key_.end()) return;
    for (const std::size_t rule : found->second)
        if (matches(rules_[rule].selector, node, looks_)) rules.push_back(&rules_[rule]);
}

std::vector<const CssDeclaration*> CssRules::of(pugi::xml_node node) const {
    if (rules_.empty()) return {};
    std::vector<const Rule*> rules;
    collect("*", node, rules);
    const std::string_view name = node.name();
    collect(std::string(name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1)), node,
            rules);
    if (const std::string id = node.attribute("id").value(); !id.empty()) collect("#" + id, node, rules);
    std::string classes = node.attribute("class").value();
    std::ranges::replace_if(
        classes, [](unsigned char c) { return std::isspace(c); }, ' ');
    for (const std::string& word : base::split(classes, ' '))
        if (!word.empty()) collect("." + word, node, rules);
    std::ranges::sort(rules, [](const Rule* a, const Rule* b) {
        return a->selector.specificity != b->selector.specificity
                   ? a->selector.specificity < b->selector.specificity
                   : a < b;
    });
    // Declarations are read much faster than selectors are compared: browsers write all 300 properties.
    constexpr std::size_t kReadPerLook = 128;
    constexpr std::size_t kOfADeclaration = 32;
    std::vector<const CssDeclaration*> declarations;
    for (const Rule* rule : rules) {
        std::size_t characters = 0;
        for (const CssDeclaration& declaration : blocks_[rule->block]) {
            characters += kOfADeclaration + declaration.value.size();
            declarations.push_back(&declaration);
        }
        count_looks(characters / kReadPerLook, looks_);
    }
    return declarations;
}

}  // namespace fretwork::outlines::detail
