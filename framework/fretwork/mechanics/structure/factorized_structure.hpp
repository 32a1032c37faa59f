// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/subsystem.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

/// A stiffness entry in the row of a held dof.
struct HeldEntry {
    int node, dof, other_node, other_dof;
    double value;
};

/// The treatment of factors after an edit that replaces elements.
enum class ElementEdit {
    /// A correction of the factors if it saves time and keeps their accuracy; otherwise new factors.
    Cheaper,
    Refactor,  ///< new factors, unless all elements are those of the factors
    /// A correction of the factors, even a slower one, if it keeps their accuracy; otherwise new factors.
    Correct,
};

/// The factorized linear stiffness of a structure with its supports: one system of equations, or two if the
/// structure is flat and its elements decouple. The class is a value: after an edit, the new value shares all
/// valid parts with the old value. A value has a copy of the caller's assembly; the two share only the
/// immutable elements.
class FactorizedStructure {
  public:
    /// Factorize a structure. Throws as the constructor of LinearSolver.
    FactorizedStructure(const Assembly& assembly, const LinearOptions& options);
    /// Factorize a structure that results from an edit of another structure. If only loads and prescribed
    /// values differ, the factors are shared. If elements are replaced by others of the same nodes, listed in
    /// any order, `edit` decides about the factors; a flat structure that is one system gets new factors, to
    /// try the split. If supports differ, the elimination order is shared. After any other edit, nothing is
    /// shared. Throws as the constructor above.
    FactorizedStructure(const FactorizedStructure& before, const Assembly& assembly,
                        ElementEdit edit = ElementEdit::Cheaper, const base::Control& control = {});

    [[nodiscard]] const Assembly& assembly() const { return assembly_; }
    [[nodiscard]] const Constraints& constraints() const { return constraints_; }
    [[nodiscard]] std::span<const Subsystem> systems() const { return systems_; }
    [[nodiscard]] std::span<const HeldEntry> held_entries() const { return held_entries_; }
    /// The effect of the last edit on the factors.
    [[nodiscard]] FactorChange last_change() const { return last_change_; }
    /// The number of elements that differ from the factorized elements.
    [[nodiscard]] std::size_t corrected_elements() const { return corrected_elements_; }
    [[nodiscard]] int threads() const { return threads_; }

  private:
    /// The connections of all nodes, held or not, and the order of elimination.
    struct Connections {
        sparse::NodeGraph graph;
        std::vector<int> order;
    };
    /// Whether to try the split into two systems, in plane and out of plane.
    enum class Split { Tried, Refused };

    static std::shared_ptr<const Connections> connections_of(const Assembly& assembly,
                                                             const base::Control& control);
    void build(const base::Control& control);
    void lay_out(Split split, const base::Control& control);
    bool add_elements(const base::Control& control);
    void put_in_layout_order(std::size_t element, const Element& own, Eigen::MatrixXd& stiffness) const;
    void factorize(const base::Control& control);
    void take_over(const FactorizedStructure& before, ElementEdit edit, const base::Control& control);
    void share(const FactorizedStructure& before);
    bool correct(const FactorizedStructure& before, ElementEdit edit, const base::Control& control);
    [[nodiscard]] bool is_correction_cheaper(std::span<const Subsystem> systems,
                                             std::span<const std::size_t> changed) const;
    using Changes = std::vector<std::vector<sparse::MatrixChange>>;
    [[nodiscard]] std::optional<Changes> changes_from(const FactorizedStructure& before,
                                                      std::span<const std::size_t> changed,
                                                      const base::Control& control) const;
    void keep_held_entries(const base::Control& control);
    void keep_row(std::span<const NodeIndex> nodes, Eigen::Index row, const Eigen::MatrixXd& stiffness);

    Assembly assembly_;
    int threads_;
    std::shared_ptr<const Connections> connections_;
    Constraints constraints_;
    bool split_ = false;
    std::vector<Subsystem> systems_;
    Elements factorized_;  ///< the elements from which the factors were made
    std::size_t corrected_elements_ = 0;
    FactorChange last_change_ = FactorChange::Refactorized;
    std::vector<HeldEntry> held_entries_;
};

}  // namespace fretwork::mechanics::structure
