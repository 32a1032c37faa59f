// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas are derived in docs/concepts/corotational.md.
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/corotational_element.hpp>
#include <fretwork/mechanics/elements/corotational_pose.hpp>
#include <fretwork/mechanics/elements/dense_products.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::mechanics::elements {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Pose = CorotationalPose;

/// Three columns of derivatives. Each node has three rows for its displacement, followed by three rows for
/// its rotation.
using Tall = Eigen::MatrixX3d;

/// The first row of a block, a node's displacement or rotation.
Eigen::Index row_of(std::size_t block) {
    return 3 * static_cast<Eigen::Index>(block);
}

Vector3d part_of(const VectorXd& vector, std::size_t block) {
    return vector.segment<3>(row_of(block));
}

Matrix3d part_of(const Tall& columns, std::size_t block) {
    return columns.middleRows<3>(row_of(block));
}

/// Compute out += a m or out = a m, where a and out have three columns of n rows.
void multiply(const double* a, const Matrix3d& m, Eigen::Index n, Sum sum, double* out) {
    multiply_by_three({a, n, 3}, m.data(), sum, out);
}

/// K x.
VectorXd product(const MatrixXd& stiffness, const double* x) {
    VectorXd y(stiffness.rows());
    multiply_by_vector({stiffness.data(), stiffness.rows(), stiffness.cols()}, x, y.data());
    return y;
}

/// The three columns of a block in a square matrix.
const double* columns_of(const MatrixXd& matrix, std::size_t block) {
    return matrix.data() + row_of(block) * matrix.rows();
}
double* columns_of(MatrixXd& matrix, std::size_t block) {
    return matrix.data() + row_of(block) * matrix.rows();
}

/// Copy the lower triangle into the upper triangle.
void mirror(MatrixXd& matrix) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        for (Eigen::Index i = j + 1; i < matrix.rows(); ++i) matrix(j, i) = matrix(i, j);
    }
}

