// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/tiling/painting.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

namespace fretwork::simulation {
namespace {

using Clock = std::chrono::steady_clock;
using tiling::TileIndex;

void require_tiles(const Surface& surface, std::span<const TileIndex> tiles) {
    const auto count = std::ssize(surface.tessellation.tiles);
    for (const TileIndex tile : tiles) {
        if (tile.value >= 0 && tile.value < count) continue;
        throw base::InputError("there is no tile " + std::to_string(tile.value) + "; they run from 0 to " +
                               std::to_string(count - 1));
    }
}

/// Whether elements have the nodes of others in the same order: then a solver's layout holds for them, too.
bool connect_the_same(std::span<const std::shared_ptr<const mechanics::Element>> elements,
                      std::span<const std::shared_ptr<const mechanics::Element>> others) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!std::ranges::equal(elements[i]->nodes(), others[i]->nodes())) return false;
    }
    return true;
}

Session::Work::Factors factors_of(mechanics::FactorChange change) {
    switch (change) {
        case mechanics::FactorChange::Kept:
            return Session::Work::Factors::Kept;
        case mechanics::FactorChange::Updated:
            return Session::Work::Factors::Updated;
        case mechanics::FactorChange::Anew:
            break;
    }
    return Session::Work::Factors::Anew;
}

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

class Session::Impl {
  public:
    Impl(Surface surface, LoadCase load_case, SimulationOptions options, CalibrationSource calibrations)
        : surface_(std::move(surface)),
          load_case_(std::move(load_case)),
          options_(std::move(options)),
          calibration_source_(std::move(calibrations)) {
        check(surface_, options_);
        conditions_ = resolved(load_case_);
    }

    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] const LoadCase& load_case() const { return load_case_; }
    [[nodiscard]] const SimulationOptions& options() const { return options_; }
    [[nodiscard]] const Work& last_work() const { return work_; }

    void paint(std::span<const TileIndex> tiles, const std::string& id);
    void turn(std::span<const TileIndex> tiles, int vertices);
    void set_tile_model(std::span<const TileIndex> tiles, const std::string& name);
    void set_model(const std::string& name);
    void set_setting(const reduction::Setting& setting);
    void set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations);
    void set_load_case(const LoadCase& load_case);

    mechanics::Result solve(const base::Control& control);
    Eigen::MatrixXd solve_adjoint(const Eigen::MatrixXd& rows);

  private:
    [[nodiscard]] ModelChoice choice() const { return {options_.model, options_.models}; }
    [[nodiscard]] Conditions resolved(const LoadCase& load_case);
    [[nodiscard]] std::size_t palette_entry(const std::string& id) const;
    void invalidate_tiles(std::span<const TileIndex> tiles);
    void invalidate_all_tiles();
    void weigh_anew();

    void update_tiles(const base::Control& control);
    void build_all(const base::Control& control);
    void join();
    bool replace_elements(std::span<const TileIndex> tiles, std::span<const detail::BuiltTile> built);
    void update_conditions();
    void update_factors(const base::Control& control);
    [[nodiscard]] bool is_nonlinear() const;
    [[nodiscard]] mechanics::Result make_result() const;
    void solve_path(mechanics::Result& result, const base::Control& control) const;

    Surface surface_;
    LoadCase load_case_;
    SimulationOptions options_;
    CalibrationSource calibration_source_;
    Conditions conditions_;
    std::optional<std::vector<double>> tile_masses_;

    detail::TileBuilder builder_;
    std::vector<detail::BuiltTile> tiles_;  ///< empty: all are to be built
    std::set<TileIndex> changed_tiles_;     ///< of those that were built
    detail::JoinedTiles joined_;
    mechanics::Assembly assembly_;
    std::size_t tile_supports_ = 0;  ///< of the assembly: those inside of tiles come first
    std::optional<mechanics::LinearSolver> solver_;
    Work work_;
};

Conditions Session::Impl::resolved(const LoadCase& load_case) {
    const bool is_weighed = !load_case.gravity.isZero(0) && surface_.setting.material.density > 0.0;
    if (is_weighed && !tile_masses_) tile_masses_ = tile_masses(surface_);
    return resolve(load_case, surface_, is_weighed ? *tile_masses_ : std::vector<double>{});
}

/// The place of a pattern in the palette, or that behind its end.
std::size_t Session::Impl::palette_entry(const std::string& id) const {
    const std::vector<std::string>& palette = surface_.tessellation.patterns;
    return static_cast<std::size_t>(std::ranges::find(palette, id) - palette.begin());
}

