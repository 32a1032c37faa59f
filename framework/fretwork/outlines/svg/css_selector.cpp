// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/outlines/svg/css.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

constexpr long kMostLooks = 10'000'000;
constexpr std::size_t kCharactersPerLook = 16;  // compared characters of values: short ones cost nothing
constexpr std::size_t kNamesPerLook = 64;       // characters of names of attributes, which are passed fast
constexpr std::size_t kMostCompounds = 32;
/// The largest number of classes, ids and other conditions in a selector; selectors of programs have a few.
constexpr int kMostConditions = 100;
// Weights of specificity. An id weighs more than any number of classes, and a class more than any number of
// names.
constexpr int kId = 1'000'000;
constexpr int kClass = 1'000;
static_assert(kMostConditions * kClass < kId && kMostCompounds < kClass);

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

class SelectorParser {
  public:
    explicit SelectorParser(std::string_view text) : text_(text) {}

    std::optional<CssSelector> run() {
        skip_space();
        while (next_ < text_.size() && !has_failed_) {
            if (selector_.compounds.size() == kMostCompounds) return std::nullopt;
            read_compound();
        }
        if (has_failed_ || selector_.compounds.empty()) return std::nullopt;
        return std::move(selector_);
    }

  private:
    [[nodiscard]] char here() const { return next_ < text_.size() ? text_[next_] : '\0'; }
    void skip_space() {
        while (std::isspace(static_cast<unsigned char>(here()))) ++next_;
    }
    std::string name() {
        std::string word;
        for (; is_name(here()) || here() == '\\'; ++next_) {
            if (here() == '\\') ++next_;
            if (here() != '\0') word += here();
        }
        if (word.empty()) has_failed_ = true;
        return word;
    }

    void read_compound() {
        CssCompound compound;
        if (std::string_view(">+~").find(here()) != std::string_view::npos) {
            compound.relation = text_[next_++];
            skip_space();
        }
        const std::size_t first = next_;
        if (is_name(here())) {
            compound.type = name();
            selector_.specificity += 1;
        } else if (here() == '*') {
            ++next_;
        }
        while (!has_failed_ && std::string_view("#.[:").find(here()) != std::string_view::npos &&
               here() != '\0')
            read_condition(compound);
        if (next_ == first) has_failed_ = true;
        skip_space();
        selector_.compounds.push_back(std::move(compound));
    }

    void read_condition(CssCompound& compound) {
        const char sign = text_[next_++];
        if (++conditions_ > kMostConditions) {
            has_failed_ = true;
            return;
        }
        selector_.specificity += sign == '#' ? kId : kClass;
        if (sign == '#') return compound.attributes.push_back({"id", "=", name()});
        if (sign == '.') return compound.attributes.push_back({"class", "~=", name()});
        if (sign == '[') return read_attribute(compound);
        const std::string place = name();
        if (place == "first-child") {
            compound.place = CssCompound::Place::First;
        } else if (place == "last-child") {
            compound.place = CssCompound::Place::Last;
        } else if (place == "root") {
            compound.place = CssCompound::Place::Root;
        } else {
            has_failed_ = true;
        }
    }

    void read_attribute(CssCompound& compound) {
        const std::size_t end = text_.find(']', next_);
        if (end == std::string_view::npos) {
            has_failed_ = true;
            return;
        }
        CssCompound::Attribute attribute;
        skip_space();
        attribute.name = name();
        skip_space();
        while (next_ < end && std::string_view("~|^$*=").find(here()) != std::string_view::npos)
            attribute.sign += text_[next_++];
        const std::size_t first = std::min(next_, end);  // a name may go on behind the bracket
        for (const char c : trimmed(text_.substr(first, end - first)))
            if (c != '"' && c != '\'') attribute.value += c;
        next_ = end + 1;
        compound.attributes.push_back(std::move(attribute));
    }

    std::string_view text_;
    std::size_t next_ = 0;
    CssSelector selector_;
    int conditions_ = 0;
    bool has_failed_ = false;
};