class CorotationalElement final : public Element {
  public:
    CorotationalElement(std::vector<NodeIndex> nodes, std::shared_ptr<const CorotationalBody> body,
                        const Matrix3d& turn)
        : nodes_(std::move(nodes)), body_(std::move(body)), turn_(turn) {}

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return nodes_; }

    void rest_stiffness(MatrixXd& stiffness) const override { stiffness = turned(body_->stiffness()); }

    void mass(MatrixXd& mass) const override { mass = turned(body_->mass()); }

    void evaluate(std::span<const NodeState> states, Demand demand,
                  ElementResponse& response) const override {
        Pose pose(*body_, turn_, states);
        if (!pose.has_axes()) return refuse(response);
        const VectorXd stress = write_energy(pose, response);
        pose.turn_into_structure(turn_);
        balance(pose, stress, response.force);
        if (demand == Demand::Tangent) write_tangent(pose, response.force, response.tangent);
    }

    [[nodiscard]] Eigen::Index stress_count() const override { return size(); }

    void evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses& stresses,
                        MixedResponse& response) const override {
        Pose pose(*body_, turn_, states);
        if (!pose.has_axes()) {
            refuse(response);
            response.given_force = response.force;
            return;
        }
        const VectorXd stress = write_energy(pose, response);
        std::copy_n(stress.data(), size(), stresses.own.begin());
        pose.turn_into_structure(turn_);
        balance(pose, stress, response.force);
        const VectorXd given = Eigen::Map<const VectorXd>(stresses.given.data(), size());
        balance(pose, given, response.given_force);
        if (demand == Demand::Force) return;
        write_tangent(pose, response.given_force, response.tangent);
        write_slopes(pose, stresses.slopes);
    }

    void stresses_of(std::span<const double> strains, std::span<double> stresses) const override {
        multiply_by_vector({body_->stiffness().data(), size(), size()}, strains.data(), stresses.data());
    }

    /// The largest rotation of a node relative to the corotating axes.
    [[nodiscard]] double relative_turn(std::span<const NodeState> states) const override {
        const Pose pose(*body_, turn_, states);
        if (!pose.has_axes()) return std::numeric_limits<double>::infinity();
        double largest = 0.0;
        for (std::size_t i = 0; i < pose.count(); ++i) largest = std::max(largest, pose.rotation(i).norm());
        return largest;
    }

    void geometric_stiffness(const VectorXd& displacements, MatrixXd& stiffness) const override {
        VectorXd local(size());
        const Matrix3d back = turn_.toRotationMatrix().transpose();
        for (std::size_t i = 0; i < block_count(); ++i)
            local.segment<3>(row_of(i)) = back * part_of(displacements, i);
        Pose rest(*body_);
        rest.turn_into_structure(turn_);
        const VectorXd stress = product(body_->stiffness(), local.data());
        VectorXd force;
        balance(rest, stress, force);
        stiffness.setZero(size(), size());
        let_frame_follow(rest, force, stiffness);
    }

  private:
    [[nodiscard]] std::size_t block_count() const { return 2 * nodes_.size(); }
    [[nodiscard]] Eigen::Index size() const { return row_of(block_count()); }

    /// Write a response that is not finite, for a state without corotating axes. The solver then takes a
    /// shorter step.
    void refuse(ElementResponse& response) const {
        response.energy = std::numeric_limits<double>::quiet_NaN();
        response.force.setConstant(size(), response.energy);
        response.tangent.setConstant(size(), size(), response.energy);
    }

    /// A matrix of the body, in the structure's axes.
    [[nodiscard]] MatrixXd turned(const MatrixXd& own) const {
        const Matrix3d turn = turn_.toRotationMatrix();
        const Matrix3d back = turn.transpose();
        MatrixXd result(size(), size());
        for (std::size_t j = 0; j < block_count(); ++j) {
            for (std::size_t i = 0; i < block_count(); ++i) {
                const Matrix3d half = turn * own.block<3, 3>(row_of(i), row_of(j));
                result.block<3, 3>(row_of(i), row_of(j)) = half * back;
            }
        }
        return result;
    }

    /// Write the energy. Returns the stresses f = K q.
    VectorXd write_energy(const Pose& pose, ElementResponse& response) const {
        VectorXd q(size());
        for (std::size_t i = 0; i < pose.count(); ++i) {
            q.segment<3>(row_of(2 * i)) = pose.arm(i) - pose.rest_arm(i);
            q.segment<3>(row_of(2 * i + 1)) = pose.rotation(i);
        }
        VectorXd stress = product(body_->stiffness(), q.data());
        response.energy = 0.5 * q.dot(stress);
        return stress;
    }

    /// Compute J_x^T (f + G^T l), the forces and moments on the nodes, which balance each other. The stresses
    /// f are in the body's axes.
    void balance(const Pose& pose, const VectorXd& stress, VectorXd& force) const {
        force.resize(size());
        Vector3d mean = Vector3d::Zero();
        for (std::size_t i = 0; i < pose.count(); ++i) {
            const Vector3d push = pose.axes() * part_of(stress, 2 * i);
            force.segment<3>(row_of(2 * i)) = push;
            mean += push;
        }
        mean /= static_cast<double>(pose.count());
        Vector3d moment = Vector3d::Zero();
        for (std::size_t i = 0; i < pose.count(); ++i) {
            force.segment<3>(row_of(2 * i)) -= mean;
            const Vector3d own = pose.axes() * part_of(stress, 2 * i + 1);
            const Vector3d turned = pose.inverse_map(i).transpose() * own;
            force.segment<3>(row_of(2 * i + 1)) = turned;
            moment += pose.arm(i).cross(part_of(force, 2 * i)) + turned;
        }
        const Vector3d multiplier = pose.inverse_slope().transpose() * moment;
        for (std::size_t i = 0; i < pose.count(); ++i) {
            force.segment<3>(row_of(2 * i)) += multiplier.cross(pose.rest_arm(i));
            const Vector3d turned = pose.inverse_map(i).transpose() * multiplier;
            force.segment<3>(row_of(2 * i + 1)) += body_->rotation_weight() * turned;
        }
    }

    void write_tangent(const Pose& pose, const VectorXd& force, MatrixXd& tangent) const {
        write_spin_stiffness(pose, tangent);
        let_frame_follow(pose, force, tangent);
    }

    /// Write J_x^T K J_x, the stiffness against motions of the nodes with the corotating axes held.
    void write_spin_stiffness(const Pose& pose, MatrixXd& result) const {
        const Matrix3d back = pose.axes().transpose();
        MatrixXd half(size(), size());  // K J_x
        for (std::size_t j = 0; j < block_count(); ++j)
            multiply(columns_of(body_->stiffness(), j), map_of(pose, back, j), size(), Sum::Replace,
                     columns_of(half, j));
        const MatrixXd turned = half.transpose();
        result.resize(size(), size());
        for (std::size_t j = 0; j < block_count(); ++j)
            multiply(columns_of(turned, j), map_of(pose, back, j), size(), Sum::Replace,
                     columns_of(result, j));
        mirror(result);
    }

    /// The map from motions in the structure's axes to strains in the body's axes, with the corotating axes
    /// held.
    static Matrix3d map_of(const Pose& pose, const Matrix3d& back, std::size_t block) {
        if (block % 2 == 0) return back;
        return back * pose.inverse_map(block / 2);
    }

    /// The matrix W^T, where W = dw/dx describes how the corotating axes follow the nodes.
    [[nodiscard]] Tall frame_slope(const Pose& pose) const {
        Tall follow(size(), 3);
        const Matrix3d slope = pose.inverse_slope().transpose();
        for (std::size_t i = 0; i < pose.count(); ++i) {
            const Matrix3d by_rotation = pose.inverse_map(i).transpose() * slope;
            follow.middleRows<3>(row_of(2 * i)) = geometry::cross_matrix(pose.rest_arm(i)) * slope;
            follow.middleRows<3>(row_of(2 * i + 1)) = -body_->rotation_weight() * by_rotation;
        }
        return follow;
    }

    /// Write B = J_x + J_w W, the map from motions in the structure's axes to strains in the body's axes.
    void write_slopes(const Pose& pose, std::span<double> result) const {
        Eigen::Map<MatrixXd> slopes(result.data(), size(), size());
        const Matrix3d back = pose.axes().transpose();
        Tall by_frame(size(), 3);  // J_w
        for (std::size_t i = 0; i < pose.count(); ++i) {
            by_frame.middleRows<3>(row_of(2 * i)) = back * geometry::cross_matrix(pose.arm(i));
            by_frame.middleRows<3>(row_of(2 * i + 1)) = -map_of(pose, back, 2 * i + 1);
        }
        const Tall follow = frame_slope(pose);
        for (std::size_t j = 0; j < block_count(); ++j) {
            const Matrix3d own = part_of(follow, j).transpose();
            multiply(by_frame.data(), own, size(), Sum::Replace, result.data() + row_of(j) * size());
        }
        const Matrix3d mean = back / static_cast<double>(pose.count());
        for (std::size_t j = 0; j < pose.count(); ++j) {
            const Eigen::Index at = row_of(2 * j);
            for (std::size_t i = 0; i < pose.count(); ++i) slopes.block<3, 3>(row_of(2 * i), at) -= mean;
            slopes.block<3, 3>(at, at) += back;
            slopes.block<3, 3>(at + 3, at + 3) -= part_of(by_frame, 2 * j + 1);
        }
    }

    /// The product K_x N, where N maps a spin w of the corotating axes to the motions of the nodes in the
    /// opposite spin -w.
    [[nodiscard]] Tall coupling_of(const Pose& pose, const MatrixXd& tangent) const {
        Tall coupling = Tall::Zero(size(), 3);
        for (std::size_t j = 0; j < pose.count(); ++j) {
            multiply(columns_of(tangent, 2 * j), geometry::cross_matrix(pose.arm(j)), size(), Sum::Add,
                     coupling.data());
            coupling -= tangent.middleCols<3>(row_of(2 * j + 1));
        }
        return coupling;
    }

    /// Change `tangent` from the stiffness with held corotating axes to the stiffness with axes that follow
    /// the nodes. Add the geometric terms of `force`.
    void let_frame_follow(const Pose& pose, const VectorXd& force, MatrixXd& tangent) const {
        const Tall coupling = coupling_of(pose, tangent);
        Tall against = coupling;
        Matrix3d frame_curvature = Matrix3d::Zero();  // H_ww, and the term from the stiffness
        for (std::size_t i = 0; i < pose.count(); ++i) {
            const Vector3d push = part_of(force, 2 * i);
            const Vector3d moment = part_of(force, 2 * i + 1);
            const Vector3d& arm = pose.arm(i);
            const Matrix3d curvature = node_curvature(pose, i, moment);
            tangent.block<3, 3>(row_of(2 * i + 1), row_of(2 * i + 1)) += curvature;
            against.middleRows<3>(row_of(2 * i)) -= geometry::cross_matrix(push);
            against.middleRows<3>(row_of(2 * i + 1)) -= curvature + 0.5 * geometry::cross_matrix(moment);
            const Matrix3d dyad = push * arm.transpose();
            const Matrix3d turned = geometry::cross_matrix(arm) * part_of(coupling, 2 * i);
            frame_curvature += 0.5 * (dyad + dyad.transpose()) + curvature;
            frame_curvature.diagonal().array() -= push.dot(arm);
            frame_curvature -= turned + part_of(coupling, 2 * i + 1);
        }
        const Tall follow = frame_slope(pose);
        const Matrix3d half = 0.5 * frame_curvature;
        multiply(follow.data(), half, size(), Sum::Add, against.data());
        add_following(follow, against, tangent);
    }

    /// H_i, the curvature of the energy that arises because the rotation of a node is not linear in its spin.
    static Matrix3d node_curvature(const Pose& pose, std::size_t i, const Vector3d& moment) {
        const Matrix3d& map = pose.inverse_map(i);
        const Matrix3d change = geometry::spin_map_derivative(pose.rotation(i), moment);
        const Matrix3d symmetric = -0.5 * (change + change.transpose());
        const Matrix3d half = symmetric * map;
        return map.transpose() * half;
    }

    /// Add A W + W^T A^T.
    /// @param follow   W^T
    /// @param against  A
    static void add_following(const Tall& follow, const Tall& against, MatrixXd& tangent) {
        add_symmetric_product({against.data(), tangent.rows(), 3}, follow.data(), tangent.data());
        mirror(tangent);
    }

    std::vector<NodeIndex> nodes_;
    std::shared_ptr<const CorotationalBody> body_;
    Eigen::Quaterniond turn_;  ///< rotation from the body's axes to the structure's axes
};

}  // namespace

std::unique_ptr<const Element> make_corotational_element(std::vector<NodeIndex> nodes,
                                                         std::shared_ptr<const CorotationalBody> body,
                                                         const Matrix3d& turn) {
    return std::make_unique<CorotationalElement>(std::move(nodes), std::move(body), turn);
}

}  // namespace fretwork::mechanics::elements
