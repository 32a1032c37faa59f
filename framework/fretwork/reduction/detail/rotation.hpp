// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace fretwork::reduction::detail {

/// The rotation about a fixed axis by an angle that is proportional to a magnitude. The magnitude starts at 0
/// and grows by steps. Half angles are added up, so steps of one size share one sine and cosine.
class GrowingRotation {
  public:
    /// @param rate  rotation vector for a magnitude of 1
    explicit GrowingRotation(const Eigen::Vector3d& rate);

    /// Set the step by which advance() raises the magnitude.
    void set_step(double magnitude);
    void advance() {
        angle_ += step_angle_;
        const double sine = sine_ * step_cosine_ + cosine_ * step_sine_;
        cosine_ = cosine_ * step_cosine_ - sine_ * step_sine_;
        sine_ = sine;
    }

    [[nodiscard]] Eigen::Quaterniond rotation() const {
        return {cosine_, sine_ * axis_.x(), sine_ * axis_.y(), sine_ * axis_.z()};
    }
    /// J^T times a vector, where exp(v + dv) = exp(v) exp(J dv) to first order, and v is the rotation vector.
    [[nodiscard]] Eigen::Vector3d pull_back(const Eigen::Vector3d& vector) const {
        if (angle_ == 0.0) return vector;
        const double along = 2.0 * sine_ * cosine_ / angle_;
        const double across = 2.0 * sine_ * sine_ / angle_;
        return along * vector + (1.0 - along) * axis_.dot(vector) * axis_ + across * axis_.cross(vector);
    }
    /// The eigenvalue of J^T J across the axis; along the axis it is 1.
    [[nodiscard]] double squared_rate_across() const {
        const double rate = angle_ == 0.0 ? 1.0 : 2.0 * sine_ / angle_;
        return rate * rate;
    }

  private:
    double rate_;  ///< angle for a magnitude of 1
    Eigen::Vector3d axis_;
    double angle_ = 0.0;
    double sine_ = 0.0;  ///< sine of half the angle
    double cosine_ = 1.0;
    double step_angle_ = 0.0;
    double step_sine_ = 0.0;  ///< sine of half the step
    double step_cosine_ = 1.0;
};

/// The sum of angles between 0 and pi/2, at the cost of one arctangent. The sine and the cosine of the sum
/// follow from the addition theorems, and full quarter turns are counted. The sum is as exact as a sum of
/// arctangents, for large and small angles.
class AngleSum {
  public:
    void add(double sine, double cosine) {
        const double sum_sine = sine_ * cosine + cosine_ * sine;
        const double sum_cosine = cosine_ * cosine - sine_ * sine;
        const bool is_filled = sum_cosine < 0.0;
        quarters_ += is_filled ? 1 : 0;
        sine_ = is_filled ? -sum_cosine : sum_sine;
        cosine_ = is_filled ? sum_sine : sum_cosine;
    }
    [[nodiscard]] double value() const;

  private:
    int quarters_ = 0;
    double sine_ = 0.0;  ///< sine of the angle beyond the full quarter turns
    double cosine_ = 1.0;
};

}  // namespace fretwork::reduction::detail
