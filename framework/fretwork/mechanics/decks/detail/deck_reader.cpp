// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/decks/detail/deck_history.hpp>
#include <fretwork/mechanics/decks/detail/deck_reader.hpp>
#include <fretwork/mechanics/decks/detail/deck_section.hpp>
#include <fretwork/mechanics/decks/detail/input_deck.hpp>
#include <fretwork/mechanics/decks/detail/label_sets.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>

#include <algorithm>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::mechanics::decks {
namespace {

const std::set<std::string> kPassedOver = {
    "*HEADING", "*STATIC",     "*ENDSTEP",       "*NODEFILE",    "*ELFILE",      "*NODEPRINT", "*ELPRINT",
    "*OUTPUT",  "*NODEOUTPUT", "*ELEMENTOUTPUT", "*CONTROLS",    "*RESTART",     "*PREPRINT",  "*PART",
    "*ENDPART", "*ASSEMBLY",   "*ENDASSEMBLY",   "*CONTACTFILE", "*SOLIDSECTION"};

class Reader {
  public:
    explicit Reader(InputDeck deck) : deck_(std::move(deck)) {}

    LabelledFrame run() {
        for (const Card& card : deck_.cards()) read(card);
        check_complete();
        check_pulled();
        for (const auto& [label, element] : elements_) add_beams(label, element);
        history_.put_into(result_.frame);
        result_.source = deck_.source();
        detail::check_frame(result_.frame, {deck_.source(), result_.labels, beam_labels_});
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
        if (card.keyword == "*NSET") return node_sets_.read(deck_, card);
        if (card.keyword == "*ELSET") return element_sets_.read(deck_, card);
        if (card.keyword == "*MATERIAL") return read_material(card);
        if (card.keyword == "*ELASTIC") return read_elastic(card);
        if (card.keyword == "*DENSITY") return read_density(card);
        if (card.keyword == "*BEAMSECTION" || card.keyword == "*BEAMGENERALSECTION")
            return read_section(card);
        if (card.keyword == "*STEP") return begin_step(card);
        if (card.keyword == "*BOUNDARY") return read_boundary(card);
        if (card.keyword == "*CLOAD") return read_loads(card);
        if (card.keyword == "*DLOAD") return read_gravity(card);
        if (!kPassedOver.contains(card.keyword))
            deck_.fail(card.line,
                       "has " + card.keyword +
                           ", which is not understood: beams, their sections, materials, supports, "
                           "nodal loads and gravity are");
    }

    void check_complete() const {
        if (nodes_.empty())
            throw base::InputError(deck_.source(), "",
                                   "has no node: *NODE and a line for each node are missing");
        if (elements_.empty())
            throw base::InputError(deck_.source(), "",
                                   "has no element: *ELEMENT and a line for each element are missing");
    }

    [[nodiscard]] int positive_label(std::size_t line, const std::string& word) const {
        const int value = deck_.integer(line, word);
        if (value < 1)
            deck_.fail(line, "has the label " + word + ", where a whole number above zero is needed");
        return value;
    }

    void read_nodes(const Card& card) {
        deck_.allow_only(card, {"NSET"});
        for (const auto& [line, words, ends_with_comma] : card.lines) {
            if (words.size() < 2) deck_.fail(line, "is not a node: a label and coordinates are needed");
            if (words.size() > 4)
                deck_.fail(line,
                           "has more than a label and three coordinates: no normal of beams at a node "
                           "is understood; give n1 with their section");
            const int label = positive_label(line, words[0]);
            Eigen::Vector3d position = Eigen::Vector3d::Zero();
            for (std::size_t i = 1; i < words.size(); ++i)
                position[static_cast<Eigen::Index>(i) - 1] =
                    words[i].empty() ? 0.0 : deck_.number(line, words[i]);
            if (!nodes_.emplace(label, NodeIndex(result_.frame.nodes.size())).second)
                deck_.fail(line, "gives node " + words[0] + " a second time");
            result_.frame.nodes.push_back(position);
            result_.labels.push_back(label);
            if (const auto set = card.parameters.find("NSET"); set != card.parameters.end())
                node_sets_.add(set->second, label);
        }
    }

