// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas are derived in framework/fretwork/mechanics/corotational.md.
#include <fretwork/mechanics/elements/corotational_element.hpp>
#include <fretwork/mechanics/elements/corotational_pose.hpp>

#include <limits>

namespace fretwork::mechanics::elements {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

template <int Nodes>
class CorotationalElement final : public Element {
  public:
    CorotationalElement(std::vector<NodeIndex> nodes, std::shared_ptr<const CorotationalBody> body,
                        const Matrix3d& turn)
        : nodes_(std::move(nodes)), body_(std::move(body)), turn_(turn) {}

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return nodes_; }

    void rest_stiffness(Eigen::MatrixXd& stiffness) const override { stiffness = turned(body_->stiffness()); }

    void mass(Eigen::MatrixXd& mass) const override { mass = turned(body_->mass()); }

    void evaluate(std::span<const NodeState> states, Demand demand,
                  ElementResponse& response) const override {
        Pose pose(*body_, turn_, states);
        if (!pose.has_frame()) return refuse(response);
        const Vector stress = write_energy(pose, response);
        pose.turn_into_structure(turn_);
        const Vector force = balanced_force(pose, stress);
        response.force = force;
        if (demand == Demand::Tangent) write_tangent(pose, force, response.tangent);
    }

    [[nodiscard]] Index stress_count() const override { return size(); }

