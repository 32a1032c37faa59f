// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/elements/dense_products.hpp>
#include <fretwork/mechanics/nonlinear/stress_workspace.hpp>

namespace fretwork::mechanics::nonlinear {
namespace {

using ConstVector = Eigen::Map<const Eigen::VectorXd>;

/// The number of stresses of a beam, for which the products are unrolled.
constexpr Eigen::Index kBeamStresses = 6;
constexpr Eigen::Index kBeamMotions = 12;
using BeamSlopes = Eigen::Map<const Eigen::Matrix<double, kBeamStresses, kBeamMotions>>;

}  // namespace

StressWorkspace::StressWorkspace(const Assembly& assembly) : elements_(assembly.elements) {
    Place place;
    places_.reserve(elements_.size());
    for (const auto& element : elements_) {
        place.stresses = element->stress_count();
        place.motions = std::ssize(element->nodes()) * kDofsPerNode;
        places_.push_back(place);
        place.stress += place.stresses;
        place.slope += place.stresses * place.motions;
    }
    given_.resize(place.stress);
    own_.resize(place.stress);
    slopes_.resize(place.slope);
}

ElementStresses StressWorkspace::of(std::size_t element) {
    const Place& place = places_[element];
    const std::size_t count = place.stresses;
    return {std::span(given_).subspan(place.stress, count), std::span(own_).subspan(place.stress, count),
            std::span(slopes_).subspan(place.slope, count * place.motions)};
}

Eigen::Map<Eigen::MatrixXd> StressWorkspace::slopes(std::size_t element) {
    const Place& place = places_[element];
    return {slopes_.data() + place.slope, place.stresses, place.motions};
}

void StressWorkspace::extrapolate(std::size_t element, const Eigen::VectorXd& motion) {
    const Place& place = places_[element];
    if (place.stresses == 0) return;
    thread_local Eigen::VectorXd strain;
    const double* slope = slopes_.data() + place.slope;
    if (place.stresses == kBeamStresses && place.motions == kBeamMotions) {
        strain.noalias() = BeamSlopes(slope).lazyProduct(motion.head<kBeamMotions>());
    } else {
        strain.resize(place.stresses);
        elements::multiply_by_vector({slope, place.stresses, place.motions}, motion.data(), strain.data());
    }
    const std::size_t count = place.stresses;
    const std::span<double> given = std::span(given_).subspan(place.stress, count);
    elements_[element]->stresses_of({strain.data(), count}, given);
    for (std::size_t i = 0; i < count; ++i) given[i] += own_[place.stress + i];
}

void StressWorkspace::add_lag(std::size_t element, Eigen::VectorXd& force) const {
    const Place& place = places_[element];
    if (place.stresses == 0) return;
    const double* slope = slopes_.data() + place.slope;
    const ConstVector own(own_.data() + place.stress, place.stresses);
    const ConstVector given(given_.data() + place.stress, place.stresses);
    if (place.stresses == kBeamStresses && place.motions == kBeamMotions) {
        const Eigen::Matrix<double, kBeamStresses, 1> lag = own - given;
        force += BeamSlopes(slope).transpose().lazyProduct(lag);
    } else {
        const Eigen::VectorXd lag = own - given;
        elements::add_transposed_product({slope, place.stresses, place.motions}, lag.data(), force.data());
    }
}

}  // namespace fretwork::mechanics::nonlinear