    [[nodiscard]] NodeIndex node(std::size_t line, const std::string& word) const {
        const auto found = nodes_.find(deck_.integer(line, word));
        if (found == nodes_.end()) deck_.fail(line, "names node " + word + ", which does not exist");
        return found->second;
    }

    using LineIterator = std::vector<Card::Line>::const_iterator;

    /// The label and the nodes of the element that begins at a line; `at` moves to the element's last line.
    /// After a comma, the nodes go on in the next line, but only until the element has all of them: many
    /// programs end every line with a comma.
    static Words element_words(const Card& card, std::size_t nodes, LineIterator& at) {
        Words words = at->words;
        while (words.size() < nodes + 1 && at->ends_with_comma && at + 1 != card.lines.end()) {
            ++at;
            words.insert(words.end(), at->words.begin(), at->words.end());
        }
        return words;
    }

    void read_elements(const Card& card) {
        deck_.allow_only(card, {"TYPE", "ELSET"});
        const std::string& type = deck_.parameter(card, "TYPE");
        const bool two = type == "B31" || type == "B31R" || type == "B33";
        if (!two && type != "B32" && type != "B32R")
            deck_.fail(card.line,
                       "has elements of type " + type + "; B31, B31R, B32, B32R and B33 are understood");
        const std::size_t count = two ? 2 : 3;
        for (auto at = card.lines.begin(); at != card.lines.end(); ++at) {
            const std::size_t line = at->number;
            const Words words = element_words(card, count, at);
            const std::string label_and_nodes = "a label and " + std::to_string(count) + " nodes";
            if (words.size() < count + 1)
                deck_.fail(line,
                           "is not an element of type " + type + ": " + label_and_nodes + " are needed");
            if (words.size() > count + 1)
                deck_.fail(line, "gives an element of type " + type + " more than " + label_and_nodes +
                                     ": no node for its orientation is understood; give n1 with its section");
            ElementData element;
            element.line = line;
            for (std::size_t i = 1; i <= count; ++i) element.nodes.push_back(node(line, words[i]));
            const int label = positive_label(line, words[0]);
            if (!elements_.emplace(label, element).second)
                deck_.fail(line, "gives element " + words[0] + " a second time");
            if (const auto set = card.parameters.find("ELSET"); set != card.parameters.end())
                element_sets_.add(set->second, label);
        }
    }

    void read_material(const Card& card) {
        deck_.allow_only(card, {"NAME"});
        material_ = &materials_[deck_.parameter(card, "NAME")];
    }

    [[nodiscard]] Material& material_of(const Card& card) const {
        if (material_ == nullptr) deck_.fail(card.line, "(" + card.keyword + ") belongs to no *MATERIAL");
        return *material_;
    }

    static constexpr const char* kOneTemperature = "values at one temperature alone are understood";

    void read_elastic(const Card& card) {
        deck_.allow_only(card, {"TYPE"});
        deck_.require_choice(card, "TYPE", {"ISO", "ISOTROPIC"});
        const auto values = deck_.numbers(deck_.only_line(card, kOneTemperature), {2, 3});
        material_of(card).young_modulus = values[0];
        material_of(card).poisson_ratio = values[1];
    }

    void read_density(const Card& card) {
        deck_.allow_only(card, {});
        material_of(card).density = deck_.numbers(deck_.only_line(card, kOneTemperature), {1, 2})[0];
    }

    [[nodiscard]] const std::set<int>& element_set(std::size_t line, const std::string& name) {
        const std::set<int>* set = element_sets_.find(name);
        if (set == nullptr) deck_.fail(line, "names the element set " + name + ", which does not exist");
        element_sets_.count_use(deck_, line, set->size());
        return *set;
    }