    void evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses& stresses,
                        MixedResponse& response) const override {
        Pose pose(*body_, turn_, states);
        if (!pose.has_frame()) {
            refuse(response);
            response.given_force = response.force;
            return;
        }
        const Vector stress = write_energy(pose, response);
        Eigen::Map<Vector>(stresses.own.data(), size()) = stress;
        pose.turn_into_structure(turn_);
        response.force = balanced_force(pose, stress);
        const Vector given = balanced_force(pose, Eigen::Map<const Vector>(stresses.given.data(), size()));
        response.given_force = given;
        if (demand == Demand::Force) return;
        write_tangent(pose, given, response.tangent);
        write_slopes(pose, stresses.slopes);
    }

    void stresses_of(std::span<const double> strains, std::span<double> stresses) const override {
        Eigen::Map<Vector>(stresses.data(), size()).noalias() =
            body_->stiffness() * Eigen::Map<const Vector>(strains.data(), size());
    }

    /// The largest rotation of a node against the frame.
    [[nodiscard]] double relative_turn(std::span<const NodeState> states) const override {
        const Pose pose(*body_, turn_, states);
        if (!pose.has_frame()) return std::numeric_limits<double>::infinity();
        double largest = 0.0;
        for (Index i = 0; i < pose.count(); ++i) largest = std::max(largest, pose.rotation(i).norm());
        return largest;
    }

    void geometric_stiffness(const Eigen::VectorXd& displacements,
                             Eigen::MatrixXd& stiffness) const override {
        Vector local(size());
        const Matrix3d axes = turn_.toRotationMatrix();
        for (Index at = 0; at < size(); at += 3)
            local.template segment<3>(at) = axes.transpose() * displacements.segment<3>(at);
        Pose rest(*body_);
        rest.turn_into_structure(turn_);
        const Vector force = balanced_force(rest, body_->stiffness() * local);
        stiffness.setZero(size(), size());
        project<Eigen::MatrixXd>(rest, force, stiffness);
    }

  private:
    using Pose = CorotationalPose<Nodes>;
    using Sizes = CorotationalSizes<Nodes>;
    using Vector = typename Sizes::Vector;
    using Square = typename Sizes::Square;
    using Wide = typename Sizes::Wide;
    using Tall = typename Sizes::Tall;

    [[nodiscard]] Index size() const {
        if constexpr (Nodes != Eigen::Dynamic) return Sizes::kDofs;
        return static_cast<Index>(nodes_.size()) * kDofsPerNode;
    }

    /// A state without a frame has no energy: the solver sees that, and takes a shorter step.
    void refuse(ElementResponse& response) const {
        response.energy = std::numeric_limits<double>::quiet_NaN();
        response.force.setConstant(size(), response.energy);
        response.tangent.setConstant(size(), size(), response.energy);
    }

    /// A matrix of the body in the structure's axes.
    [[nodiscard]] Eigen::MatrixXd turned(const Eigen::MatrixXd& own) const {
        const Matrix3d turn = turn_.toRotationMatrix();
        Eigen::MatrixXd result(size(), size());
        for (Index j = 0; j < size(); j += 3) {
            for (Index i = 0; i < size(); i += 3)
                result.block<3, 3>(i, j) = turn * own.block<3, 3>(i, j) * turn.transpose();
        }
        return result;
    }

    /// Returns the stresses f = K q.
    Vector write_energy(const Pose& pose, ElementResponse& response) const {
        Vector q(size());
        for (Index i = 0; i < pose.count(); ++i) {
            q.template segment<3>(kDofsPerNode * i) = pose.arm(i) - pose.rest_arm(i);
            q.template segment<3>(kDofsPerNode * i + 3) = pose.rotation(i);
        }
        Vector stress = body_->stiffness() * q;
        response.energy = 0.5 * q.dot(stress);
        return stress;
    }

    void write_tangent(const Pose& pose, const Vector& force, Eigen::MatrixXd& tangent) const {
        Square own = spin_stiffness(pose);
        project<Square>(pose, force, own);
        tangent = own;
    }

    /// B = J_x + J_w W, from motions in the structure's axes to strains in the body's.
    void write_slopes(const Pose& pose, std::span<double> result) const {
        Eigen::Map<Square> slopes(result.data(), size(), size());
        const Matrix3d back = pose.axes().transpose();
        Tall by_frame(size(), 3);  // J_w
        for (Index i = 0; i < pose.count(); ++i) {
            by_frame.template middleRows<3>(kDofsPerNode * i) = back.lazyProduct(cross_matrix(pose.arm(i)));
            by_frame.template middleRows<3>(kDofsPerNode * i + 3) = -back.lazyProduct(pose.inverse_map(i));
        }
        slopes = by_frame.lazyProduct(frame_slope(pose));
        const Matrix3d mean = back / static_cast<double>(pose.count());
        for (Index i = 0; i < pose.count(); ++i) {
            const Index at = kDofsPerNode * i;
            for (Index j = 0; j < pose.count(); ++j)
                slopes.template block<3, 3>(at, kDofsPerNode * j) -= mean;
            slopes.template block<3, 3>(at, at) += back;
            slopes.template block<3, 3>(at + 3, at + 3) += back.lazyProduct(pose.inverse_map(i));
        }
    }

    /// W = dw/dx: how the frame follows the nodes.
    Wide frame_slope(const Pose& pose) const {
        Wide follow(3, size());
        for (Index i = 0; i < pose.count(); ++i) {
            const Index at = kDofsPerNode * i;
            follow.template middleCols<3>(at) = -pose.inverse_slope() * cross_matrix(pose.rest_arm(i));
            follow.template middleCols<3>(at + 3) =
                -body_->rotation_weight() * pose.inverse_slope() * pose.inverse_map(i);
        }
        return follow;
    }

    /// J_x^T (f + G^T l): forces and moments on the nodes, which balance each other. The stresses f are in
    /// the body's axes.
    Vector balanced_force(const Pose& pose, const Vector& stress) const {
        Vector force(size());
        for (Index at = 0; at < size(); at += 3)
            force.template segment<3>(at) = pose.axes() * stress.template segment<3>(at);
        Vector3d mean = Vector3d::Zero();
        for (Index i = 0; i < pose.count(); ++i) mean += force.template segment<3>(kDofsPerNode * i);
        mean /= static_cast<double>(pose.count());
        Vector3d moment = Vector3d::Zero();
        for (Index i = 0; i < pose.count(); ++i) {
            force.template segment<3>(kDofsPerNode * i) -= mean;
            auto own = force.template segment<3>(kDofsPerNode * i + 3);
            own = (pose.inverse_map(i).transpose() * own).eval();
            moment += pose.arm(i).cross(force.template segment<3>(kDofsPerNode * i)) + own;
        }
        const Vector3d multiplier = pose.inverse_slope().transpose() * moment;
        for (Index i = 0; i < pose.count(); ++i) {
            force.template segment<3>(kDofsPerNode * i) += multiplier.cross(pose.rest_arm(i));
            force.template segment<3>(kDofsPerNode * i + 3) +=
                body_->rotation_weight() * (pose.inverse_map(i).transpose() * multiplier);
        }
        return force;
    }

    /// J_x^T K J_x: the stiffness against motions of the nodes, the frame held.
    Square spin_stiffness(const Pose& pose) const {
        Square result(size(), size());
        const Eigen::MatrixXd& own = body_->stiffness();
        Eigen::Matrix<double, 3, Nodes == Eigen::Dynamic ? Eigen::Dynamic : 6 * Nodes> maps(3, size());
        for (Index i = 0; i < pose.count(); ++i) {
            maps.template middleCols<3>(kDofsPerNode * i) = pose.axes().transpose();
            maps.template middleCols<3>(kDofsPerNode * i + 3) =
                pose.axes().transpose().lazyProduct(pose.inverse_map(i));
        }
        for (Index j = 0; j < size(); j += 3) {
            const Matrix3d right = maps.template middleCols<3>(j);
            for (Index i = j; i < size(); i += 3) {
                const Matrix3d half = own.template block<3, 3>(i, j).lazyProduct(right);
                const Matrix3d block = maps.template middleCols<3>(i).transpose().lazyProduct(half);
                result.template block<3, 3>(i, j) = block;
                result.template block<3, 3>(j, i) = block.transpose();
            }
        }
        return result;
    }

    /// From the stiffness with the frame held to that with the frame following the nodes, and the change of
    /// the geometry under these forces.
    template <class Matrix>
    void project(const Pose& pose, const Vector& force, Matrix& tangent) const {
        const Wide follow = frame_slope(pose);
        Tall against(size(), 3);
        Matrix3d frame_curvature = Matrix3d::Zero();  // H_ww, and that of the stiffness
        Tall coupling = Tall::Zero(size(), 3);  // K_x N, N the nodes' motions against a spin of the frame
        for (Index i = 0; i < pose.count(); ++i) {
            const Index at = kDofsPerNode * i;
            coupling += tangent.template middleCols<3>(at).lazyProduct(cross_matrix(pose.arm(i)));
            coupling -= tangent.template middleCols<3>(at + 3);
        }
        for (Index i = 0; i < pose.count(); ++i) {
            const Index at = kDofsPerNode * i;
            const Vector3d push = force.template segment<3>(at);
            const Vector3d moment = force.template segment<3>(at + 3);
            const Vector3d arm = pose.arm(i);
            const Matrix3d map = pose.inverse_map(i);
            const Matrix3d change = spin_map_derivative(pose.rotation(i), moment);
            const Matrix3d curvature = -0.5 * map.transpose() * (change + change.transpose()) * map;  // H_i
            tangent.template block<3, 3>(at + 3, at + 3) += curvature;
            against.template middleRows<3>(at) = -cross_matrix(push);
            against.template middleRows<3>(at + 3) = -curvature - 0.5 * cross_matrix(moment);
            frame_curvature += 0.5 * (push * arm.transpose() + arm * push.transpose()) + curvature;
            frame_curvature.diagonal().array() -= push.dot(arm);
            frame_curvature -= cross_matrix(arm) * coupling.template middleRows<3>(at);
            frame_curvature -= coupling.template middleRows<3>(at + 3);
        }
        against += coupling;
        against += 0.5 * follow.transpose().lazyProduct(frame_curvature);
        Square followed = against.lazyProduct(follow);
        tangent += followed;
        tangent += followed.transpose();
    }

    std::vector<NodeIndex> nodes_;
    std::shared_ptr<const CorotationalBody> body_;
    Eigen::Quaterniond turn_;  ///< from the body's axes to the structure's
};

template <int Nodes>
std::unique_ptr<const Element> make(std::vector<NodeIndex>&& nodes,
                                    std::shared_ptr<const CorotationalBody>&& body, const Matrix3d& turn) {
    return std::make_unique<CorotationalElement<Nodes>>(std::move(nodes), std::move(body), turn);
}

}  // namespace

std::unique_ptr<const Element> make_corotational_element(std::vector<NodeIndex> nodes,
                                                         std::shared_ptr<const CorotationalBody> body,
                                                         const Matrix3d& turn) {
    switch (nodes.size()) {
        case 5:
            return make<5>(std::move(nodes), std::move(body), turn);
        case 6:
            return make<6>(std::move(nodes), std::move(body), turn);
        case 7:
            return make<7>(std::move(nodes), std::move(body), turn);
        default:
            return make<Eigen::Dynamic>(std::move(nodes), std::move(body), turn);
    }
}

}  // namespace fretwork::mechanics::elements
