// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/detail/rotation.hpp>

namespace fretwork::reduction {

/// The motion of a node in one scenario of a linear model, from magnitude to magnitude.
class Objective::NodeMotion {
  public:
    template <class Row>
    explicit NodeMotion(const Row& unit)
        : unit_translation_(unit.template head<3>()), rotation_(unit.template tail<3>()) {}

    void advance_to(const Sample& sample) {
        if (sample.is_other_step) rotation_.set_step(sample.step);
        rotation_.advance();
    }
    [[nodiscard]] Eigen::Vector3d missed_translation(const Sample& sample, std::size_t node) const {
        return sample.magnitude * unit_translation_ - sample.targets[node].translation;
    }
    [[nodiscard]] Eigen::Quaterniond missed_rotation(const Sample& sample, std::size_t node) const {
        return sample.targets[node].inverse_rotation * rotation_.rotation();
    }
    [[nodiscard]] double squared_rate_across() const { return rotation_.squared_rate_across(); }
    [[nodiscard]] Eigen::Vector3d pull_back(const Eigen::Vector3d& vector) const {
        return rotation_.pull_back(vector);
    }

    static std::vector<NodeMotion> of_all(const mechanics::NodeValues& unit) {
        return {unit.rowwise().begin(), unit.rowwise().end()};
    }

  private:
    Eigen::Vector3d unit_translation_;
    detail::GrowingRotation rotation_;
};

}  // namespace fretwork::reduction