    void read_section(const Card& card) {
        deck_.allow_only(card, {"ELSET", "MATERIAL", "SECTION", "TEMPERATURE"});
        const std::string& shape = deck_.parameter(card, "SECTION");
        if (card.lines.empty()) deck_.fail(card.line, "(" + card.keyword + ") has no dimensions");
        // The third line of a *BEAM SECTION is the number of integration points, which has no meaning here.
        if (card.lines.size() > 2 && card.keyword == "*BEAMGENERALSECTION")
            deck_.fail(card.lines[2].number, "gives a section elastic constants, which its material has");
        const Section& section = sections_.emplace_back(deck_section(deck_, shape, card.lines.front()));
        std::optional<Eigen::Vector3d> normal = Eigen::Vector3d(0.0, 0.0, -1.0);  // CalculiX' default
        if (card.lines.size() > 1) {
            const auto n = deck_.numbers(card.lines[1], {3, 3});
            normal = Eigen::Vector3d(n[0], n[1], n[2]);
        }
        const std::string& set = deck_.parameter(card, "ELSET");
        for (const int label : element_set(card.line, set)) {
            const auto element = elements_.find(label);
            if (element == elements_.end())
                deck_.fail(card.line, "needs element " + std::to_string(label) + ", which does not exist");
            element->second.section = &section;
            element->second.material = deck_.parameter(card, "MATERIAL");
            element->second.normal = normal;
        }
    }

    [[nodiscard]] std::vector<NodeIndex> nodes_named(std::size_t line, const std::string& word) {
        if (word.empty()) deck_.fail(line, "names no node or node set before its first comma");
        const std::set<int>* set = node_sets_.find(word);
        if (const std::optional<int> label = label_of(word)) {
            if (set != nullptr && !nodes_.contains(*label))
                deck_.fail(line, "names node " + word + ", which does not exist; a number means no node set");
            return {node(line, word)};
        }
        if (set == nullptr) deck_.fail(line, "names the node set " + word + ", which does not exist");
        if (set->empty()) deck_.fail(line, "names the node set " + word + ", which has no nodes");
        node_sets_.count_use(deck_, line, set->size());
        std::vector<NodeIndex> nodes;
        for (const int label : *set) nodes.push_back(node(line, std::to_string(label)));
        return nodes;
    }

    [[nodiscard]] int dof(std::size_t line, const std::string& word) const {
        const int dof = deck_.integer(line, word);
        if (dof < 1 || dof > kDofsPerNode)
            deck_.fail(line, "has degree of freedom " + word + ", where 1 to 6 are possible");
        return dof - 1;
    }

    /// The parameter OP of a card; without it, MOD.
    [[nodiscard]] StepOperation operation_of(const Card& card) const {
        deck_.require_choice(card, "OP", {"MOD", "NEW"});
        return card.has("OP") && card.parameters.at("OP") == "NEW" ? StepOperation::New : StepOperation::Mod;
    }

    void begin_step(const Card& card) {
        deck_.allow_only(
            card, {"AMPLITUDE", "CONVERTSDI", "EXTRAPOLATION", "INC", "INCF", "NAME", "NLGEOM", "UNSYMM"});
        history_.begin_step();
    }

    /// The first and the last component that a line of *BOUNDARY holds.
    [[nodiscard]] std::pair<int, int> held_range(std::size_t line, const Words& words) const {
        if (words[1] == "ENCASTRE") return {0, 5};
        if (words[1] == "PINNED") return {0, 2};
        const int first = dof(line, words[1]);
        const int last = words.size() > 2 && !words[2].empty() ? dof(line, words[2]) : first;
        if (last < first) deck_.fail(line, "ends with degree of freedom " + words[2] + ", before its first");
        return {first, last};
    }

    void read_boundary(const Card& card) {
        deck_.allow_only(card, {"OP", "TYPE"});
        deck_.require_choice(card, "TYPE", {"DISPLACEMENT"});
        history_.begin_boundary(operation_of(card));
        for (const auto& [line, words, ends_with_comma] : card.lines) {
            if (words.size() < 2) deck_.fail(line, "needs a node or set and a degree of freedom");
            const auto [first, last] = held_range(line, words);
            const double value = words.size() > 3 && !words[3].empty() ? deck_.number(line, words[3]) : 0.0;
            for (const NodeIndex index : nodes_named(line, words[0])) {
                for (int d = first; d <= last; ++d) history_.hold(index, static_cast<Dof>(d), value);
            }
        }
    }

    void read_loads(const Card& card) {
        deck_.allow_only(card, {"OP"});
        history_.begin_loads(operation_of(card));
        for (const auto& [line, words, ends_with_comma] : card.lines) {
            if (words.size() < 3) deck_.fail(line, "needs a node or set, a degree of freedom and a value");
            const auto d = static_cast<Dof>(dof(line, words[1]));
            for (const NodeIndex index : nodes_named(line, words[0]))
                history_.load(index, d, deck_.number(line, words[2]));
        }
    }

