// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/detail/session_mixture.hpp>

#include <algorithm>
#include <deque>
#include <functional>
#include <string_view>
#include <utility>

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

std::size_t hash_of(const mechanics::Solution& solution) {
    const mechanics::NodeValues& values = solution.displacements;
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(values.data()),
                                          static_cast<std::size_t>(values.size()) * sizeof(double)});
}

}  // namespace

/// The newest solutions that a session gave, by hashes of their displacements.
class Session::GivenSolutions {
  public:
    /// Tiles were edited: the next solution is of other tiles.
    void note_edit() { are_tiles_edited_ = true; }
    /// @param full_tiles  the tiles that a mixed model has in full; none for other models
    void add(const SurfaceResult& result, const std::vector<TileIndex>& full_tiles) {
        // Not earlier: after an edit that is undone, the first iterate may be a solution of before the edit.
        if (std::exchange(are_tiles_edited_, false) || full_tiles != full_tiles_) outdate();
        full_tiles_ = full_tiles;
        for (const mechanics::Solution& step : result.load_steps) add_one(hash_of(step));
        add_one(hash_of(result.solution));
    }
    [[nodiscard]] bool is_outdated(const mechanics::Solution& solution) const {
        const std::size_t hash = hash_of(solution);
        return std::ranges::any_of(
            given_, [hash](const Given& given) { return given.is_outdated && given.hash == hash; });
    }

  private:
    static constexpr std::size_t kMost = 10'000;
    struct Given {
        std::size_t hash;
        bool is_outdated = false;
    };

    void outdate() {
        for (Given& given : given_) given.is_outdated = true;
    }
    /// Equal displacements may be those of other tiles, too: without loads, all are zero.
    void add_one(std::size_t hash) {
        std::erase_if(given_, [hash](const Given& given) { return given.hash == hash; });
        given_.push_back({hash});
        if (given_.size() > kMost) given_.pop_front();
    }

    std::deque<Given> given_;
    std::vector<TileIndex> full_tiles_;  ///< of the newest solution
    bool are_tiles_edited_ = false;      ///< true if they were edited after the newest solution
};

Session::Session(Surface surface, LoadCase load_case, SimulationOptions options,
                 CalibrationSource calibrations)
    : given_(std::make_unique<GivenSolutions>()) {
    const bool is_mixed = mixed_share(options.model).has_value();
    options.validate(surface);
    SimulationOptions plain = options;
    if (is_mixed) plain.model = kMixedTiles;
    impl_ = std::make_unique<Impl>(std::move(surface), std::move(load_case), std::move(plain),
                                   std::move(calibrations));
    if (is_mixed) mixture_ = std::make_unique<Mixture>(*impl_, options);
}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

/// If the corotational tiles refuse an edit, the mixture does not get it.
template <class Edit>
void Session::edit(const Edit& edit) {
    edit(*impl_);
    if (mixture_) edit(mixture_->impl());
}

template <class Edit>
void Session::edit_tiles(const Edit& change) {
    edit(change);
    given_->note_edit();
}

/// The data that belong to the last solution.
Session::Impl& Session::answering() const {
    return mixture_ && !mixture_->full_tiles().empty() ? mixture_->impl() : *impl_;
}

const Surface& Session::surface() const {
    return impl_->surface();
}
const LoadCase& Session::load_case() const {
    return impl_->load_case();
}
const SimulationOptions& Session::options() const {
    return mixture_ ? mixture_->options() : impl_->options();
}
std::vector<TileIndex> Session::full_tiles() const {
    return mixture_ ? mixture_->full_tiles() : std::vector<TileIndex>{};
}
const SurfaceResult* Session::corotational_result() const {
    return mixture_ ? &mixture_->corotational() : nullptr;
}
std::optional<reduction::BeamMotion> Session::beam_motion(tiling::TileIndex tile,
                                                          const mechanics::Solution& solution) const {
    return answering().beam_motion(tile, solution);
}
std::optional<mechanics::NodeValues> Session::motion_gradient(tiling::TileIndex tile,
                                                              const mechanics::Solution& solution,
                                                              const mechanics::NodeValues& by_beams) const {
    return answering().motion_gradient(tile, solution, by_beams);
}
const Session::Report& Session::last_report() const {
    return mixture_ ? mixture_->last_report() : impl_->last_report();
}

