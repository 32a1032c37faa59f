// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/svg/xml_entities.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace fretwork::outlines::detail {
namespace {

/// The factor by which a document may grow; a short document may grow a little more.
constexpr std::size_t kMostGrowth = 10;
constexpr std::size_t kLittle = 100'000;
constexpr int kDeepestEntity = 16;  // depth of entities in entities
/// Ten replacements for each element that a drawing may have. They are counted because some add no text.
constexpr int kMostReplacements = 2'000'000;
constexpr std::size_t kLongestEntityName = 256;  // with its '&'; programs write short ones

constexpr std::string_view kSpace = " \t\r\n";

using Entities = std::map<std::string, std::string, std::less<>>;

std::string_view without_leading_space(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(kSpace), text.size()));
}

/// The quoted text at the beginning of a text; nothing if there is none.
std::optional<std::string_view> quoted(std::string_view text) {
    if (text.empty() || (text.front() != '"' && text.front() != '\'')) return std::nullopt;
    const std::size_t end = text.find(text.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    return text.substr(1, end - 1);
}

/// The entities that a document declares: <!ENTITY name "value">.
Entities declared_in(std::string_view doctype) {
    constexpr std::string_view kBegin = "<!ENTITY";
    Entities entities;
    for (auto at = doctype.find(kBegin); at != std::string_view::npos; at = doctype.find(kBegin, at + 1)) {
        const std::string_view rest = without_leading_space(doctype.substr(at + kBegin.size()));
        const std::size_t end = rest.substr(0, kLongestEntityName).find_first_of(kSpace);
        if (end == std::string_view::npos) continue;
        const std::string_view name = rest.substr(0, end);
        const auto value = quoted(without_leading_space(rest.substr(name.size())));
        if (!value || name == "%") continue;
        std::string in_one_line(*value);
        std::ranges::replace(in_one_line, '\n', ' ');
        entities.emplace(name, std::move(in_one_line));  // the first declaration of a name is valid
    }
    return entities;
}

class Replacer {
  public:
    Replacer(const Entities& entities, std::size_t most) : entities_(entities), most_(most) {}

    [[nodiscard]] std::string run(std::string_view text) {
        add(text, 0);
        return std::move(done_);
    }

  private:
    void add(std::string_view text, int depth) {
        if (depth > kDeepestEntity)
            throw base::InputError("entities of the document contain one another too deeply");
        while (!text.empty()) {
            const std::size_t mark = std::min(text.find('&'), text.size());
            append(text.substr(0, mark));
            text.remove_prefix(mark);
            if (text.empty()) return;
            const std::size_t end = text.substr(0, kLongestEntityName).find(';');
            const auto found =
                end == std::string_view::npos ? entities_.end() : entities_.find(text.substr(1, end - 1));
            if (found == entities_.end()) {
                append(text.substr(0, 1));
                text.remove_prefix(1);
            } else {
                if (++replacements_ > kMostReplacements)
                    throw base::InputError("more than " + std::to_string(kMostReplacements) +
                                           " entities of the document are to be replaced");
                add(found->second, depth + 1);
                text.remove_prefix(end + 1);
            }
        }
    }
    void append(std::string_view text) {
        done_ += text;
        if (done_.size() > most_)
            throw base::InputError("entities let the document grow beyond " + std::to_string(most_) +
                                   " characters");
    }

    const Entities& entities_;
    std::size_t most_;
    int replacements_ = 0;
    std::string done_;
};

}  // namespace

std::string with_entities_replaced(std::string text) {
    const std::size_t begin = text.find("<!DOCTYPE");
    if (begin == std::string::npos) return text;
    const std::size_t bracket = text.find_first_of("[>", begin);
    if (bracket == std::string::npos || text[bracket] == '>') return text;
    const std::size_t end = text.find(']', bracket);
    if (end == std::string::npos) return text;
    const std::string_view all(text);
    const Entities entities = declared_in(all.substr(bracket, end - bracket));
    if (entities.empty()) return text;
    return text.substr(0, end) + Replacer(entities, kMostGrowth * text.size() + kLittle).run(all.substr(end));
}

}  // namespace fretwork::outlines::detail
