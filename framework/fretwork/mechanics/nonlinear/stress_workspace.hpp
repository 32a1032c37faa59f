// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics::nonlinear {

/// The state of all elements in a mixed iteration: the given stresses, the elements' own stresses in the last
/// evaluation, and the slopes of their strains in the last evaluation of the tangent. The elements cannot
/// keep this state, because they are shared and immutable.
class StressWorkspace {
  public:
    explicit StressWorkspace(const Assembly& assembly);

    /// The buffers of one element, for Element::evaluate_mixed.
    [[nodiscard]] ElementStresses of(std::size_t element);
    [[nodiscard]] Eigen::Map<Eigen::MatrixXd> slopes(std::size_t element);

    /// Set the given stresses of every element to its own stresses.
    void give_own() { given_ = own_; }
    /// Set the given stresses of an element to s + K B dx, where s are its own stresses, B its slopes, and dx
    /// small motions of its nodes (6n).
    void extrapolate(std::size_t element, const Eigen::VectorXd& motion);
    /// Add the lag B^T (s - given) to an element's forces (6n), where s are its own stresses, and B its
    /// slopes in the last evaluation of the tangent.
    void add_lag(std::size_t element, Eigen::VectorXd& force) const;

    /// The given stresses of all elements. A caller may keep a copy and restore it by give().
    [[nodiscard]] const std::vector<double>& given() const { return given_; }
    void give(const std::vector<double>& stresses) { given_ = stresses; }

  private:
    struct Place {
        std::size_t stress = 0;
        std::size_t slope = 0;
        Eigen::Index stresses = 0;
        Eigen::Index motions = 0;
    };
    const Elements& elements_;
    std::vector<Place> places_;
    std::vector<double> given_;
    std::vector<double> own_;
    std::vector<double> slopes_;
};

}  // namespace fretwork::mechanics::nonlinear
