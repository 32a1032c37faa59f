// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/staged_path.hpp>
#include <fretwork/simulation/stages.hpp>
#include <fretwork/simulation/surface.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::simulation {

/// The supports, held components and loads of a surface, load stage after load stage.
class StageConditions {
  public:
    /// Begin with the supports of the plan, and without loads. The surface and the plan must outlive the
    /// conditions. Throws InputError if a support selects no node.
    StageConditions(const Surface& surface, const StagePlan& plan);

    /// The conditions at the end of the next load stage; see LoadStage.
    /// @param displacements  displacements of the interface nodes at the end of the previous load stage, for
    /// LoadStage::keep
    /// @param nodes  number of rows of the loads; interface nodes come first
    ///
    /// Throws InputError that names the load stage and its entry, as check_stages().
    mechanics::StageTarget advance(const LoadStage& stage, const mechanics::NodeValues& displacements,
                                   std::size_t nodes);

  private:
    using Place = std::pair<int, int>;  ///< node and component

    void take_load_cases(const LoadStage& stage);
    void release(const LoadCase::Support& entry);
    void keep(const LoadCase::Support& entry, const mechanics::NodeValues& displacements);
    void prescribe(const LoadCase::PrescribedDisplacement& entry);
    void claim(const Place& place, std::string_view list);
    [[nodiscard]] std::vector<Place> places_of(const LoadCase::Support& entry) const;
    [[nodiscard]] mechanics::NodeValues loads(std::size_t nodes) const;

    const Surface& surface_;
    const StagePlan& plan_;
    std::vector<mechanics::Support> supports_;
    std::set<Place> supported_;
    std::map<Place, double> held_;              ///< prescribed and kept components, with their values
    std::map<Place, std::string_view> claims_;  ///< list of the present load stage that names the component
    std::map<std::string, double> factors_;     ///< factor of each load case that acts
};

/// The load case that a load stage names, merged with the load cases that it combines. Throws InputError if
/// it does not exist, and as combined().
LoadCase stage_load_case(const StagePlan& plan, const std::string& name);

/// Check load stages before they are simulated. Throws InputError, with both positions if two load stages
/// have one name, with the load stage if it changes nothing, and with the load stage and the entry in these
/// cases: an entry selects no node; a load case does not exist or is named twice in one load stage; one load
/// stage gives two values to a component, or names it in two of `free`, `keep` and `prescribed`; an entry of
/// `free` releases nothing, or a support that was moved. Throws InputError as resolve() for the load cases.
void check_stages(const Surface& surface, const StagePlan& plan);

}  // namespace fretwork::simulation
