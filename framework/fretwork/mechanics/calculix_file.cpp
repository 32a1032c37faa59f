// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/calculix_file.hpp>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <set>

namespace fretwork::mechanics {
namespace {

using Words = std::vector<std::string>;

std::string trimmed_upper(std::string_view word) {
    std::string result;
    for (const char c : word) {
        if (c != ' ' && c != '\t' && c != '\r')
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return result;
}

/// A keyword, its parameters, and the data lines under it.
struct Card {
    std::string keyword;
    std::map<std::string, std::string> parameters;
    std::vector<std::pair<std::size_t, Words>> lines;  ///< with their numbers in the file
    std::size_t line = 0;
};

class Deck {
  public:
    explicit Deck(const std::filesystem::path& path) : path_(path.string()) {
        const auto lines = base::split(base::read_text_file(path), '\n');
        bool continues = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string line = trimmed_upper(lines[i]);
            if (line.empty() || line.starts_with("**")) continue;
            Words words = base::split(line, ',');
            if (line.starts_with("*")) {
                cards_.push_back(card_of(words, i + 1));
            } else if (cards_.empty()) {
                fail(i + 1, "stands before the first keyword");
            } else {
                const bool goes_on = words.back().empty() && words.size() > 1;
                if (goes_on) words.pop_back();
                if (continues) {
                    auto& last = cards_.back().lines.back().second;
                    last.insert(last.end(), words.begin(), words.end());
                } else {
                    cards_.back().lines.emplace_back(i + 1, words);
                }
                // Only lists of nodes go on; elsewhere a last comma is an empty value.
                continues = goes_on && cards_.back().keyword == "*ELEMENT";
            }
        }
    }

    [[nodiscard]] const std::vector<Card>& cards() const { return cards_; }

    [[noreturn]] void fail(std::size_t line, const std::string& message) const {
        throw base::InputError(path_ + ": line " + std::to_string(line) + " " + message);
    }

    [[nodiscard]] double number(std::size_t line, const std::string& word) const {
        const auto value = base::read_number<double>(word);
        if (!value || !std::isfinite(*value)) fail(line, "has '" + word + "' where a number is needed");
        return *value;
    }

    [[nodiscard]] int integer(std::size_t line, const std::string& word) const {
        if (const auto value = base::read_number<int>(word)) return *value;
        fail(line, "has '" + word + "' where a whole number is needed");
    }

    [[nodiscard]] std::vector<double> numbers(std::size_t line, const Words& words,
                                              std::size_t at_least) const {
        std::vector<double> values;
        for (const std::string& word : words) {
            if (!word.empty()) values.push_back(number(line, word));
        }
        if (values.size() < at_least)
            fail(line, "has " + std::to_string(values.size()) + " numbers, where " +
                           std::to_string(at_least) + " are needed");
        return values;
    }

    [[nodiscard]] const std::string& parameter(const Card& card, const std::string& name) const {
        const auto found = card.parameters.find(name);
        if (found == card.parameters.end())
            fail(card.line, "(" + card.keyword + ") needs the parameter " + name);
        return found->second;
    }

  private:
    static Card card_of(const Words& words, std::size_t line) {
        Card card{words[0], {}, {}, line};
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto equals = words[i].find('=');
            card.parameters[words[i].substr(0, equals)] =
                equals == std::string::npos ? "" : words[i].substr(equals + 1);
        }
        return card;
    }

    std::string path_;
    std::vector<Card> cards_;
};

const std::set<std::string> kPassedOver = {
    "*HEADING", "*STEP",    "*STATIC",     "*ENDSTEP",       "*NODEFILE",    "*ELFILE",      "*NODEPRINT",
    "*ELPRINT", "*OUTPUT",  "*NODEOUTPUT", "*ELEMENTOUTPUT", "*CONTROLS",    "*RESTART",     "*PREPRINT",
    "*PART",    "*ENDPART", "*ASSEMBLY",   "*ENDASSEMBLY",   "*CONTACTFILE", "*SOLIDSECTION"};

class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : deck_(path) {}

