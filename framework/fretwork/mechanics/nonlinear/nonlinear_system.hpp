// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/nonlinear/stress_workspace.hpp>
#include <fretwork/mechanics/nonlinear/unknowns.hpp>
#include <fretwork/mechanics/results/solution.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <functional>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// The equations of nonlinear equilibrium, internal = load factor * loads, and their derivative.
///
/// Where the unknowns are components of rotation vectors, moments and tangent are transformed to them. The
/// tangent is a symmetric matrix and, at freely turning nodes with applied moments of fixed direction, small
/// skew blocks.
class NonlinearSystem {
  public:
    /// @param threads  that evaluate the elements where these are many; 0: all there are
    /// @param control  stops evaluations
    explicit NonlinearSystem(const Assembly& assembly, int threads = 1, const base::Control& control = {});

    [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }

    /// Take up the assembly as it is now, where its elements have been replaced by others of the same nodes,
    /// or its loads or prescribed values have changed; and another control.
    void refresh(const base::Control& control);

    /// Compute the quantities of the members below; the tangent and its dependents only on request.
    void evaluate(const Configuration& configuration, double load_factor, Demand demand = Demand::Tangent);

    /// The same in a mixed iteration, with the given stresses in the tangent's geometric terms. The workspace
    /// takes the elements' own stresses and, with the tangent, the slopes of their strains.
    void evaluate_mixed(const Configuration& configuration, double load_factor, Demand demand,
                        StressWorkspace& stresses);
    /// Extrapolate the given stresses along small motions of the nodes: steps of the unknowns, and of what is
    /// prescribed.
    void extrapolate(const NodeValues& motions, StressWorkspace& stresses) const;
    /// After a mixed evaluation of forces alone: what an old tangent, with the slopes of the same evaluation,
    /// is to be solved with. It vanishes where the unbalanced forces do and the given stresses are the own.
    [[nodiscard]] const Eigen::VectorXd& mixed_unbalanced() const { return mixed_unbalanced_; }
    /// After the same: B0^T (s - given), what the old tangent makes of given stresses that are not the own.
    [[nodiscard]] Eigen::VectorXd lag() const;

    /// The solution at the configuration of the last evaluation, without its history and its stability.
    [[nodiscard]] Solution describe(const Configuration& configuration, double load_factor) const;

    /// Load less internal force, for each equation.
    [[nodiscard]] const Eigen::VectorXd& unbalanced() const { return unbalanced_; }
    /// Norm of the unbalanced forces over that of loads and reactions.
    [[nodiscard]] double relative_residual() const { return relative_residual_; }
    /// Whether the unbalanced forces are no more than what rounding makes of elements near rest.
    [[nodiscard]] bool is_rounding() const {
        return (unbalanced_.cwiseAbs().array() <= rounding_.array()).all();
    }
    /// The rate of the unbalanced forces in the load factor while the unknowns rest; with the tangent's share
    /// of prescribed displacements where it was last asked for.
    [[nodiscard]] const Eigen::VectorXd& load_rate() const { return load_rate_; }
    [[nodiscard]] std::span<const double> tangent() const { return values_; }
    /// Whether moments make the last tangent unsymmetric.
    [[nodiscard]] bool has_skew_part() const { return !skew_.empty(); }
    /// y = skew part of the tangent times x.
    [[nodiscard]] Eigen::VectorXd skew_product(const Eigen::VectorXd& x) const;
    /// False if external moments act: their direction stays fixed in space, so they have no potential. The
    /// moments of gravity stand for forces, which have one.
    [[nodiscard]] bool is_conservative() const { return skew_.empty() || !unknowns_.assembly().has_moments; }
    /// The stability that the tangent's pivots show.
    [[nodiscard]] StabilityTest stability_test() const {
        return is_conservative() ? StabilityTest::Tangent : StabilityTest::SymmetricPart;
    }
    /// How far the ends of elements are turned against each other, and how much farther than in another
    /// configuration near it: the largest of each.
    struct RelativeTurn {
        double largest = 0.0;
        double largest_change = 0.0;
    };
    [[nodiscard]] RelativeTurn relative_turn(const Configuration& configuration,
                                             const Configuration& last) const;
    /// True forces and moments of the supports.
    [[nodiscard]] NodeValues reactions() const;

  private:
    struct SkewBlock {
        std::array<int, 3> equation;
        Eigen::Matrix3d matrix;
    };
    void take_up_loads();
    void map_spins(const Configuration& configuration);
    /// The quantities that are requested from the elements; stresses in a mixed iteration only.
    struct Pass {
        Demand demand;
        StressWorkspace* stresses = nullptr;
        /// Those whose lag behind the elements' own is asked for, with forces alone; null: none.
        [[nodiscard]] StressWorkspace* lagging_stresses() const {
            return demand == Demand::Force ? stresses : nullptr;
        }
        [[nodiscard]] bool has_lag() const { return lagging_stresses() != nullptr; }
    };
    struct Answer {
        MixedResponse response;
        Eigen::VectorXd lag;
    };
    void evaluate(const Configuration& configuration, double load_factor, const Pass& pass);
    void for_elements(std::size_t count, const std::function<void(std::size_t)>& body) const;
    void add_elements(const Configuration& configuration, const Pass& pass);
    void evaluate_element(std::size_t index, const Configuration& configuration, const Pass& pass,
                          Answer& answer) const;
    [[nodiscard]] static std::span<const NodeState> states_of(const Element& element,
                                                              const Configuration& configuration);
    void add_answer(std::size_t index, const Answer& answer, const Pass& pass);
    void map_columns(std::span<const NodeIndex> nodes, Eigen::Ref<Eigen::MatrixXd> slopes) const;
    void map_to_unknowns(std::span<const NodeIndex> nodes, Eigen::MatrixXd& tangent) const;
    [[nodiscard]] NodeValues mapped(NodeValues forces) const;
    void add_prescribed_rate(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& tangent);
    void add_moment_terms(const Configuration& configuration, double load_factor, const NodeValues& internal);
    [[nodiscard]] Eigen::Matrix3d skew_of_moment(int node, double load_factor) const;
    void gather_unbalanced(double load_factor);
    [[nodiscard]] bool is_moved_rigidly(double scale, double unbalanced) const;

    Unknowns unknowns_;
    bool is_loaded_ = false;
    Eigen::VectorXd rounding_;                ///< what an equation's force may come to at rest
    std::vector<int> moment_nodes_;           ///< with applied moments and at least two free rotations
    std::vector<Eigen::Matrix3d> spin_maps_;  ///< of the vector nodes
    base::Control control_;
    int threads_ = 1;
    std::size_t batch_ = 1;  ///< elements that are evaluated before they are added
    std::size_t piece_ = 1;  ///< elements that one thread takes at a time
    std::vector<Answer> answers_;

    NodeValues internal_;
    NodeValues forces_;          ///< loads less internal, true moments
    NodeValues given_internal_;  ///< of the given stresses
    NodeValues lag_;             ///< against the unknowns
    NodeValues prescribed_rate_;
    double energy_ = 0.0;
    double relative_residual_ = 0.0;
    std::vector<double> values_;
    std::vector<SkewBlock> skew_;
    Eigen::VectorXd unbalanced_;
    Eigen::VectorXd mixed_unbalanced_;
    Eigen::VectorXd load_rate_;
};

}  // namespace fretwork::mechanics::nonlinear