    void read_gravity(const Card& card) {
        deck_.allow_only(card, {"OP"});
        history_.begin_gravity(operation_of(card));
        for (const auto& [line, words, ends_with_comma] : card.lines) {
            if (words.size() < 6 || words[1] != "GRAV")
                deck_.fail(
                    line,
                    "is no gravity (SET,GRAV,value,direction): other distributed loads are not understood");
            if (words[0].empty()) deck_.fail(line, "names no set of all elements before GRAV");
            pulled_.emplace_back(line, words[0]);
            const Eigen::Vector3d direction(deck_.number(line, words[3]), deck_.number(line, words[4]),
                                            deck_.number(line, words[5]));
            if (direction.isZero(0.0)) deck_.fail(line, "gives gravity no direction");
            history_.pull(words[0], deck_.number(line, words[2]), direction);
        }
    }

    /// The labels that a word means where an element or a set may stand.
    [[nodiscard]] std::set<int> elements_named(std::size_t line, const std::string& word) {
        const std::optional<int> label = label_of(word);
        if (!label) return element_set(line, word);
        if (!elements_.contains(*label))
            deck_.fail(line,
                       "names element " + word + ", which does not exist" +
                           (element_sets_.find(word) == nullptr ? "" : "; a number means no element set"));
        return {*label};
    }

    /// Check that gravity acts on all elements, also on those that come after it in the deck. Each word once:
    /// load histories name one set in thousands of lines.
    void check_pulled() {
        std::set<std::string> checked;
        for (const auto& [line, word] : pulled_)
            if (checked.insert(word).second) check_all_pulled(line, word);
    }

    void check_all_pulled(std::size_t line, const std::string& word) {
        const std::set<int> pulled = elements_named(line, word);
        const auto is_pulled = [&pulled](const auto& element) { return pulled.contains(element.first); };
        if (!std::ranges::all_of(elements_, is_pulled))
            deck_.fail(line, "lets gravity act on " + (label_of(word) ? "element " + word : word) +
                                 ", a part of the beams; it must act on all of them: name a set of all");
    }

    void add_beams(int label, const ElementData& element) {
        if (element.section == nullptr)
            deck_.fail(element.line, "gives element " + std::to_string(label) + ", which has no section");
        const auto material = materials_.find(element.material);
        if (material == materials_.end())
            deck_.fail(element.line, "gives element " + std::to_string(label) + " of the material " +
                                         element.material + ", which does not exist");
        if (element.nodes.size() == 3 && !lies_between(element.nodes[1], element.nodes[0], element.nodes[2]))
            deck_.fail(element.line, "gives element " + std::to_string(label) +
                                         ", whose second node does not lie between its first and its third");
        for (std::size_t i = 1; i < element.nodes.size(); ++i) {
            beam_labels_.push_back(label);
            result_.frame.beams.push_back({.nodes = {element.nodes[i - 1], element.nodes[i]},
                                           .section = *element.section,
                                           .material = material->second,
                                           .normal = element.normal});
        }
    }

    [[nodiscard]] bool lies_between(NodeIndex middle, NodeIndex start, NodeIndex end) const {
        const auto at = [&](NodeIndex node) { return result_.frame.nodes[node]; };
        return (at(middle) - at(start)).dot(at(end) - at(middle)) > 0.0;
    }

    InputDeck deck_;
    LabelledFrame result_;
    std::vector<int> beam_labels_;
    DeckHistory history_;
    /// The words for what gravity acts on, with their lines.
    std::vector<std::pair<std::size_t, std::string>> pulled_;
    std::map<int, NodeIndex> nodes_;
    std::map<int, ElementData> elements_;
    LabelSets node_sets_{"NSET"}, element_sets_{"ELSET"};
    std::map<std::string, Material> materials_;
    Material* material_ = nullptr;
    std::list<Section> sections_;
};

}  // namespace

LabelledFrame frame_of(InputDeck deck) {
    return Reader(std::move(deck)).run();
}

}  // namespace fretwork::mechanics::decks