    LabelledFrame run() {
        for (const Card& card : deck_.cards()) read(card);
        for (const auto& [label, element] : elements_) add_beams(label, element);
        validate(result_.frame);
        return std::move(result_);
    }

  private:
    struct ElementData {
        std::vector<NodeIndex> nodes;
        std::size_t line = 0;
        const Section* section = nullptr;
        std::string material;
        std::optional<Eigen::Vector3d> normal{};
    };

    void read(const Card& card) {
        if (card.keyword == "*NODE") return read_nodes(card);
        if (card.keyword == "*ELEMENT") return read_elements(card);
        if (card.keyword == "*NSET") return read_set(card, deck_.parameter(card, "NSET"), node_sets_);
        if (card.keyword == "*ELSET") return read_set(card, deck_.parameter(card, "ELSET"), element_sets_);
        if (card.keyword == "*MATERIAL") {
            material_ = &materials_[deck_.parameter(card, "NAME")];
            return;
        }
        if (card.keyword == "*ELASTIC" || card.keyword == "*DENSITY") return read_property(card);
        if (card.keyword == "*BEAMSECTION" || card.keyword == "*BEAMGENERALSECTION")
            return read_section(card);
        if (card.keyword == "*BOUNDARY") return read_boundary(card);
        if (card.keyword == "*CLOAD") return read_loads(card);
        if (card.keyword == "*DLOAD") return read_gravity(card);
        if (!kPassedOver.contains(card.keyword))
            deck_.fail(card.line,
                       "has " + card.keyword +
                           ", which is not understood: beams, their sections, materials, supports, "
                           "nodal loads and gravity are");
    }

    void read_nodes(const Card& card) {
        for (const auto& [line, words] : card.lines) {
            if (words.size() < 2) deck_.fail(line, "is no node: a label and coordinates are needed");
            const int label = deck_.integer(line, words[0]);
            Eigen::Vector3d position = Eigen::Vector3d::Zero();
            for (std::size_t i = 1; i < std::min<std::size_t>(words.size(), 4); ++i)
                position[static_cast<Eigen::Index>(i) - 1] =
                    words[i].empty() ? 0.0 : deck_.number(line, words[i]);
            if (!nodes_.emplace(label, NodeIndex(result_.frame.nodes.size())).second)
                deck_.fail(line, "gives node " + words[0] + " a second time");
            result_.frame.nodes.push_back(position);
            result_.labels.push_back(label);
            node_sets_["NALL"].push_back(label);
            if (const auto set = card.parameters.find("NSET"); set != card.parameters.end())
                node_sets_[set->second].push_back(label);
        }
    }

    [[nodiscard]] NodeIndex node(std::size_t line, const std::string& word) const {
        const auto found = nodes_.find(deck_.integer(line, word));
        if (found == nodes_.end()) deck_.fail(line, "names node " + word + ", which there is not");
        return found->second;
    }

    void read_elements(const Card& card) {
        const std::string& type = deck_.parameter(card, "TYPE");
        const bool two = type == "B31" || type == "B31R" || type == "B33";
        if (!two && type != "B32" && type != "B32R")
            deck_.fail(card.line,
                       "has elements of type " + type + "; B31, B31R, B32, B32R and B33 are understood");
        const std::size_t count = two ? 2 : 3;
        for (const auto& [line, words] : card.lines) {
            if (words.size() < count + 1)
                deck_.fail(line, "is no element of type " + type + ": a label and " + std::to_string(count) +
                                     " nodes are needed");
            ElementData element;
            element.line = line;
            for (std::size_t i = 1; i <= count; ++i) element.nodes.push_back(node(line, words[i]));
            const int label = deck_.integer(line, words[0]);
            if (!elements_.emplace(label, element).second)
                deck_.fail(line, "gives element " + words[0] + " a second time");
            element_sets_["EALL"].push_back(label);
            if (const auto set = card.parameters.find("ELSET"); set != card.parameters.end())
                element_sets_[set->second].push_back(label);
        }
    }

