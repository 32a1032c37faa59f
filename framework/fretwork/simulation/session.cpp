// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/detail/session_impl.hpp>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

template <class Entry>
void set_entry(std::vector<Entry>& entries, std::size_t place, const Entry& entry, const char* what) {
    if (place > entries.size())
        throw base::InputError("the load case has no " + std::string(what) + " " + std::to_string(place) +
                               ", but " + std::to_string(entries.size()));
    if (place == entries.size()) {
        entries.push_back(entry);
    } else {
        entries[place] = entry;
    }
}

}  // namespace

Session::Session(Surface surface, LoadCase load_case, SimulationOptions options,
                 CalibrationSource calibrations)
    : impl_(std::make_unique<Impl>(std::move(surface), std::move(load_case), std::move(options),
                                   std::move(calibrations))) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

const Surface& Session::surface() const {
    return impl_->surface();
}
const LoadCase& Session::load_case() const {
    return impl_->load_case();
}
const SimulationOptions& Session::options() const {
    return impl_->options();
}
std::optional<reduction::BeamMotion> Session::beam_motion(tiling::TileIndex tile,
                                                          const mechanics::Solution& solution) const {
    return impl_->beam_motion(tile, solution);
}
const Session::Work& Session::last_work() const {
    return impl_->last_work();
}

void Session::paint(std::span<const TileIndex> tiles, const std::string& pattern) {
    impl_->paint(tiles, pattern);
}
void Session::turn(std::span<const TileIndex> tiles, int vertices) {
    impl_->turn(tiles, vertices);
}
void Session::set_tile_model(std::span<const TileIndex> tiles, const std::string& model) {
    impl_->set_tile_model(tiles, model);
}
void Session::set_model(const std::string& model) {
    impl_->set_model(model);
}
void Session::set_setting(const reduction::Setting& setting) {
    impl_->set_setting(setting);
}
void Session::set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations) {
    impl_->set_calibrations(std::move(calibrations));
}
void Session::set_load_case(const LoadCase& load_case) {
    impl_->set_load_case(load_case);
}

void Session::set_support(std::size_t entry, const LoadCase::Support& support) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.supports, entry, support, "support");
    impl_->set_load_case(edited);
}
void Session::set_load(std::size_t entry, const LoadCase::Load& load) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.loads, entry, load, "load");
    impl_->set_load_case(edited);
}
void Session::set_prescribed(std::size_t entry, const LoadCase::PrescribedDisplacement& displacement) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.prescribed, entry, displacement, "prescribed displacement");
    impl_->set_load_case(edited);
}

std::vector<TileDeformation> Session::tile_deformations(const mechanics::Solution& solution) const {
    return impl_->tile_deformations(solution);
}
Eigen::MatrixXd Session::solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control) {
    return impl_->solve_adjoint(rows, control);
}
mechanics::Result Session::solve(const base::Control& control, mechanics::StabilityCheck check) {
    return impl_->solve(control, check);
}

}  // namespace fretwork::simulation