void Session::paint(std::span<const TileIndex> tiles, const std::string& pattern) {
    edit_tiles([&](Impl& impl) { impl.paint(tiles, pattern); });
}
void Session::turn(std::span<const TileIndex> tiles, int vertices) {
    edit_tiles([&](Impl& impl) { impl.turn(tiles, vertices); });
}
void Session::set_tile_model(std::span<const TileIndex> tiles, const std::string& model) {
    edit_tiles([&](Impl& impl) { impl.set_tile_model(tiles, model); });
}
void Session::set_model(const std::string& model) {
    if (!mixed_share(model)) {
        impl_->set_model(model);
        mixture_.reset();
        given_->note_edit();
        return;
    }
    SimulationOptions edited = options();
    edited.model = model;
    edited.validate(surface());
    // Corotational tiles, and their last equilibrium, serve the mixed model as they are.
    if (impl_->options().model != kMixedTiles) impl_->set_model(kMixedTiles);
    mixture_ = std::make_unique<Mixture>(*impl_, edited);
    impl_->forget_solution();
    given_->note_edit();
}
void Session::set_setting(const reduction::Setting& setting) {
    edit_tiles([&](Impl& impl) { impl.set_setting(setting); });
}
void Session::set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations) {
    edit_tiles([&](Impl& impl) { impl.set_calibrations(calibrations); });
}
void Session::set_load_case(const LoadCase& load_case) {
    edit([&](Impl& impl) { impl.set_load_case(load_case); });
}

void Session::set_support(std::size_t entry, const LoadCase::Support& support) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.supports, entry, support, "support");
    set_load_case(edited);
}
void Session::set_load(std::size_t entry, const LoadCase::Load& load) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.loads, entry, load, "load");
    set_load_case(edited);
}
void Session::set_prescribed(std::size_t entry, const LoadCase::PrescribedDisplacement& displacement) {
    LoadCase edited = impl_->load_case();
    set_entry(edited.prescribed, entry, displacement, "prescribed displacement");
    set_load_case(edited);
}

void Session::require_since_edit(const mechanics::Solution& solution) const {
    answering().require_since_edit(solution);
    if (!given_->is_outdated(solution)) return;
    throw base::InputError(
        "this is a solution that the session gave before its last edit; solve() gives another");
}
std::vector<TileDeformation> Session::tile_deformations(const mechanics::Solution& solution,
                                                        const base::Control& control) const {
    return answering().tile_deformations(solution, control);
}
Linearization Session::linearize(TileQuantities quantities, const base::Control& control) {
    return answering().linearize(quantities, control);
}
Sensitivity Session::sensitivity(const mechanics::NodeValues& gradient, const base::Control& control) {
    return answering().sensitivity(gradient, control);
}
mechanics::NodeValues Session::energy_gradient(const mechanics::Solution& solution) const {
    require_since_edit(solution);
    return answering().energy_gradient(solution);
}
Eigen::MatrixXd Session::solve_adjoint(const Eigen::MatrixXd& rows, const base::Control& control) {
    return answering().solve_adjoint(rows, control);
}
SurfaceResult Session::solve(const base::Control& control, mechanics::StabilityCheck check,
                             const mechanics::FirstIterate& first_iterate) {
    SurfaceResult result =
        mixture_ ? mixture_->solve(*impl_, control, check) : impl_->solve(control, check, first_iterate);
    given_->add(result, full_tiles());
    return result;
}

}  // namespace fretwork::simulation