void Session::Impl::paint(std::span<const TileIndex> tiles, const std::string& wanted) {
    require_tiles(surface_, tiles);
    const std::string id = tiling::make_palette(surface_.layout, std::vector{wanted}).front();
    const std::size_t entry = palette_entry(id);
    const bool is_new = entry == surface_.patterns.size();
    const auto calibrations = !is_new               ? surface_.calibrations[entry]
                              : calibration_source_ ? calibration_source_(id)
                                                    : std::vector<reduction::Calibration>{};
    for (const TileIndex tile : tiles)
        (void)detail::calibrated_parameters(calibrations, id, tile_model(surface_, choice(), tile));
    if (is_new) {
        surface_.tessellation.patterns.push_back(id);
        surface_.patterns.push_back(pattern::parse_pattern_id(surface_.layout, id));
        surface_.calibrations.push_back(calibrations);
    }
    for (const TileIndex tile : tiles)
        surface_.tessellation.tiles[static_cast<std::size_t>(tile)].pattern = static_cast<int>(entry);
    invalidate_tiles(tiles);
    weigh_anew();
}

void Session::Impl::turn(std::span<const TileIndex> tiles, int vertices) {
    require_tiles(surface_, tiles);
    for (const TileIndex index : tiles) {
        tiling::Tile& tile = surface_.tessellation.tiles[static_cast<std::size_t>(index)];
        const auto sides = std::ssize(tile.vertices);
        const auto by = (vertices % sides + sides) % sides;
        const auto interface_nodes_a_side = std::ssize(tile.interface_nodes) / sides;
        std::ranges::rotate(tile.vertices, tile.vertices.begin() + by);
        std::ranges::rotate(tile.interface_nodes, tile.interface_nodes.begin() + by * interface_nodes_a_side);
    }
    invalidate_tiles(tiles);
    weigh_anew();
}

void Session::Impl::set_tile_model(std::span<const TileIndex> tiles, const std::string& name) {
    require_tiles(surface_, tiles);
    const reduction::TileModel& model =
        reduction::find_tile_model(name.empty() ? options_.model : name, options_.models);
    for (const TileIndex tile : tiles) (void)tile_parameters(surface_, tile, model);
    surface_.tile_models.resize(surface_.tessellation.tiles.size());
    for (const TileIndex tile : tiles) surface_.tile_models[static_cast<std::size_t>(tile)] = name;
    invalidate_tiles(tiles);
}

void Session::Impl::set_model(const std::string& name) {
    SimulationOptions edited = options_;
    edited.model = name;
    check(surface_, edited);
    const ModelChoice wanted{name, options_.models};
    for (std::size_t t = 0; t < surface_.tessellation.tiles.size(); ++t) {
        const TileIndex tile(t);
        (void)tile_parameters(surface_, tile, tile_model(surface_, wanted, tile));
    }
    options_.model = name;
    invalidate_all_tiles();
}

void Session::Impl::set_setting(const reduction::Setting& setting) {
    setting.validate();
    reduction::Setting before = std::exchange(surface_.setting, setting);
    try {
        (void)resolve(load_case_, surface_, {});
    } catch (const base::Error&) {
        surface_.setting = std::move(before);
        throw;
    }
    builder_.forget();
    invalidate_all_tiles();
    weigh_anew();
}

void Session::Impl::set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations) {
    if (calibrations.size() != surface_.patterns.size())
        throw base::InputError("there are calibrations of " + std::to_string(calibrations.size()) +
                               " patterns, where the surface has " +
                               std::to_string(surface_.patterns.size()));
    surface_.calibrations = std::move(calibrations);
    builder_.forget();
    invalidate_all_tiles();
}

void Session::Impl::set_load_case(const LoadCase& load_case) {
    conditions_ = resolved(load_case);
    load_case_ = load_case;
}

void Session::Impl::invalidate_tiles(std::span<const TileIndex> tiles) {
    changed_tiles_.insert(tiles.begin(), tiles.end());
}

void Session::Impl::invalidate_all_tiles() {
    tiles_.clear();
    changed_tiles_.clear();
}

void Session::Impl::weigh_anew() {
    tile_masses_.reset();
    if (!load_case_.gravity.isZero(0)) conditions_ = resolved(load_case_);
}

void Session::Impl::build_all(const base::Control& control) {
    tiles_ = builder_.build_all(surface_, choice(), {options_.threads, control});
    changed_tiles_.clear();
    join();
}

void Session::Impl::join() {
    solver_.reset();
    joined_ = detail::join_tiles(surface_, tiles_);
    assembly_ = reduction::assemble(joined_.parts);
    tile_supports_ = assembly_.supports.size();
}

/// False if a tile has other nodes now, or in another order, or beams: then the structure is joined anew.
bool Session::Impl::replace_elements(std::span<const TileIndex> tiles,
                                     std::span<const detail::BuiltTile> built) {
    std::vector<mechanics::Elements> replacements;
    const std::size_t first = assembly_.elements.size() - joined_.parts.elements.size();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        auto elements = detail::replacement(joined_, surface_, tiles[i], built[i]);
        const auto start = joined_.starts[static_cast<std::size_t>(tiles[i])].element;
        const auto present = std::span(assembly_.elements).subspan(first + start);
        if (!elements || !connect_the_same(*elements, present)) return false;
        replacements.push_back(std::move(*elements));
    }
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const auto start = joined_.starts[static_cast<std::size_t>(tiles[i])].element;
        std::ranges::copy(replacements[i],
                          assembly_.elements.begin() + static_cast<std::ptrdiff_t>(first + start));
    }
    return true;
}

