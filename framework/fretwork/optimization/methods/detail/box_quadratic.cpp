// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/box_quadratic.hpp>

#include <Eigen/Cholesky>

#include <vector>

namespace fretwork::optimization::detail {
namespace {

class ActiveSetMethod {
  public:
    ActiveSetMethod(const Eigen::MatrixXd& H, const Eigen::VectorXd& g, const Bounds& bounds)
        : H_(H), g_(g), bounds_(bounds), point_(Eigen::VectorXd::Zero(g.size())), held_(g.size(), false) {}

    Eigen::VectorXd run() {
        for (Eigen::Index i = 0; i < g_.size(); ++i) held_[i] = pull(i, g_) >= 0.0 && at_bound(i);
        // Each pass goes to a bound and fixes its variable, or goes to the minimum over the free variables
        // and releases a variable. Each such minimum is lower than the one before, so the passes come to an
        // end. The limit ends them if round-off makes them repeat.
        for (Eigen::Index pass = 0; pass < 8 * g_.size(); ++pass) {
            if (step_to_face_minimum()) continue;
            if (!release_one()) break;
        }
        return point_;
    }

  private:
    [[nodiscard]] bool at_lower(Eigen::Index i) const { return point_[i] <= bounds_.lower[i]; }
    [[nodiscard]] bool at_bound(Eigen::Index i) const { return at_lower(i) || point_[i] >= bounds_.upper[i]; }
    /// The component of the gradient that presses variable i against the bound at which it is; negative: away
    /// from the bound.
    [[nodiscard]] double pull(Eigen::Index i, const Eigen::VectorXd& gradient) const {
        return at_lower(i) ? gradient[i] : -gradient[i];
    }

    /// Go to the minimum over the free variables, or to the first bound on the way there. True if a bound was
    /// met; its variable is then fixed.
    bool step_to_face_minimum() {
        std::vector<Eigen::Index> free;
        for (Eigen::Index i = 0; i < g_.size(); ++i) {
            if (!held_[i]) free.push_back(i);
        }
        if (free.empty()) return false;
        const Eigen::VectorXd gradient = g_ + H_ * point_;
        const Eigen::VectorXd step =
            -Eigen::MatrixXd(H_(free, free)).llt().solve(Eigen::VectorXd(gradient(free)));
        double share = 1.0;
        Eigen::Index blocking = -1;
        for (std::size_t k = 0; k < free.size(); ++k) {
            const Eigen::Index i = free[k];
            const double room = (step[k] > 0.0 ? bounds_.upper[i] : bounds_.lower[i]) - point_[i];
            if (std::abs(room) >= std::abs(step[k]) * share) continue;
            share = room / step[k];
            blocking = i;
        }
        point_(free) += share * step;
        point_ = bounds_.clamp(point_);
        if (blocking < 0) return false;
        point_[blocking] =
            point_[blocking] - bounds_.lower[blocking] < bounds_.upper[blocking] - point_[blocking]
                ? bounds_.lower[blocking]
                : bounds_.upper[blocking];
        held_[blocking] = true;
        return true;
    }

    /// Release the variable that the gradient pulls hardest away from its bound.
    bool release_one() {
        const Eigen::VectorXd gradient = g_ + H_ * point_;
        const double threshold = -1e-12 * g_.lpNorm<Eigen::Infinity>();
        Eigen::Index released = -1;
        double strongest = threshold;
        for (Eigen::Index i = 0; i < g_.size(); ++i) {
            if (!held_[i] || pull(i, gradient) >= strongest) continue;
            strongest = pull(i, gradient);
            released = i;
        }
        if (released < 0) return false;
        held_[released] = false;
        return true;
    }

    const Eigen::MatrixXd& H_;
    const Eigen::VectorXd& g_;
    const Bounds& bounds_;
    Eigen::VectorXd point_;
    std::vector<bool> held_;
};

}  // namespace

Eigen::VectorXd minimize_box_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                       const Bounds& bounds) {
    return ActiveSetMethod(H, g, bounds).run();
}

}  // namespace fretwork::optimization::detail