bool has_word(std::string_view words, std::string_view word) {
    constexpr std::string_view kGaps = " \t\r\n\f\v";
    while (!words.empty()) {
        const std::size_t end = std::min(words.find_first_of(kGaps), words.size());
        if (end > 0 && words.substr(0, end) == word) return true;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

/// The value of an attribute; nothing if the element does not have it.
std::optional<std::string_view> value_of(std::string_view name, pugi::xml_node node, long& looks) {
    std::size_t characters = 0;
    std::optional<std::string_view> value;
    for (auto attribute = node.first_attribute(); attribute && !value;
         attribute = attribute.next_attribute()) {
        const std::string_view here = attribute.name();
        characters += here.size();
        if (here == name) value = attribute.value();
    }
    count_looks(characters / kNamesPerLook + value.value_or("").size() / kCharactersPerLook, looks);
    return value;
}

bool holds(const CssCompound::Attribute& wanted, pugi::xml_node node, long& looks) {
    const auto found = value_of(wanted.name, node, looks);
    if (!found) return false;
    const std::string_view value = *found;
    const std::string_view with = wanted.value;
    if (wanted.sign.empty()) return true;
    if (wanted.sign == "=") return value == with;
    if (wanted.sign == "~=") return has_word(value, with);
    if (wanted.sign == "|=")
        return value.starts_with(with) && (value.size() == with.size() || value[with.size()] == '-');
    if (with.empty()) return false;
    if (wanted.sign == "^=") return value.starts_with(with);
    if (wanted.sign == "$=") return value.ends_with(with);
    if (wanted.sign != "*=") return false;
    count_looks(value.size() * with.size() / kCharactersPerLook, looks);  // at most so many comparisons
    return value.find(with) != std::string_view::npos;
}

pugi::xml_node element_before(pugi::xml_node node, long& looks) {
    do {
        node = node.previous_sibling();
        count_looks(1, looks);
    } while (node && node.type() != pugi::node_element);
    return node;
}
pugi::xml_node element_after(pugi::xml_node node, long& looks) {
    do {
        node = node.next_sibling();
        count_looks(1, looks);
    } while (node && node.type() != pugi::node_element);
    return node;
}

bool is_at(CssCompound::Place place, pugi::xml_node node, long& looks) {
    switch (place) {
        case CssCompound::Place::Any:
            return true;
        case CssCompound::Place::First:
            return !element_before(node, looks);
        case CssCompound::Place::Last:
            return !element_after(node, looks);
        case CssCompound::Place::Root:
            return node.parent().type() == pugi::node_document;
    }
    return false;
}

bool is_chosen(const CssCompound& compound, pugi::xml_node node, long& looks) {
    std::string_view name = node.name();
    count_looks(1 + name.size() / kNamesPerLook, looks);
    name = name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
    return (compound.type.empty() || compound.type == name) && is_at(compound.place, node, looks) &&
           std::ranges::all_of(compound.attributes,
                               [&](const auto& wanted) { return holds(wanted, node, looks); });
}

/// True if the compounds 0 .. last match, with compound `last` on the element.
bool matches_up_to(const CssSelector& selector, std::size_t last, pugi::xml_node node, long& looks) {
    if (node.type() != pugi::node_element || !is_chosen(selector.compounds[last], node, looks)) return false;
    if (last == 0) return true;
    const auto is_before = [&](pugi::xml_node other) {
        return matches_up_to(selector, last - 1, other, looks);
    };
    switch (selector.compounds[last].relation) {
        case '>':
            return is_before(node.parent());
        case '+':
            return is_before(element_before(node, looks));
        case '~':
            for (auto other = element_before(node, looks); other; other = element_before(other, looks))
                if (is_before(other)) return true;
            return false;
        default:
            for (auto other = node.parent(); other; other = other.parent())
                if (is_before(other)) return true;
            return false;
    }
}

}  // namespace

void count_looks(std::size_t steps, long& looks) {
    if (steps > static_cast<std::size_t>(kMostLooks - looks))
        throw base::InputError("its style sheets are too intricate");
    looks += static_cast<long>(steps);
}

std::optional<CssSelector> parse_css_selector(std::string_view text) {
    return SelectorParser(text).run();
}

bool matches(const CssSelector& selector, pugi::xml_node node, long& looks) {
    return matches_up_to(selector, selector.compounds.size() - 1, node, looks);
}

}  // namespace fretwork::outlines::detail
