// SPDX-License-Identifier: GPL-3.0-or-later
// A server in this process, and projects that it shows.
#pragma once

#include "client.hpp"
#include "simulation/honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/project/project_file.hpp>
#include <studio/studio.hpp>

#include <memory>
#include <optional>
#include <thread>

namespace fretwork::test {

inline simulation::Project studio_project(int columns = 4, int rows = 3) {
    simulation::Project project = honeycomb(columns, rows, {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"});
    project.load_cases.push_back(cantilever({0.0, 0.0, -0.01}));
    project.load_cases.front().gravity = {0.0, 0.0, -0.5};
    project.setting = reduction::paper_setting();
    return project;
}

/// A server that runs while this lives.
class RunningStudio {
  public:
    RunningStudio() : RunningStudio(std::optional<simulation::Project>{}) {}
    explicit RunningStudio(const std::optional<simulation::Project>& project) {
        if (project) simulation::write_project(*project, project_file());
        start(project.has_value());
    }
    RunningStudio(const RunningStudio&) = delete;
    RunningStudio& operator=(const RunningStudio&) = delete;
    ~RunningStudio() { stop(); }

    [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
    [[nodiscard]] std::filesystem::path project_file() const { return folder_.path() / "project.json"; }
    [[nodiscard]] StudioAddress address() const { return StudioAddress(studio_->address()); }
    [[nodiscard]] int port() const { return address().port; }
    [[nodiscard]] std::string token() const { return address().token; }
    /// Another server of the same project and state.
    void restart() {
        stop();
        start(std::filesystem::exists(project_file()));
    }

  private:
    void start(bool has_project) {
        studio::StudioOptions options{.page = folder_.path() / "page.html",
                                      .state_folder = folder_.path() / "state"};
        if (has_project) options.project = project_file();
        studio_ = std::make_unique<studio::Studio>(options);
        thread_ = std::thread([this] { studio_->run(); });
    }
    void stop() {
        if (!thread_.joinable()) return;
        studio_->stop();
        thread_.join();
        studio_.reset();
    }

    TemporaryFolder folder_;
    std::unique_ptr<studio::Studio> studio_;
    std::thread thread_;
};

}  // namespace fretwork::test
