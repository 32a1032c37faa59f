// SPDX-License-Identifier: GPL-3.0-or-later
// Documents from files and outlines, and files from documents.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <studio/document/document_json.hpp>
#include <studio/document/pattern_list.hpp>
#include <studio/files/folder_listing.hpp>
#include <studio/files/new_document.hpp>
#include <studio/files/saving.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/server/words.hpp>
#include <studio/studio_impl.hpp>

#include <functional>
#include <optional>
#include <system_error>
#include <utility>

namespace fretwork::studio {

namespace fs = std::filesystem;
using base::Json;
using simulation::Project;

namespace {

/// Do some work on the server's thread. If it throws, answer with the reason: nothing above catches it.
template <class Work>
void do_or_refuse(const std::function<void(HttpAnswer)>& answer, const Work& work) {
    try {
        work();
    } catch (const base::InputError& error) {
        answer(refused(422, in_words(error)));
    } catch (...) {
        answer(refused(503, error_in_words()));
    }
}

}  // namespace

void Studio::Impl::make_new(const Request& request) {
    pages_.in_background(
        files_, request, [this, request, wanted = read_new(request.json)](const base::Control& control) {
            const auto made = std::make_shared<const NamedProject>(make(wanted, control));
            return [this, request, made] {
                pages_.answer(request, {{"tiles", made->project.tessellation.tiles.size()},
                                        {"remarks", made->remarks}});
                Document next(make_state(made->project, folder_of({})), next_revision());
                next = std::move(next).named(made->name);
                replace(request, {made->is_example ? std::move(next).found_elsewhere() : std::move(next)});
            };
        });
}

void Studio::Impl::measure(const Request& request) {
    request.json.allow_only({"id", "do", "outline"});
    pages_.in_background(
        files_, request,
        [this, request, sent = read_sent_outline(request.json.at("outline"))](const base::Control&) {
            const auto size = std::make_shared<const Json>(measured(take_outline(sent)));
            return [this, request, size] { pages_.answer(request, *size); };
        });
}

void Studio::Impl::open(const Request& request) {
    request.json.allow_only({"id", "do", "path", "discard"});
    Opened next = read_document(read_path(request.json.at("path")));
    pages_.answer(request);
    replace(request, std::move(next));
}

void Studio::Impl::upload(const Request& request) {
    request.json.allow_only({"id", "do", "name", "text_base64", "discard"});
    const auto name = request.json.find("name");
    const std::string source = name ? read_file_name(*name) : "the file";
    pages_.in_background(
        files_, request,
        [this, request, source, text = request.json.at("text_base64").string()](const base::Control&) {
            auto project = std::make_shared<Project>(
                simulation::parse_project(base::decode_base64(text, shown_name(source)), shown_name(source)));
            // Its library lies on another machine.
            if (!project->setting && !project->library_path.empty())
                throw base::InputError(shown_name(source), "/setting",
                                       "is missing, and the library that has it is not sent along: "
                                       "open the project where its library is");
            project->library_path.clear();
            project->library_hash.clear();
            return [this, request, project, source] {
                pages_.answer(request);
                replace(request, {Document(make_state(*project, folder_of({})), next_revision())
                                      .named(std::filesystem::path(source).stem().string())
                                      .found_elsewhere()});
            };
        });
}

void Studio::Impl::download(const Request& request) {
    request.json.allow_only({"id", "do"});
    const Document& shown = document();
    pages_.answer(request,
                  {{"text", simulation::project_text(make_project(*shown.now(), folder_of(shown.path())))}});
}

void Studio::Impl::save(const Request& request) {
    request.json.allow_only({"id", "do", "path", "replaces"});
    Document& shown = document();
    const auto wanted = request.json.find("path");
    if (!wanted && !shown.path()) throw base::InputError("the document has no file yet: name one");
    const auto path = wanted ? read_path(*wanted) : *shown.path();
    const bool is_own = shown.path() == path;
    if (!is_own) require_file_of_kind(path, "project");
    const base::FileLock lock = lock_for_writing(path);
    const auto reason = is_own ? Conflict::Reason::Changed : Conflict::Reason::Exists;
    if (refuses_to_replace(request, {.path = path, .reason = reason, .kind = "project"},
                           is_own ? shown.file_hash() : std::nullopt))
        return;
    const std::string text = simulation::project_text(make_project(*shown.now(), folder_of(path)));
    base::write_file_atomically(path, text);
    kept_.forget();
    if (path != shown.path()) kept_.take_place(std::nullopt, path);
    shown.saved_as(path, base::sha256(text));
    pages_.answer(request, {{"path", path.string()}});
    pages_.broadcast(changed_event(*shown.now(), *shown.now(), shown.status()));
}

bool Studio::Impl::refuses_to_replace(const Request& request, Conflict conflict,
                                      const std::optional<std::string>& known) {
    const auto present = hash_of_file(conflict.path);
    const auto replaces = request.json.find("replaces");
    if (!present || present == known || (replaces && replaces->string() == *present)) return false;
    conflict.hash = *present;
    pages_.refuse(request, conflict.text(), conflict.json());
    return true;
}

/// In the background: folders of other machines may be slow.
void Studio::Impl::folder(const Request& request) {
    request.json.allow_only({"id", "do", "path", "endings"});
    const auto wanted = request.json.find("path");
    const fs::path path =
        wanted ? read_path(*wanted) : folder_of(document_ ? document_->path() : std::nullopt);
    std::vector<std::string> endings;
    if (const auto list = request.json.find("endings"))
        for (const auto& ending : list->elements()) endings.push_back(read_plain_text(ending));
    pages_.in_background(files_, request, [this, request, path, endings](const base::Control& control) {
        const auto listing = std::make_shared<const Json>(folder_listing(path, endings, control));
        return [this, request, listing] { pages_.answer(request, *listing); };
    });
}

void Studio::Impl::patterns(const Request& request) {
    request.json.allow_only({"id", "do", "layout"});
    const auto name = request.json.find("layout");
    const std::string layout = name ? read_name_or_path(*name) : std::string("paper7");
    const StatePtr state = document_ ? document_->now() : nullptr;
    pages_.in_background(files_, request, [this, request, layout, state](const base::Control& control) {
        const auto list = std::make_shared<const Json>(pattern_list(layout, state.get(), control));
        return [this, request, list] { pages_.answer(request, *list); };
    });
}

/// The hash is taken before the file is read: a change in between then counts as a change by another program.
Document Studio::Impl::document_in(const fs::path& file) const {
    ProjectFile known{file, hash_of_file(file)};
    auto project = simulation::read_checked_project(file.string());
    if (!project.setting) {
        if (const auto library = simulation::open_project_library(file.string(), project, ""))
            project.setting = library->setting();
    }
    return {make_state(project, folder_of(file)), std::move(known), next_revision()};
}

Opened Studio::Impl::read_document(const fs::path& path) {
    const fs::path file = fs::absolute(path).lexically_normal();
    return kept_.with_changes(document_in(file), file);
}

/// The document as its file has it; nothing if there is no such file, or it cannot be read: then a warning
/// says why.
std::optional<Document> Studio::Impl::find_saved(const std::optional<fs::path>& file) {
    std::error_code ignored;
    if (!file || fs::status(*file, ignored).type() == fs::file_type::not_found) return std::nullopt;
    try {
        return document_in(*file);
    } catch (const base::Error& error) {  // the unsaved changes are there all the same
        warn(one_line(in_words(error)));
        return std::nullopt;
    }
}

/// If the document's file can be read, undo leads back to its content.
Opened Studio::Impl::recovered(const Recoverable& found) {
    auto place = AutosavePlace::take_over(found.file);
    if (!place) throw base::InputError("another studio shows it now");
    State changed = read_autosave(found.file);
    if (auto saved = find_saved(found.label.document))
        return {Document::recovered(std::move(*saved), std::move(changed)), std::move(place)};
    return {Document(std::move(changed), next_revision()).named(found.label.name), std::move(place)};
}

void Studio::Impl::recover(const Request& request) {
    request.json.allow_only({"id", "do", "key", "discard"});
    Opened next = recovered(kept_.find(request.json.at("key")));
    pages_.answer(request);
    replace(request, std::move(next));
}

void Studio::Impl::recoverable(const Request& request) {
    request.json.allow_only({"id", "do"});
    pages_.answer(request, {{"recoverable", kept_.recoverable_json()}});
}

void Studio::Impl::forget(const Request& request) {
    request.json.allow_only({"id", "do", "key"});
    kept_.forget(kept_.find(request.json.at("key")));
    pages_.answer(request, {{"recoverable", kept_.recoverable_json()}});
}

void Studio::Impl::resume_exports() {
    for (ExportRequest& request : std::exchange(waiting_exports_, {})) {
        const auto answer = request.answer;
        do_or_refuse(answer, [&] { export_file(std::move(request)); });
    }
}

void Studio::Impl::refuse_waiting_exports(const std::string& reason) {
    for (const ExportRequest& request : std::exchange(waiting_exports_, {}))
        request.answer(refused(409, reason));
}

void Studio::Impl::export_file(ExportRequest request) {
    if (!document_) return request.answer({.status = 404, .body = "there is no document yet\n"});
    const Situation situation = document_->solver_input().situation;
    const auto answer = request.target.shows_answer() ? view_.answer_to(situation) : AnswerToExport{};
    if (!answer) return waiting_exports_.push_back(std::move(request));
    if (!answer->missing.empty())
        return request.answer(refused(422, "there is no answer to export: " + answer->missing));
    const auto give = [this, answer = request.answer](HttpAnswer given) {
        server_.post([answer, given = std::move(given)] { answer(given); });
    };
    const auto write = [target = request.target, situation, folder = folder_of(document_->path()),
                        solved = answer->solved](const base::Control& control) {
        return target.file_of(situation, folder, solved, control);
    };
    files_.add({.work = [give, write](const base::Control& control) { give(write(control)); },
                .failed = [give](const std::string& error) { give(refused(422, error)); }});
}

HttpAnswer Studio::Impl::page() const {
    constexpr const char* kNoPage =
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Fretwork studio</title>"
        "<p>The studio's server runs, but its page was not built with this program. In the repository, "
        "<code>make studio</code> builds it (it needs Node.js 18 or newer and npm) and opens it here.</p>"
        "</html>\n";
    HttpAnswer answer{.type = "text/html; charset=utf-8", .body = kNoPage};
    if (std::filesystem::is_regular_file(options_.page)) answer.body = base::read_text_file(options_.page);
    return answer;
}

void Studio::Impl::get(const Target& target, std::function<void(HttpAnswer)> answer) {
    do_or_refuse(answer, [&] {
        if (target.path == "/") return answer(page());
        if (target.path == "/export") return export_file({ExportTarget(target), answer});
        answer({.status = 404, .body = "there is nothing at this address\n"});
    });
}

}  // namespace fretwork::studio
