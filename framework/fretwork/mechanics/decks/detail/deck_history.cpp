// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/decks/detail/deck_history.hpp>

#include <cmath>

namespace fretwork::mechanics::decks {

void DeckHistory::begin_step() {
    held_.begin_step();
    loads_.begin_step();
    gravity_.begin_step();
}

void DeckHistory::pull(const std::string& set, double magnitude, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d along = direction.normalized();
    constexpr double kDirectionsInOne = 1e8;
    Pull key{set, {}};
    for (std::size_t i = 0; i < 3; ++i)
        key.second[i] = std::llround(kDirectionsInOne * along[static_cast<Eigen::Index>(i)]);
    gravity_.add(key, magnitude * along);
}

void DeckHistory::put_into(Frame& frame) const {
    held_.for_each([&](const Place& place, double value) {
        const auto [node, dof] = place;
        if (value != 0.0) {
            frame.prescribed.push_back({node, dof, value});
            return;
        }
        if (frame.supports.empty() || frame.supports.back().node != node)
            frame.supports.push_back({node, {}});
        frame.supports.back().fixed[dof] = true;
    });
    loads_.for_each([&](const Place& place, double value) {
        const auto [node, dof] = place;
        if (value == 0.0) return;
        if (frame.loads.empty() || frame.loads.back().node != node) frame.loads.push_back({node});
        NodalLoad& load = frame.loads.back();
        const int d = static_cast<int>(dof);
        (d < 3 ? load.force : load.moment)[d % 3] = value;
    });
    gravity_.for_each([&](const Pull&, const Eigen::Vector3d& value) { frame.gravity += value; });
}

}  // namespace fretwork::mechanics::decks
