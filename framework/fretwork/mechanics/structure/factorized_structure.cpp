// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>
#include <fretwork/mechanics/structure/factorized_structure.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <algorithm>

namespace fretwork::mechanics::structure {
namespace {

/// The cost of a multiplication in a correction, in multiplications of a factorization. A factorization has a
/// faster dense kernel, and its factors solve faster (bench/edits_bench: repainted).
constexpr double kCorrectionCost = 2.0;

/// The number of elements between two checks for a stop.
constexpr std::size_t kElementsAtATime = 256;

/// True if two elements have the same nodes, in any order.
bool connect_the_same(const Element& a, const Element& b) {
    return std::ranges::is_permutation(a.nodes(), b.nodes());
}

bool connect_the_same(const Assembly& a, const Assembly& b) {
    if (a.nodes != b.nodes || a.elements.size() != b.elements.size()) return false;
    for (std::size_t e = 0; e < a.elements.size(); ++e) {
        if (a.elements[e] != b.elements[e] && !connect_the_same(*a.elements[e], *b.elements[e])) return false;
    }
    return true;
}

std::vector<std::size_t> differing(const Elements& a, const Elements& b) {
    std::vector<std::size_t> places;
    for (std::size_t e = 0; e < a.size(); ++e) {
        if (a[e] != b[e]) places.push_back(e);
    }
    return places;
}

}  // namespace

FactorizedStructure::FactorizedStructure(const Assembly& assembly, const LinearOptions& options)
    : assembly_(assembly),
      threads_(base::resolved_thread_count(options.threads)),
      connections_(connections_of(assembly, options.control)),
      constraints_(constraints_of(assembly)) {
    build(options.control);
}

FactorizedStructure::FactorizedStructure(const FactorizedStructure& before, const Assembly& assembly,
                                         ElementEdit edit, const base::Control& control)
    : assembly_(assembly), threads_(before.threads_), constraints_(constraints_of(assembly)) {
    const bool connected_the_same = connect_the_same(before.assembly_, assembly);
    connections_ = connected_the_same ? before.connections_ : connections_of(assembly, control);
    // If an element has coupled membrane and bending, it may be the element that was replaced.
    const bool has_other_elements = before.assembly_.elements != assembly.elements;
    const bool may_split = !before.split_ && has_other_elements && is_flat(assembly);
    if (connected_the_same && !may_split && before.constraints_.held == constraints_.held) {
        take_over(before, edit, control);
    } else {
        build(control);
    }
}

std::shared_ptr<const FactorizedStructure::Connections> FactorizedStructure::connections_of(
    const Assembly& assembly, const base::Control& control) {
    auto connections = std::make_shared<Connections>();
    connections->graph = coupling_graph(assembly);
    const std::vector<DofSet> all(assembly.nodes.size(), DofSet::all());
    connections->order = sparse::elimination_order(connections->graph, components(all), control);
    return connections;
}

/// Lay out, assemble and factorize.
void FactorizedStructure::build(const base::Control& control) {
    const base::Task task(control, "linear system", 3);
    lay_out(is_flat(assembly_) ? Split::Tried : Split::Refused, control);
    task.update(1);
    if (!add_elements(control)) {
        lay_out(Split::Refused, control);
        add_elements(control);
    }
    task.update(2);
    factorize(control);
    task.update(3);
}

void FactorizedStructure::lay_out(Split split, const base::Control& control) {
    split_ = split == Split::Tried;
    systems_.clear();
    const auto parts =
        split_ ? std::vector<DofSet>{kInPlane, kOutOfPlane} : std::vector<DofSet>{DofSet::all()};
    for (const DofSet& part : parts) {
        std::vector<sparse::Components> free = other_components(constraints_.held);
        for (sparse::Components& components : free) {
            for (std::size_t d = 0; d < kDofsPerNode; ++d) components[d] = components[d] && part.contains[d];
        }
        sparse::SystemLayout layout(connections_->graph, free, connections_->order, control);
        if (layout.equations() > 0) systems_.emplace_back(std::move(layout), threads_, control);
    }
}

/// Add all elements. False if an element couples the problems that were to be solved separately.
bool FactorizedStructure::add_elements(const base::Control& control) {
    Eigen::MatrixXd stiffness;
    for (std::size_t e = 0; e < assembly_.elements.size(); ++e) {
        if (e % kElementsAtATime == 0) control.check();
        assembly_.elements[e]->rest_stiffness(stiffness);
        if (split_ && !decouples(stiffness)) return false;
        put_in_layout_order(e, *assembly_.elements[e], stiffness);
        for (Subsystem& system : systems_) system.add(e, stiffness);
    }
    return true;
}

/// Reorder an element's stiffness for the layout. The layout may have the order of nodes of an element that
/// was replaced.
void FactorizedStructure::put_in_layout_order(std::size_t element, const Element& own,
                                              Eigen::MatrixXd& stiffness) const {
    const std::span<const int> listed = connections_->graph.cliques[element];
    if (!std::ranges::equal(own.nodes(), listed, {}, &NodeIndex::value))
        stiffness = reordered(stiffness, own.nodes(), listed);
}

void FactorizedStructure::factorize(const base::Control& control) {
    for (Subsystem& system : systems_) system.factorize(assembly_, control);
    factorized_ = assembly_.elements;
    corrected_elements_ = 0;
    last_change_ = FactorChange::Refactorized;
    keep_held_entries(control);
}

/// Take over the factors of a structure with the same connections and supports.
void FactorizedStructure::take_over(const FactorizedStructure& before, ElementEdit edit,
                                    const base::Control& control) {
    split_ = before.split_;
    if (before.assembly_.elements == assembly_.elements) return share(before);
    if (correct(before, edit, control)) return;
    for (const Subsystem& system : before.systems_) systems_.push_back(system.cleared());
    const base::Task task(control, "linear system", 2);
    if (!add_elements(control)) return build(control.silent());
    task.update(1);
    factorize(control);
    task.update(2);
}

void FactorizedStructure::share(const FactorizedStructure& before) {
    systems_ = before.systems_;
    factorized_ = before.factorized_;
    corrected_elements_ = before.corrected_elements_;
    held_entries_ = before.held_entries_;
    last_change_ = FactorChange::Kept;
}

/// Correct the factors for the elements that differ from the factorized elements. False if new factors are
/// wanted, cheaper or needed.
bool FactorizedStructure::correct(const FactorizedStructure& before, ElementEdit edit,
                                  const base::Control& control) {
    const std::vector<std::size_t> changed = differing(before.factorized_, assembly_.elements);
    std::optional<Changes> changes;
    if (!changed.empty()) {
        if (edit == ElementEdit::Refactor) return false;
        if (edit == ElementEdit::Cheaper && !is_correction_cheaper(before.systems_, changed)) return false;
        changes = changes_from(before, changed, control);
        if (!changes) return false;
    }
    std::vector<Subsystem> systems;
    for (std::size_t s = 0; s < before.systems_.size(); ++s) {
        systems.push_back(before.systems_[s].as_factorized());
        if (changes && !systems[s].correct(std::move((*changes)[s]), control)) return false;
    }
    systems_ = std::move(systems);
    factorized_ = before.factorized_;
    corrected_elements_ = changed.size();
    last_change_ = changed.empty() ? FactorChange::Kept : FactorChange::Updated;
    keep_held_entries(control);
    return true;
}

/// True if a correction takes less time than a new factorization. The numbers of multiplications decide, so
/// no stiffness is computed.
bool FactorizedStructure::is_correction_cheaper(std::span<const Subsystem> systems,
                                                std::span<const std::size_t> changed) const {
    double correction = 0.0;
    double factorization = 0.0;
    for (const Subsystem& system : systems) {
        std::vector<int> equations;
        for (const std::size_t e : changed) {
            const std::vector<int> own = system.equations_of(connections_->graph.cliques[e]);
            equations.insert(equations.end(), own.begin(), own.end());
        }
        correction += system.correction_work(equations);
        factorization += system.factorization_work();
    }
    return kCorrectionCost * correction < factorization;
}

/// The change of each system by the elements that differ from the factorized elements. Nothing if an element
/// couples systems that are solved separately.
std::optional<FactorizedStructure::Changes> FactorizedStructure::changes_from(
    const FactorizedStructure& before, std::span<const std::size_t> changed,
    const base::Control& control) const {
    Changes changes(before.systems_.size());
    Eigen::MatrixXd old_stiffness, stiffness;
    for (const std::size_t e : changed) {
        control.check();
        before.factorized_[e]->rest_stiffness(old_stiffness);
        assembly_.elements[e]->rest_stiffness(stiffness);
        if (split_ && !decouples(stiffness)) return std::nullopt;
        put_in_layout_order(e, *before.factorized_[e], old_stiffness);
        put_in_layout_order(e, *assembly_.elements[e], stiffness);
        stiffness -= old_stiffness;
        for (std::size_t s = 0; s < changes.size(); ++s)
            changes[s].push_back(before.systems_[s].change_at(connections_->graph.cliques[e], stiffness));
    }
    return changes;
}

void FactorizedStructure::keep_held_entries(const base::Control& control) {
    held_entries_.clear();
    Eigen::MatrixXd stiffness;
    for (std::size_t e = 0; e < assembly_.elements.size(); ++e) {
        if (e % kElementsAtATime == 0) control.check();
        const auto& element = assembly_.elements[e];
        const std::span<const NodeIndex> nodes = element->nodes();
        const auto is_held = [&](NodeIndex node) { return constraints_.held[node] != DofSet{}; };
        if (std::ranges::none_of(nodes, is_held)) continue;
        element->rest_stiffness(stiffness);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const DofSet& held = constraints_.held[nodes[i]];
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (held.contains[d])
                    keep_row(nodes, static_cast<Eigen::Index>(i) * kDofsPerNode + d, stiffness);
            }
        }
    }
}

void FactorizedStructure::keep_row(std::span<const NodeIndex> nodes, Eigen::Index row,
                                   const Eigen::MatrixXd& stiffness) {
    const int node = nodes[row / kDofsPerNode].value;
    const int dof = static_cast<int>(row % kDofsPerNode);
    for (Eigen::Index j = 0; j < stiffness.cols(); ++j) {
        if (stiffness(row, j) == 0.0) continue;
        const int other = nodes[j / kDofsPerNode].value;
        held_entries_.push_back({node, dof, other, static_cast<int>(j % kDofsPerNode), stiffness(row, j)});
    }
}

}  // namespace fretwork::mechanics::structure