void Session::Impl::update_tiles(const base::Control& control) {
    if (tiles_.empty()) return build_all(control);
    if (changed_tiles_.empty()) return;
    const std::vector<TileIndex> tiles(changed_tiles_.begin(), changed_tiles_.end());
    std::vector<detail::BuiltTile> built =
        builder_.build({surface_, choice(), tiles}, {options_.threads, control});
    const bool has_the_same_nodes = replace_elements(tiles, built);
    for (std::size_t i = 0; i < tiles.size(); ++i)
        tiles_[static_cast<std::size_t>(tiles[i])] = std::move(built[i]);
    changed_tiles_.clear();
    if (!has_the_same_nodes) join();
}

void Session::Impl::update_conditions() {
    assembly_.supports.resize(tile_supports_);
    apply(conditions_, assembly_);
}

void Session::Impl::update_factors(const base::Control& control) {
    if (solver_) {
        work_.factors = factors_of(solver_->update(assembly_, control));
        return;
    }
    solver_.emplace(assembly_, mechanics::LinearOptions{.threads = options_.threads, .control = control});
    work_.factors = Work::Factors::Anew;
}

bool Session::Impl::is_nonlinear() const {
    return simulation::is_nonlinear(surface_, options_);
}

mechanics::Result Session::Impl::make_result() const {
    mechanics::Result result;
    const auto interface_count = static_cast<int>(surface_.tessellation.interface_nodes.size());
    for (int i = 0; i < assembly_.reported_nodes; ++i)
        result.nodes.push_back({i, assembly_.nodes[static_cast<std::size_t>(i)], i < interface_count});
    return result;
}

void Session::Impl::solve_path(mechanics::Result& result, const base::Control& control) const {
    mechanics::Result path = mechanics::solve(assembly_, {.solver = mechanics::Solver::Newton,
                                                          .steps = options_.load_steps,
                                                          .threads = options_.threads,
                                                          .locate_critical_loads = false,
                                                          .control = control});
    result.load_steps = std::move(path.load_steps);
    result.solution = std::move(path.solution);
}

mechanics::Result Session::Impl::solve(const base::Control& control) {
    check(surface_, options_);
    const auto started = Clock::now();
    const std::size_t built_before = builder_.built_count();
    update_tiles(control);
    update_conditions();
    work_ = {.tiles_built = builder_.built_count() - built_before};
    mechanics::Result result = make_result();
    result.solver = is_nonlinear() ? "newton" : "linear";
    if (is_nonlinear()) {
        solve_path(result, control);
    } else {
        update_factors(control);
        result.solution = solver_->solve(assembly_.loads, control);
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - started).count();
    if (options_.estimate_error)
        result.discretization_error =
            mechanics::estimate_discretization_error(surface_frame(surface_, choice(), conditions_),
                                                     mechanics::even_load_factors(options_.load_steps),
                                                     result.load_steps, {.threads = options_.threads})
                .back();
    if (options_.load_steps == 1) result.load_steps.clear();
    return result;
}

Eigen::MatrixXd Session::Impl::solve_adjoint(const Eigen::MatrixXd& rows) {
    update_tiles({});
    update_conditions();
    update_factors({});
    const auto nodes = static_cast<Eigen::Index>(assembly_.nodes.size());
    if (rows.rows() != nodes * mechanics::kDofsPerNode)
        throw base::InputError("the right sides have " + std::to_string(rows.rows()) +
                               " rows, where six are needed for each of the " + std::to_string(nodes) +
                               " nodes");
    // What is prescribed moves the structure under any load: only the difference is K^-1 g.
    const auto answer_to = [&](const mechanics::NodeValues& loads) {
        const mechanics::Solution solution = solver_->solve(loads);
        mechanics::NodeValues all(nodes, mechanics::kDofsPerNode);
        all << solution.displacements, solution.inner_displacements;
        return all;
    };
    const mechanics::NodeValues zero = mechanics::NodeValues::Zero(nodes, mechanics::kDofsPerNode);
    const mechanics::NodeValues without = assembly_.prescribed.empty() ? zero : answer_to(zero);
    Eigen::MatrixXd answers(rows.rows(), rows.cols());
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
        const Eigen::VectorXd column = rows.col(i);
        const mechanics::NodeValues answer =
            answer_to(column.reshaped<Eigen::RowMajor>(nodes, mechanics::kDofsPerNode)) - without;
        answers.col(i) = answer.reshaped<Eigen::RowMajor>();
    }
    return answers;
}

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

Eigen::MatrixXd Session::solve_adjoint(const Eigen::MatrixXd& rows) {
    return impl_->solve_adjoint(rows);
}
mechanics::Result Session::solve(const base::Control& control) {
    return impl_->solve(control);
}

}  // namespace fretwork::simulation
