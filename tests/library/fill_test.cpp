// SPDX-License-Identifier: GPL-3.0-or-later
// Filling a library gives the same content with any threads, after kills, by shards, and after a full disk.
#include "process.hpp"
#include "sample.hpp"

#include <fretwork/library/fill.hpp>
#include <fretwork/library/merge.hpp>
#include <fretwork/library/statistics.hpp>
#include <fretwork/reduction/calibration/calibration_problem.hpp>

#include <atomic>
#include <pthread.h>
#include <thread>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;
using Paths = std::vector<std::filesystem::path>;

const std::vector<std::string>& ids() {
    static const std::vector<std::string> list = {"0-1+1-6", "0-1+3-6", "1-3+1-6",     "1-3+3-6",
                                                  "1-6+3-6", "2-4+2-6", "0-1+1-2+2-6", "0-1+1-3+1-6"};
    return list;
}

FillOptions quick(int threads = 2) {
    FillOptions options;
    options.calibration.starts = 1;
    options.threads = threads;
    options.seconds_between_stores = 0.0;
    return options;
}

FillReport fill_all(Library& library, const FillOptions& options = quick()) {
    return fill(library, library.patterns(), options);
}

/// Does something once, when a given number of patterns is done.
class WhenDone final : public base::Progress {
  public:
    WhenDone(std::size_t count, std::function<void()> action) : count_(count), action_(std::move(action)) {}
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t done) override {
        if (done >= count_ && action_) std::exchange(action_, nullptr)();
    }
    void finish() override {}

  private:
    std::size_t count_;
    std::function<void()> action_;
};

/// Begin to fill a library in a process of its own, which is killed as soon as its first pattern is done; in
/// later runs somewhere after its first patterns, wherever it then is.
void fill_until_killed(const std::filesystem::path& path, int run) {
    status_of([&] {
        Library library = Library::open(path, Access::ReadWrite);
        const std::size_t last = 1 + static_cast<std::size_t>(run % 3);
        const auto delay = static_cast<useconds_t>(7919 * run % 20'000);
        WhenDone kill_soon(last, [delay] {
            if (delay == 0) ::kill(::getpid(), SIGKILL);
            std::thread([delay] {
                ::usleep(delay);
                ::kill(::getpid(), SIGKILL);
            }).detach();
        });
        FillOptions options = quick(1);
        options.control.progress = &kill_soon;
        fill_all(library, options);
    });
}

/// A search for the factor of a tile that is refused wherever it begins.
class DeadProblem final : public reduction::CalibrationProblem {
  public:
    explicit DeadProblem(double value) : value_(value) {}
    [[nodiscard]] std::string name() const override { return "dead"; }
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(optimization::Evaluation kind) const override {
        return kind == optimization::Evaluation::Value || kind == optimization::Evaluation::Gradient;
    }
    [[nodiscard]] double value(const Eigen::VectorXd&) const override { return value_; }
    [[nodiscard]] optimization::GradientEvaluation gradient(const Eigen::VectorXd& point,
                                                            double) const override {
        return {value_, value_, NAN * point};
    }
    [[nodiscard]] std::vector<double> parameter_values(const Eigen::VectorXd& point) const override {
        return {point.data(), point.data() + point.size()};
    }
    [[nodiscard]] reduction::UnitDisplacements displacements(const Eigen::VectorXd&) const override {
        return {};
    }

  private:
    double value_;
    optimization::Bounds bounds_{Eigen::VectorXd::Constant(6, -1.0), Eigen::VectorXd::Ones(6)};
};

/// The paper's model, with a search that gives this value and no slope.
reduction::TileModel dead_model(double value) {
    reduction::TileModel model = reduction::find_tile_model("paper6");
    model.name = "dead";
    model.problem = [value](const auto&...) { return std::make_unique<DeadProblem>(value); };
    return model;
}

class Fill : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path(const std::string& name = "lib.db") const {
        return folder_.path() / name;
    }
    /// The tables of the library after an uninterrupted run.
    [[nodiscard]] static std::vector<std::pair<std::string, std::string>> undisturbed() {
        const TemporaryFolder folder;
        Library library = make_library(folder.path() / "lib.db", ids());
        fill_all(library, quick(1));
        library.export_csv(folder.path() / "csv");
        return folder_content(folder.path() / "csv");
    }
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> tables(const std::string& name) const {
        Library::open(path(name)).export_csv(path(name + ".csv"));
        return folder_content(path(name + ".csv"));
    }
    TemporaryFolder folder_;
};

