// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/scenario_loads.hpp>

namespace fretwork::reduction::detail {
namespace {

Eigen::Vector3d to_vector(const std::array<double, 3>& values) {
    return {values[0], values[1], values[2]};
}

}  // namespace

std::vector<mechanics::Support> supports_of(const Scenario& scenario) {
    std::vector<mechanics::Support> supports;
    for (const Scenario::Support& support : scenario.supports)
        supports.push_back({mechanics::NodeIndex(support.interface_node), support.fixed});
    return supports;
}

std::vector<mechanics::NodalLoad> loads_of(const Scenario& scenario, double magnitude) {
    std::vector<mechanics::NodalLoad> loads;
    for (const Scenario::Load& load : scenario.loads)
        loads.push_back({mechanics::NodeIndex(load.interface_node), magnitude * to_vector(load.force),
                         magnitude * to_vector(load.moment)});
    return loads;
}

}  // namespace fretwork::reduction::detail