    using Sets = std::map<std::string, std::vector<int>>;

    void read_set(const Card& card, const std::string& name, Sets& sets) {
        std::vector<int> members = sets[name];
        for (const auto& [line, words] : card.lines) {
            if (card.parameters.contains("GENERATE")) {
                if (words.size() < 2) deck_.fail(line, "needs a first and a last label");
                const int step = words.size() > 2 && !words[2].empty() ? deck_.integer(line, words[2]) : 1;
                if (step < 1)
                    deck_.fail(line, "steps by " + std::to_string(step) + ", and must step forward");
                for (int i = deck_.integer(line, words[0]); i <= deck_.integer(line, words[1]); i += step)
                    members.push_back(i);
                continue;
            }
            for (const std::string& word : words) {
                if (word.empty()) continue;
                const auto inner = sets.find(word);
                if (inner == sets.end())
                    members.push_back(deck_.integer(line, word));
                else
                    members.insert(members.end(), inner->second.begin(), inner->second.end());
            }
        }
        sets[name] = members;
    }

    void read_property(const Card& card) {
        if (material_ == nullptr) deck_.fail(card.line, "(" + card.keyword + ") belongs to no *MATERIAL");
        if (card.lines.empty()) deck_.fail(card.line, "(" + card.keyword + ") has no values");
        const auto& [line, words] = card.lines.front();
        if (card.keyword == "*DENSITY") {
            material_->density = deck_.numbers(line, words, 1)[0];
            return;
        }
        const std::vector<double> values = deck_.numbers(line, words, 2);
        material_->young_modulus = values[0];
        material_->poisson_ratio = values[1];
    }

    void read_section(const Card& card) {
        const std::string& shape = deck_.parameter(card, "SECTION");
        if (card.lines.empty()) deck_.fail(card.line, "(" + card.keyword + ") has no dimensions");
        const auto& [line, words] = card.lines.front();
        const Section& section = sections_.emplace_back(section_of(shape, line, words));
        std::optional<Eigen::Vector3d> normal = Eigen::Vector3d(0.0, 0.0, -1.0);  // as CalculiX
        if (card.lines.size() > 1) {
            const auto n = deck_.numbers(card.lines[1].first, card.lines[1].second, 3);
            normal = Eigen::Vector3d(n[0], n[1], n[2]);
        }
        const std::string& set = deck_.parameter(card, "ELSET");
        const auto members = element_sets_.find(set);
        if (members == element_sets_.end())
            deck_.fail(card.line, "names the element set " + set + ", which there is not");
        for (const int label : members->second) {
            const auto element = elements_.find(label);
            if (element == elements_.end())
                deck_.fail(card.line, "needs element " + std::to_string(label) + ", which there is not");
            element->second.section = &section;
            element->second.material = deck_.parameter(card, "MATERIAL");
            element->second.normal = normal;
        }
    }

    [[nodiscard]] Section section_of(const std::string& shape, std::size_t line, const Words& words) const {
        if (shape == "RECT") {  // along n1, which is axis 3, and along n2
            const auto size = deck_.numbers(line, words, 2);
            return rectangle_section(size[1], size[0]);
        }
        if (shape == "CIRC") return circle_section(deck_.numbers(line, words, 1)[0] * 2.0);
        if (shape == "PIPE") {  // outer radius and thickness
            const auto size = deck_.numbers(line, words, 2);
            return tube_section(2.0 * size[0], 2.0 * (size[0] - size[1]));
        }
        if (shape == "GENERAL") {  // A, I11, I12, I22, J; I11 bends about n1
            const auto v = deck_.numbers(line, words, 5);
            if (v[2] != 0.0) deck_.fail(line, "has a product of inertia, which must be zero");
            return {.area = v[0], .I2 = v[3], .I3 = v[1], .J = v[4]};
        }
        deck_.fail(
            line, "belongs to a section of shape " + shape + "; RECT, CIRC, PIPE and GENERAL are understood");
    }