TEST_F(Fill, GivesEachPatternResponsesPropertiesAndACalibration) {
    Library library = make_library(path(), ids());
    const FillReport report = fill_all(library);
    EXPECT_EQ(report.open, ids().size());
    EXPECT_EQ(report.done, ids().size());
    EXPECT_EQ(report.failed, 0U);
    EXPECT_EQ(library.responses("1-3+1-6").size(), 5U);
    EXPECT_EQ(library.properties("1-3+1-6").size(), 21U);
    const auto calibrations = library.calibrations("1-3+1-6");
    ASSERT_EQ(calibrations.size(), 1U);
    EXPECT_EQ(calibrations[0].key(), quick().key());
    EXPECT_EQ(fill_all(library).open, 0U) << "there is nothing left to do";
}

TEST_F(Fill, ASearchAllOfWhoseStartsDiedIsAFailureAndNoCalibration) {
    for (const auto& [value, reason] :
         {std::pair(4170.0, "all 3 starts of slsqp died"),
          std::pair(HUGE_VAL, "of model dead is not finite at any point that was tried")}) {
        std::filesystem::remove(path());
        Library library = make_library(path(), {"0-1+1-6", "1-3+1-6"});
        FillOptions options = quick();
        const std::vector<reduction::TileModel> models = {dead_model(value)};
        options.models = models;
        options.model = "dead";
        options.calibration.optimizer = "slsqp";
        options.calibration.starts = 3;
        const FillReport report = fill_all(library, options);
        EXPECT_EQ(report.done, 0U);
        EXPECT_EQ(report.failed, 2U);
        EXPECT_TRUE(library.calibrations("0-1+1-6").empty());
        ASSERT_EQ(library.failures().size(), 2U);
        EXPECT_EQ(library.failures()[0].computation, calibration_computation(options.key()));
        EXPECT_THAT(library.failures()[0].reason, HasSubstr(reason));
    }
}

TEST_F(Fill, AnotherCalibrationUsesTheStoredResponses) {
    Library library = make_library(path(), {"0-1+1-6"});
    fill_all(library);
    FillOptions options = quick();
    options.calibration.seed = 2;
    EXPECT_EQ(fill_all(library, options).done, 1U);
    options.model = "condensed";
    EXPECT_EQ(fill_all(library, options).done, 1U);
    EXPECT_EQ(library.calibrations("0-1+1-6").size(), 3U);
}

TEST_F(Fill, GivesTheSameTablesAfterTenKillsAsWithoutAny) {
    make_library(path(), ids());
    std::size_t left_half_way = 0;
    for (int kill = 0; kill < 10; ++kill) {
        fill_until_killed(path(), kill);
        const std::size_t open = Library::open(path()).patterns_without_calibration(quick().key()).size();
        left_half_way += open > 0 && open < ids().size() ? 1 : 0;
    }
    EXPECT_GT(left_half_way, 0U) << "no kill came when there was something to lose";
    Library library = Library::open(path(), Access::ReadWrite);
    fill_all(library);
    EXPECT_EQ(tables("lib.db"), undisturbed());
}

TEST_F(Fill, KeepsWhatIsDoneWhenStoppedAndContinuesThere) {
    Library library = make_library(path(), ids());
    std::stop_source stop;
    WhenDone ask_to_stop(1, [&] { stop.request_stop(); });
    FillOptions options = quick(1);
    options.control = {stop.get_token(), &ask_to_stop};
    const FillReport report = fill_all(library, options);
    EXPECT_EQ(report.open, ids().size());
    EXPECT_GE(report.done, 1U);
    EXPECT_LT(report.done, ids().size());
    EXPECT_EQ(report.failed, 0U);
    EXPECT_EQ(library.patterns_without_calibration(options.key()).size(), ids().size() - report.done);
    EXPECT_EQ(fill_all(library).done, ids().size() - report.done);
    EXPECT_EQ(tables("lib.db"), undisturbed());
}

TEST_F(Fill, ShardsMergeToTheTablesOfOneRun) {
    Paths shards;
    for (std::size_t part = 0; part < 3; ++part) {
        shards.push_back(path("shard" + std::to_string(part) + ".db"));
        Library library = make_library(shards.back(), ids());
        std::vector<pattern::NamedPattern> own;
        const auto all = library.patterns();
        for (std::size_t i = part; i < all.size(); i += 3) own.push_back(all[i]);
        EXPECT_EQ(fill(library, own, quick(static_cast<int>(part) + 1)).done, own.size());
    }
    merge(path("merged.db"), shards);
    EXPECT_EQ(tables("merged.db"), undisturbed());
}

