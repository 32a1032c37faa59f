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

/// The equations of nonlinear equilibrium, internal forces = loads_at(load factor), and their derivative.
///
/// If unknowns are components of rotation vectors, moments and tangent are transformed to these unknowns. The
/// tangent is a symmetric matrix, plus small skew blocks at nodes with applied moments of fixed direction and
/// at least two free rotations.
class NonlinearSystem {
  public:
    /// @param threads  number of threads that evaluate the elements of a large structure; 0: one for each
    /// processor
    /// @param control  stop of the evaluations
    explicit NonlinearSystem(const Assembly& assembly, int threads = 1, const base::Control& control = {});

    [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }

    /// Begin the path at a configuration under these loads instead of at rest.
    void begin_at(const Configuration& start, NodeValues loads);
    /// The loads at a load factor.
    [[nodiscard]] NodeValues loads_at(double load_factor) const;

    /// Take over changes of the assembly: new elements of the same nodes, new loads, new prescribed values.
    /// The control is replaced, too.
    void refresh(const base::Control& control);

    /// Compute the quantities that the functions below return. The tangent, and all that depends on it, is
    /// computed only with Demand::Tangent. Throws Stopped.
    void evaluate(const Configuration& configuration, double load_factor, Demand demand = Demand::Tangent);

    /// Evaluate in a mixed iteration, with the given stresses in the tangent's geometric terms. The elements'
    /// own stresses are written to the workspace, and with Demand::Tangent also the slopes of their strains.
    void evaluate_mixed(const Configuration& configuration, double load_factor, Demand demand,
                        StressWorkspace& stresses);
    /// Extrapolate the given stresses along small motions of all nodes, prescribed motions included.
    void extrapolate(const NodeValues& motions, StressWorkspace& stresses) const;
    /// The right side for a solution with an old tangent and the slopes of its evaluation. It is valid after
    /// a mixed evaluation with Demand::Force. It is zero if the unbalanced forces are zero and the given
    /// stresses are the elements' own.
    [[nodiscard]] const Eigen::VectorXd& mixed_unbalanced() const { return mixed_unbalanced_; }
    /// The force B0^T (s - given), by which the given stresses lag behind the elements' own stresses s. It is
    /// valid after a mixed evaluation with Demand::Force.
    [[nodiscard]] Eigen::VectorXd lag() const;

    /// The solution at the configuration of the last evaluation, without its history and its stability.
    [[nodiscard]] Solution describe(const Configuration& configuration, double load_factor) const;

    /// The unbalanced force of each equation: load minus internal force.
    [[nodiscard]] const Eigen::VectorXd& unbalanced() const { return unbalanced_; }
    /// The norm of the unbalanced forces over the norm of loads and reactions; 0 without loads if rounding
    /// explains the forces.
    [[nodiscard]] double relative_residual() const { return relative_residual_; }
    /// True if rounding of elements near rest explains the unbalanced forces.
    [[nodiscard]] bool is_rounding() const {
        return (unbalanced_.cwiseAbs().array() <= rounding_.array()).all();
    }
    /// The derivative of the unbalanced forces with respect to the load factor at fixed unknowns. It includes
    /// prescribed displacements if the last evaluation computed the tangent.
    [[nodiscard]] const Eigen::VectorXd& load_rate() const { return load_rate_; }
    [[nodiscard]] std::span<const double> tangent() const { return values_; }
    /// True if applied moments make the tangent of the last evaluation unsymmetric.
    [[nodiscard]] bool has_skew_part() const { return !skew_.empty(); }
    /// The product of the tangent's skew part and x.
    [[nodiscard]] Eigen::VectorXd skew_product(const Eigen::VectorXd& x) const;
    /// False if applied moments make the tangent unsymmetric: their direction stays fixed in space, so they
    /// have no potential. Moments of gravity do not count, because they come from forces, which have a
    /// potential.
    [[nodiscard]] bool is_conservative() const;
    /// The kind of stability test by the tangent's pivots.
    [[nodiscard]] StabilityTest stability_test() const {
        return is_conservative() ? StabilityTest::Tangent : StabilityTest::SymmetricPart;
    }
    /// The largest relative rotation of the ends of an element (rad), and its largest change from a nearby
    /// configuration.
    struct RelativeTurn {
        double largest = 0.0;
        double largest_change = 0.0;
    };
    [[nodiscard]] RelativeTurn relative_turn(const Configuration& configuration,
                                             const Configuration& last) const;
    /// The true forces and moments of the supports.
    [[nodiscard]] NodeValues reactions() const;
    /// The reactions, or zero if supports move the structure as a rigid body: all forces are then rounding,
    /// and must not become loads of a path that releases a support.
    [[nodiscard]] NodeValues held_forces() const;

  private:
    struct SkewBlock {
        std::array<int, 3> equation;
        Eigen::Matrix3d matrix;
    };
    void take_up_loads();
    void map_spins(const Configuration& configuration);
    /// The quantities requested from the elements. `stresses` is null except in a mixed iteration.
    struct Pass {
        Demand demand;
        StressWorkspace* stresses = nullptr;
        /// The given stresses, if only forces are evaluated: the lag is then computed, too. Null in any other
        /// evaluation.
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
    void add_moment_terms(const Configuration& configuration, const NodeValues& loads,
                          const NodeValues& internal);
    [[nodiscard]] Eigen::Matrix3d skew_of_moment(int node, const NodeValues& loads) const;
    void gather_unbalanced(double load_factor, const NodeValues& loads);

    Unknowns unknowns_;
    NodeValues start_loads_;                  ///< loads at the beginning of the path
    NodeValues load_change_;                  ///< change of the loads from there to the full load
    Eigen::VectorXd rounding_;                ///< rounding of the force of each equation at rest
    Elements rounded_elements_;               ///< elements to which `rounding_` belongs
    std::vector<int> moment_nodes_;           ///< nodes with applied moments and at least two free rotations
    std::vector<Eigen::Matrix3d> spin_maps_;  ///< spin maps of the vector nodes
    base::Control control_;
    int threads_ = 1;
    std::size_t batch_ = 1;  ///< number of elements that are evaluated before their responses are added
    std::size_t piece_ = 1;  ///< number of elements that one thread takes at a time
    std::vector<Answer> answers_;

    NodeValues internal_;
    NodeValues forces_;          ///< loads minus internal forces, with true moments
    NodeValues given_internal_;  ///< internal forces of the given stresses
    NodeValues lag_;             ///< lag(), mapped to the unknowns
    NodeValues prescribed_rate_;
    double energy_ = 0.0;
    double relative_residual_ = 0.0;
    bool is_free_of_forces_ = false;  ///< true without loads, if rounding explains all forces and reactions
    std::vector<double> values_;
    std::vector<SkewBlock> skew_;
    Eigen::VectorXd unbalanced_;
    Eigen::VectorXd mixed_unbalanced_;
    Eigen::VectorXd load_rate_;
};

}  // namespace fretwork::mechanics::nonlinear