    [[nodiscard]] std::vector<NodeIndex> nodes_named(std::size_t line, const std::string& word) const {
        const auto set = node_sets_.find(word);
        if (set == node_sets_.end()) return {node(line, word)};
        std::vector<NodeIndex> nodes;
        for (const int label : set->second) nodes.push_back(node(line, std::to_string(label)));
        return nodes;
    }

    [[nodiscard]] int dof(std::size_t line, const std::string& word) const {
        const int dof = deck_.integer(line, word);
        if (dof < 1 || dof > kDofsPerNode)
            deck_.fail(line, "has degree of freedom " + word + ", where 1 to 6 are");
        return dof - 1;
    }

    void read_boundary(const Card& card) {
        for (const auto& [line, words] : card.lines) {
            if (words.size() < 2) deck_.fail(line, "needs a node or set and a degree of freedom");
            const bool encastre = words[1] == "ENCASTRE";
            const int first = encastre ? 0 : words[1] == "PINNED" ? 0 : dof(line, words[1]);
            const int last = encastre                                ? 5
                             : words[1] == "PINNED"                  ? 2
                             : words.size() > 2 && !words[2].empty() ? dof(line, words[2])
                                                                     : first;
            const double value = words.size() > 3 && !words[3].empty() ? deck_.number(line, words[3]) : 0.0;
            for (const NodeIndex index : nodes_named(line, words[0])) {
                DofSet fixed;
                for (int d = first; d <= last; ++d) {
                    if (value != 0.0)
                        result_.frame.prescribed.push_back({index, static_cast<Dof>(d), value});
                    else
                        fixed.contains[static_cast<std::size_t>(d)] = true;
                }
                if (value == 0.0) result_.frame.supports.push_back({index, fixed});
            }
        }
    }

    void read_loads(const Card& card) {
        for (const auto& [line, words] : card.lines) {
            if (words.size() < 3) deck_.fail(line, "needs a node or set, a degree of freedom and a value");
            const int d = dof(line, words[1]);
            for (const NodeIndex index : nodes_named(line, words[0])) {
                NodalLoad load{index};
                (d < 3 ? load.force : load.moment)[d % 3] = deck_.number(line, words[2]);
                result_.frame.loads.push_back(load);
            }
        }
    }

    void read_gravity(const Card& card) {
        for (const auto& [line, words] : card.lines) {
            if (words.size() < 6 || words[1] != "GRAV")
                deck_.fail(
                    line,
                    "is no gravity (SET,GRAV,value,direction): other distributed loads are not understood");
            if (words[0] != "EALL" && element_sets_[words[0]].size() != elements_.size())
                deck_.fail(line, "lets gravity act on a part of the beams; it must act on all of them");
            result_.frame.gravity =
                deck_.number(line, words[2]) * Eigen::Vector3d(deck_.number(line, words[3]),
                                                               deck_.number(line, words[4]),
                                                               deck_.number(line, words[5]));
        }
    }

    void add_beams(int label, const ElementData& element) {
        if (element.section == nullptr)
            deck_.fail(element.line, "gives element " + std::to_string(label) + ", which has no section");
        const auto material = materials_.find(element.material);
        if (material == materials_.end())
            deck_.fail(element.line, "gives element " + std::to_string(label) + " of the material " +
                                         element.material + ", which there is not");
        for (std::size_t i = 1; i < element.nodes.size(); ++i)
            result_.frame.beams.push_back({.nodes = {element.nodes[i - 1], element.nodes[i]},
                                           .section = *element.section,
                                           .material = material->second,
                                           .normal = element.normal});
    }

    Deck deck_;
    LabelledFrame result_;
    std::map<int, NodeIndex> nodes_;
    std::map<int, ElementData> elements_;
    Sets node_sets_, element_sets_;
    std::map<std::string, Material> materials_;
    Material* material_ = nullptr;
    std::list<Section> sections_;
};

}  // namespace

LabelledFrame read_calculix(const std::filesystem::path& path) {
    return Reader(path).run();
}

}  // namespace fretwork::mechanics