TEST_F(Fill, AFullDiskIsAnErrorAndWhatWasStoredStays) {
    make_library(path(), ids());
    const auto room = std::filesystem::file_size(path()) + 90'000;
    const int status = status_of([&] {
        limit_files(room, SIG_IGN);
        try {
            Library library = Library::open(path(), Access::ReadWrite);
            fill_all(library);
        } catch (const base::IoError&) {
            ::_exit(3);
        }
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3);
    Library library = Library::open(path(), Access::ReadWrite);
    const std::size_t open = library.patterns_without_calibration(quick().key()).size();
    EXPECT_GT(open, 0U);
    EXPECT_LT(open, ids().size()) << "the disk was full too early to mean something";
    EXPECT_EQ(fill_all(library).done, open);
    EXPECT_EQ(tables("lib.db"), undisturbed());
}

TEST_F(Fill, APatternThatFailsIsRecordedAndDoesNotStopTheRest) {
    // The responses can be computed; the model cannot be built.
    reduction::TileModel model;
    model.name = "impossible";
    model.build = [](const reduction::TileInput&) -> std::shared_ptr<const reduction::TileStructure> {
        throw base::GeometryError("there is no such tile");
    };
    FillOptions options = quick();
    options.model = model.name;
    options.models = {&model, 1};
    Library library = make_library(path(), {"0-1+1-6", "1-3+1-6"});
    const FillReport report = fill_all(library, options);
    EXPECT_EQ(report.done, 0U);
    EXPECT_EQ(report.failed, 2U);
    ASSERT_EQ(library.failures().size(), 2U);
    EXPECT_EQ(library.failures()[0].computation, calibration_computation(options.key()));
    EXPECT_THAT(library.failures()[0].reason, HasSubstr("there is no such tile"));
    EXPECT_EQ(library.responses("0-1+1-6").size(), 5U) << "what worked is kept";
    EXPECT_EQ(fill_all(library, options).open, 0U) << "it is not tried again";
    library.forget_failures();
    EXPECT_EQ(fill_all(library, options).open, 2U) << "unless that is asked for";
}

TEST_F(Fill, RefusesOptionsThatMakeNoSense) {
    Library library = make_library(path(), {"0-1+1-6"});
    FillOptions options = quick();
    options.model = "paper7";
    EXPECT_THAT(complaint_of([&] { fill_all(library, options); }), HasSubstr("did you mean"));
    options = quick(-1);
    EXPECT_THAT(complaint_of([&] { fill_all(library, options); }), HasSubstr("threads"));
}

/// Stacks larger than the address space stand for a limit on threads, which does not hold for root.
TEST_F(Fill, SaysThatNoThreadCanBeStarted) {
    Library library = make_library(path(), {"0-1+1-6"});
    pthread_attr_t usual;
    ASSERT_EQ(::pthread_getattr_default_np(&usual), 0);
    pthread_attr_t huge;
    ASSERT_EQ(::pthread_attr_init(&huge), 0);
    ASSERT_EQ(::pthread_attr_setstacksize(&huge, std::size_t{1} << 60U), 0);
    ASSERT_EQ(::pthread_setattr_default_np(&huge), 0);
    EXPECT_THAT(complaint_of([&] { fill_all(library); }), HasSubstr("no thread can be started"));
    ASSERT_EQ(::pthread_setattr_default_np(&usual), 0);
    ::pthread_attr_destroy(&huge);
    ::pthread_attr_destroy(&usual);
    EXPECT_EQ(fill_all(library).done, 1U);
}

TEST_F(Fill, StatisticsAreThoseOfTheStoredCalibrations) {
    Library library = make_library(path(), {"0-1+1-6", "1-6+3-6", "0-1+1-5+5-6+3-6"});
    for (const auto& [id, seed] : {std::pair{"0-1+1-6", 0.5}, {"1-6+3-6", 0.25}})
        library.store(std::vector{sample_data(id, seed)});  // objective 1 / seed
    const auto statistics =
        calibration_statistics(library, library.patterns(), sample_calibration(1.0).key());
    EXPECT_EQ(statistics.calibrated, 2U);
    EXPECT_DOUBLE_EQ(statistics.mean, 3.0);
    EXPECT_DOUBLE_EQ(statistics.deviation, 1.0);
    EXPECT_DOUBLE_EQ(statistics.median, 3.0);
    EXPECT_EQ(statistics.at_bound.at("theta"), 2U);
    EXPECT_EQ(statistics.samples, 100U);
    EXPECT_EQ(statistics.converged, 90U);
    EXPECT_EQ(statistics.limit_load, 10U);
    EXPECT_EQ(statistics.unstable, 10U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::library
