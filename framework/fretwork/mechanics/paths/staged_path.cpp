// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/nonlinear/load_path.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>

#include <map>
#include <optional>
#include <utility>

namespace fretwork::mechanics {
namespace {

using nonlinear::LoadPath;
using nonlinear::PathStart;

using Place = std::pair<int, int>;           // node and dof
using HeldValues = std::map<Place, double>;  // by node and dof

HeldValues held_values(const StageTarget& target) {
    HeldValues held;
    for (const Support& support : target.supports) {
        for (int d = 0; d < kDofsPerNode; ++d)
            if (support.fixed.contains[d]) held[{support.node.value, d}] = 0.0;
    }
    for (const PrescribedDisplacement& given : target.prescribed)
        held[{given.node.value, static_cast<int>(given.dof)}] = given.value;
    return held;
}

bool holds_a_rotation(const HeldValues& held, int node) {
    return held.contains({node, 3}) || held.contains({node, 4}) || held.contains({node, 5});
}

bool has_moments(const NodeValues& loads) {
    return !loads.rightCols<3>().isZero(0.0);
}

}  // namespace

class StagedPath::Impl {
  public:
    Impl(Assembly assembly, const EquilibriumOptions& options)
        : assembly_(std::move(assembly)), options_(options) {
        options_.validate();
        options_.locate_critical_loads = false;
        if (options_.branch == Branch::Primary) options_.branch = Branch::Stable;
    }

    Solution advance(const StageTarget& target) {
        HeldValues held = held_values(target);
        std::optional<PathStart> start;
        if (last_) start = {last_->configuration, last_->loads, reactions_of_released(held)};
        take_up(held, target.loads, start);
        const base::Task task(options_.control, "load stage (thousandths)", nonlinear::kThousandths);
        LoadPath path(assembly_, options_, start);
        Solution solution = path.advance_to(1.0, {task, 1.0});
        // After an error, both still belong to the load stage before.
        last_ = path.end();
        held_ = std::move(held);
        return solution;
    }

  private:
    /// The reactions on released components, with which a load stage begins. The moment of a support that
    /// holds some components of a rotation can have all components.
    [[nodiscard]] NodeValues reactions_of_released(const HeldValues& held) const {
        NodeValues forces = NodeValues::Zero(last_->reactions.rows(), kDofsPerNode);
        for (const auto& [place, value] : held_) {
            const auto [node, dof] = place;
            if (held.contains(place)) continue;
            if (dof >= 3 && !holds_a_rotation(held, node))
                forces.row(node).tail<3>() = last_->reactions.row(node).tail<3>();
            else
                forces(node, dof) = last_->reactions(node, dof);
        }
        return forces;
    }

    /// Take over supports and loads. Each held component gets a prescribed value, because it may have moved.
    void take_up(const HeldValues& held, const NodeValues& loads, const std::optional<PathStart>& start) {
        assembly_.supports.clear();
        assembly_.prescribed.clear();
        for (const auto& [place, value] : held)
            assembly_.prescribed.push_back({NodeIndex(place.first), static_cast<Dof>(place.second), value});
        assembly_.loads = loads;
        assembly_.has_moments =
            has_moments(loads) || (start && (has_moments(start->loads) || has_moments(start->released)));
    }

    Assembly assembly_;
    EquilibriumOptions options_;
    std::optional<nonlinear::PathEnd> last_;  ///< last equilibrium; none: the structure is at rest
    HeldValues held_;                         ///< values of held components at the end of the last load stage
};

StagedPath::StagedPath(Assembly assembly, const EquilibriumOptions& options)
    : impl_(std::make_unique<Impl>(std::move(assembly), options)) {}
StagedPath::StagedPath(StagedPath&&) noexcept = default;
StagedPath& StagedPath::operator=(StagedPath&&) noexcept = default;
StagedPath::~StagedPath() = default;

Solution StagedPath::advance(const StageTarget& target) {
    return impl_->advance(target);
}

}  // namespace fretwork::mechanics
