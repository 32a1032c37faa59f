// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>
#include <studio/document/autosave.hpp>
#include <studio/document/document.hpp>
#include <studio/server/background.hpp>
#include <studio/server/http_server.hpp>
#include <studio/solving/live_solver.hpp>
#include <studio/studio.hpp>

#include <map>
#include <span>

namespace fretwork::studio {

/// The answer that a file is to show. Both parts are empty if nothing is loaded, or the file shows no answer.
struct AnswerToExport {
    SolvedPtr solved;
    std::string missing;  ///< the reason for a missing answer
};

/// The data and the requests of Studio. Everything here runs on the server's thread, except jobs that are
/// handed to other threads; these come back by post().
class Studio::Impl final : public Service {
  public:
    explicit Impl(const StudioOptions& options);
    ~Impl() override;

    [[nodiscard]] std::string address() const;
    [[nodiscard]] const std::string& warning() const { return no_autosave_; }
    void run() { server_.run(); }
    void stop() { server_.stop(); }

    void get(const Target& target, std::function<void(HttpAnswer)> answer) override;
    void connected(ClientId client) override;
    void disconnected(ClientId client) override;
    void received(ClientId client, std::string_view message) override;

  private:
    /// A request that waits for its answer.
    struct Request {
        ClientId client;
        base::Json id;  ///< null where the message does not say it
        base::JsonReader json;
    };
    using Handler = void (Impl::*)(const Request&);
    struct RequestRow {
        std::string_view name;
        Handler handle;
    };
    static std::span<const RequestRow> requests();

    // studio.cpp: messages and events
    void dispatch(const Request& request);
    void answer(const Request& request, base::Json members = base::Json::object());
    void refuse(ClientId client, const base::Json& id, const std::string& error);
    void broadcast(const Outgoing& outgoing);
    void broadcast(const base::Json& event);
    /// Work in another thread, whose outcome comes back to this one: an answer, or a refusal.
    void in_background(Background& thread, const Request& request,
                       std::function<std::function<void()>(const base::Control&)> work);

    // studio_document.cpp: the document and what is shown of it
    void hello(const Request& request);
    void undo(const Request& request);
    void redo(const Request& request);
    void select_load_case(const Request& request);
    void show_fields(const Request& request);
    [[nodiscard]] Document& document(const Request& request);
    [[nodiscard]] std::int64_t next_revision() const { return document_ ? document_->revision() + 1 : 1; }
    /// A document, and where it is kept while it is not saved; none: at a new place.
    struct Opened {
        Document document;
        std::optional<AutosavePlace> place{};
    };
    void show(Opened next);
    /// As the request says, what is not saved of the present document is given up before; else it stays
    /// recoverable.
    void replace(const Request& request, Opened next);
    /// Keep what is not saved.
    void keep();
    /// Whether something that was computed is of the document that is shown.
    [[nodiscard]] bool is_shown(std::int64_t revision) const;
    void tell_change(const State& before);
    void solve_live();
    void tell_beams(const ShownBeams& shown);
    void tell_solved(const SolvedPtr& solved);
    void tell_failed(const SolverInput& input, const std::string& error);
    /// Look in the background whether the painting can be made, once it rests; not again while it is the
    /// same.
    void check_making();
    void tell_making(const StatePtr& state, const base::Json& event);
    /// The last live solution, or the reason why there is none, for a page that has not seen it with the
    /// fields it shows.
    void send_solution(ClientId client);
    [[nodiscard]] BeamFields shown_fields() const;
    [[nodiscard]] SolverListener listener();

    // studio_jobs.cpp: what takes longer and is asked for
    struct Job {
        SolverInput input;
        std::shared_ptr<const simulation::SurfaceBeams> beams;
        std::int64_t beams_revision = 0;
        std::string model;
    };
    [[nodiscard]] Job make_job(const Request& request, const std::string& model);
    [[nodiscard]] static SolvedSurface solved_in(const Job& job, simulation::SurfaceResult result);
    /// The revision of the beams that are shown; -1 while those of the document are being built.
    [[nodiscard]] std::int64_t beams_revision_now() const;
    void start(const Request& request, Job job,
               std::function<std::vector<Outgoing>(const Job&, const base::Control&)> work);
    void solve(const Request& request);
    void path(const Request& request);
    void modes_of(const Request& request, simulation::ModeKind kind);
    void modes(const Request& request);
    void buckling(const Request& request);
    void compare(const Request& request);
    void cancel(const Request& request);

    // studio_recovery.cpp: what was not saved
    /// Nothing if the state folder takes no file; pages are told so.
    [[nodiscard]] std::optional<AutosavePlace> place_for(
        const std::optional<std::filesystem::path>& document);
    /// The document is saved, or given up.
    void forget_kept();
    /// The document of a file as it lies there.
    [[nodiscard]] Document document_in(const std::filesystem::path& file) const;
    /// The document of a file, with its unsaved changes if there are any.
    [[nodiscard]] Opened read_document(const std::filesystem::path& path);
    [[nodiscard]] base::Json recoverable_json() const;
    [[nodiscard]] Recoverable find(const base::JsonReader& key) const;
    [[nodiscard]] Opened recovered(const Recoverable& found);
    void recover(const Request& request);
    void recoverable(const Request& request);
    void forget(const Request& request);

    // studio_files.cpp: files
    void make_new(const Request& request);
    void measure(const Request& request);
    void open(const Request& request);
    void upload(const Request& request);
    void download(const Request& request);
    void save(const Request& request);
    /// A file that is there, and would be replaced.
    struct PresentFile {
        bool is_own;  ///< the document's
        std::string hash;
    };
    void refuse_to_replace(const Request& request, const std::filesystem::path& path,
                           const PresentFile& present);
    void patterns(const Request& request);
    /// A file that was asked for by its address, and where it goes.
    struct ExportRequest {
        Target target;
        std::function<void(HttpAnswer)> answer;
    };
    void export_file(ExportRequest request);
    /// Nothing as long as the live model is at work on it.
    [[nodiscard]] std::optional<AnswerToExport> answer_to_export() const;
    /// Those that waited for an answer, which is there now.
    void resume_exports();
    void refuse_waiting_exports(const std::string& reason);
    [[nodiscard]] HttpAnswer page() const;

    StudioOptions options_;
    std::string token_;
    HttpServer server_;
    std::map<ClientId, BeamFields> clients_;  ///< that have said hello, and the fields that each shows
    std::optional<Document> document_;
    std::int64_t first_revision_ = 0;  ///< of the document
    Outgoing beams_;                   ///< the last message of beams; a new client gets it, too
    SolvedPtr last_solved_;            ///< the last live solution; null: there is none, and
    Outgoing failed_;                  ///< why
    struct Failure {
        Situation situation;
        std::string reason;  ///< for people
    };
    std::optional<Failure> last_failure_;  ///< of the live model
    std::vector<ExportRequest> waiting_exports_;
    std::optional<ShownBeams> last_beams_;
    std::optional<AutosavePlace> autosave_place_;
    std::string no_autosave_;  ///< why nothing is kept; empty: it is
    Autosave autosave_;
    Background files_;  ///< what takes a second or two
    Background jobs_;   ///< what takes as long as it takes
    StatePtr checked_;  ///< whose making is looked at, or has been
    Outgoing making_;   ///< what was found, for pages that come
    Background checks_;
    LiveSolver solver_;
};

/// The event and the message of a solution. With `more` in the event, newer ones do not replace it.
Outgoing solved_message(const SolvedSurface& solved, const BeamFields& fields, const base::Json& more = {});

}  // namespace fretwork::studio
