// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/designing/designs.hpp>
#include <studio/document/kept_work.hpp>
#include <studio/document/retiling.hpp>
#include <studio/files/exported_file.hpp>
#include <studio/files/saving.hpp>
#include <studio/server/pages.hpp>
#include <studio/solving/error_watch.hpp>
#include <studio/solving/live_view.hpp>
#include <studio/solving/long_jobs.hpp>
#include <studio/solving/making_watch.hpp>
#include <studio/studio.hpp>

#include <map>
#include <span>

namespace fretwork::studio {

/// The requests of Studio: each changes the document, or asks one of the objects below for something.
/// Everything here runs on the server's thread, except work that is handed to other threads; its outcome
/// comes back by post().
class Studio::Impl final : public Service {
  public:
    explicit Impl(const StudioOptions& options);
    ~Impl() override;

    [[nodiscard]] std::string address() const;
    [[nodiscard]] const std::string& warning() const { return kept_.trouble(); }
    void run() { server_.run(); }
    void stop() { server_.stop(); }

    void get(const Target& target, std::function<void(HttpAnswer)> answer) override;
    void connected(ClientId client) override;
    void disconnected(ClientId client) override;
    void received(ClientId client, std::string_view message) override;

  private:
    using Handler = void (Impl::*)(const Request&);
    struct RequestRow {
        std::string_view name;
        Handler handle;
    };
    static std::span<const RequestRow> requests();
    void dispatch(const Request& request);

    // studio_document.cpp: the document that is shown, and its edits
    void hello(const Request& request);
    void show_fields(const Request& request);
    void undo(const Request& request);
    void redo(const Request& request);
    void select_load_case(const Request& request);
    [[nodiscard]] Document& document();
    /// The revision of the shown document; 0: there is none.
    [[nodiscard]] std::int64_t revision() const { return document_ ? document_->revision() : 0; }
    [[nodiscard]] std::int64_t next_revision() const { return revision() + 1; }
    void warn(const std::string& text);
    void show(Opened next);
    /// Show another document. The unsaved changes of the present one stay recoverable, or are given up if the
    /// request says so.
    void replace(const Request& request, Opened next);
    /// After each edit: keep it, and show it and its solution.
    void follow_change(const State& before);
    void solve_live();
    [[nodiscard]] SolverListener listener();
    void take_solution(const SolvedPtr& solved);
    void take_failure(const SolverInput& input, const std::string& error);
    void send_solution(ClientId client);

    // studio_jobs.cpp: jobs that take long
    [[nodiscard]] LongJob make_job(const Request& request, const std::string& model);
    void solve(const Request& request);
    void path(const Request& request);
    void modes(const Request& request);
    void buckling(const Request& request);
    void find_modes(const Request& request, simulation::ModeKind kind);
    void compare(const Request& request);
    void cancel(const Request& request);

    // studio_design.cpp: paintings for a wanted shape
    void begin_design(const Request& request);
    void stop_design(const Request& request);
    void take_design(const DesignFound& found);

    // studio_retile.cpp: other tiles for the outline
    void retile(const Request& request);

    // studio_layouts.cpp: node layouts that are drawn; the page keeps them
    void open_layout(const Request& request);
    void draw_layout(const Request& request);
    void count_layout(const Request& request);
    void save_layout(const Request& request);

    // studio_files.cpp: documents from files, and files from documents
    void make_new(const Request& request);
    void measure(const Request& request);
    void open(const Request& request);
    void upload(const Request& request);
    void download(const Request& request);
    void save(const Request& request);
    /// Refuse the request and return true if the file exists and its hash is neither `known` nor the
    /// request's `replaces`. A page takes that hash from an earlier refusal, after people have confirmed it.
    bool refuses_to_replace(const Request& request, Conflict conflict,
                            const std::optional<std::string>& known = {});
    void folder(const Request& request);
    void patterns(const Request& request);
    void recover(const Request& request);
    void recoverable(const Request& request);
    void forget(const Request& request);
    /// The document of a file without its unsaved changes.
    [[nodiscard]] Document document_in(const std::filesystem::path& file) const;
    [[nodiscard]] Opened read_document(const std::filesystem::path& path);
    [[nodiscard]] std::optional<Document> find_saved(const std::optional<std::filesystem::path>& file);
    [[nodiscard]] Opened recovered(const Recoverable& found);
    /// A file that a browser asks for with /export, and the receiver of the answer.
    struct ExportRequest {
        ExportTarget target;
        std::function<void(HttpAnswer)> answer;
    };
    void export_file(ExportRequest request);
    /// Answer the exports that waited for the live solver.
    void resume_exports();
    void refuse_waiting_exports(const std::string& reason);
    [[nodiscard]] HttpAnswer page() const;

    StudioOptions options_;
    std::string token_;
    HttpServer server_;
    Pages pages_;
    std::optional<Document> document_;
    KeptWork kept_;
    LiveView view_;
    std::vector<ExportRequest> waiting_exports_;
    RetilingPtr last_retiling_;  ///< null: none; the request after a preview wants the same tiles
    Background files_;           ///< work of a second or two
    /// The counts of patterns, by the page that wants them. A new count ends the one before.
    std::map<ClientId, Background> counts_;
    LongJobs jobs_;
    MakingWatch making_;
    ErrorWatch errors_;
    Designs designs_;
    LiveSolver solver_;
};

}  // namespace fretwork::studio
