// SPDX-License-Identifier: GPL-3.0-or-later
// Documents from files and outlines, and files from documents.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <studio/document/examples.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/document/pattern_list.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/server/sent_name.hpp>
#include <studio/server/sent_outline.hpp>
#include <studio/server/words.hpp>
#include <studio/solving/first_painting.hpp>
#include <studio/solving/making_doubts.hpp>
#include <studio/studio_impl.hpp>

#include <algorithm>
#include <cmath>
#include <typed/making_choice.hpp>
#include <typed/picture_options.hpp>

namespace fretwork::studio {

using base::Json;
using simulation::Project;

namespace {

double width_of(const std::vector<geometry::Point2>& points) {
    const auto [left, right] = std::ranges::minmax(points, {}, &geometry::Point2::x);
    return right.x - left.x;
}

/// The request `new`.
struct NewRequest {
    std::string example;
    SentOutline outline;
    simulation::NewProjectOptions options;
    bool is_to_be_made = false;  ///< painted with one pattern that can be made
};

struct NamedProject {
    std::string name;
    Project project;
    std::vector<std::string> remarks{};  ///< on how the outline was read, and tiled
    bool is_example = false;
};

/// The changes of the drawing by the tiling.
void add_remarks(const simulation::NewProject& made, std::vector<std::string>& remarks) {
    if (made.report.negligible_points > 0)
        remarks.push_back(std::to_string(made.report.negligible_points) +
                          (made.report.negligible_points == 1
                               ? " point of the outline that lies very close to another left out"
                               : " points of the outline that lie very close to others left out"));
    if (made.report.refined_share > 0.0)
        remarks.push_back(std::to_string(std::max(1L, std::lround(100 * made.report.refined_share))) +
                          " % of the tiles are smaller, since the outline is narrow near them");
}

void scale(tiling::Tessellation& tessellation, double factor) {
    for (auto* points : {&tessellation.vertices, &tessellation.interface_nodes}) {
        for (geometry::Point2& point : *points) point = {factor * point.x, factor * point.y};
    }
}

/// The faces of a mesh are read from its file, and scaled as its outline was.
simulation::NewProject make_from(const SentOutline& sent, const outlines::OutlineFile& file,
                                 simulation::NewProjectOptions options) {
    if (options.tiles == simulation::TilesFrom::Outline)
        return simulation::make_project(file.parts, options, nullptr);
    simulation::NewProject made = read_sent(sent.file, [&](const std::filesystem::path& path) {
        options.outline_name = path.string();
        return simulation::make_project(file.parts, options, nullptr);
    });
    const double drawn = width_of(made.project.tessellation.vertices);
    scale(made.project.tessellation, sent.width.value_or(drawn) / drawn);
    return made;
}

NamedProject make(const NewRequest& wanted, const base::Control& control) {
    if (!wanted.example.empty())
        return {example_title(wanted.example), make_example(wanted.example, control), {}, true};
    simulation::NewProjectOptions options = wanted.options;
    options.control = control;
    outlines::OutlineFile file = take_outline(wanted.outline).file;
    simulation::NewProject made = make_from(wanted.outline, file, options);
    add_remarks(made, file.remarks);
    if (wanted.is_to_be_made) {
        const std::string remark = paint_to_be_made(made.project, control);
        if (!remark.empty()) file.remarks.push_back(remark);
    }
    return {std::filesystem::path(wanted.outline.file.name).stem().string(), std::move(made.project),
            std::move(file.remarks)};
}

/// A choice of patterns that the studio makes; the other words are the command line's.
constexpr std::string_view kToBeMade = "made:one";

NewRequest read_new(const base::JsonReader& json) {
    json.allow_only({"id", "do", "outline", "example", "tile_size", "tiles", "patterns", "palette",
                     "property", "range", "dither", "layout", "discard"});
    NewRequest wanted;
    if (const auto example = json.find("example")) {
        json.allow_only({"id", "do", "example", "discard"});
        wanted.example = example->string();
        return wanted;
    }
    wanted.outline = read_sent_outline(json.at("outline"));
    if (const auto layout = json.find("layout")) wanted.options.layout = read_name_or_path(*layout);
    const auto patterns = json.find("patterns");
    wanted.is_to_be_made = patterns && patterns->string() == kToBeMade;
    if (wanted.is_to_be_made)
        json.allow_only({"id", "do", "outline", "tile_size", "tiles", "patterns", "layout", "discard"});
    else
        wanted.options.painting = typed::read_painting(read_painting_text(json));
    const auto tiles = json.find("tiles");
    if (tiles && tiles->choice({"new", "faces"}) == "faces")
        wanted.options.tiles = simulation::TilesFrom::Mesh;
    if (const auto size = json.find("tile_size")) wanted.options.edge_length = size->positive_number();
    return wanted;
}

/// The part of an address that says how a scene is drawn: as the options of `fretwork export`.
void read_drawing(const Target& target, exports::Scene& scene) {
    if (const std::string scale = target.value("scale"); !scale.empty())
        scene.displacement_scale = base::parse_number(scale);
    if (const std::string view = target.value("view"); !view.empty()) scene.view = typed::parse_view(view);
    if (const std::string size = target.value("size"); !size.empty())
        scene.picture.size = typed::parse_size(size);
    if (const std::string colour = target.value("colour"); !colour.empty()) scene.picture.colour = colour;
}

/// The part of an address that says how a surface is made.
exports::Making read_making(const Target& target, const std::optional<simulation::Conditions>& conditions) {
    const typed::MakingChoice choice{.fillet = target.value("fillet"),
                                     .kerf = target.value("kerf"),
                                     .frame = target.value("frame"),
                                     .bolts = target.value("bolts"),
                                     .eye = target.value("eye"),
                                     .bed = target.value("bed"),
                                     .fit = target.value("fit"),
                                     .clearance = target.value("clearance"),
                                     .layer = target.value("layer"),
                                     .prefix = ""};
    return typed::read_making(choice, conditions ? &*conditions : nullptr);
}

constexpr std::string_view kExportKeys[] = {"token",  "to",     "content",   "scale", "view",  "size",
                                            "colour", "fillet", "kerf",      "frame", "bolts", "eye",
                                            "bed",    "fit",    "clearance", "layer"};

void check_keys(const Target& target) {
    for (const auto& [name, value] : target.values) {
        if (std::ranges::find(kExportKeys, name) != std::end(kExportKeys)) continue;
        const std::vector<std::string> known(std::begin(kExportKeys) + 1, std::end(kExportKeys));
        throw base::InputError(
            base::unknown_name_message("key of /export", base::shortened(name, 40), known));
    }
}

/// The reason why there is no file.
HttpAnswer refused(unsigned status, const std::string& why) {
    return {.status = status, .body = one_line(why) + "\n"};
}

const exports::WriterRow& find_target_writer(const Target& target) {
    const std::string content = target.value("content");
    const auto wanted = content.empty() ? std::nullopt : std::optional(exports::parse_content(content));
    return exports::find_writer(target.value("to"), wanted);
}

/// Whether a file shows how the surface answers its load: what is cut or printed does not.
bool shows_answer(const exports::WriterRow& writer) {
    return !writer.is_made() || writer.content == exports::Content::Facts;
}

/// A file as `fretwork export` writes it, with its remarks. `solved` may be null.
HttpAnswer exported(const Target& target, const Situation& situation, const SolvedPtr& solved) {
    const exports::WriterRow& writer = find_target_writer(target);
    const State& state = *situation.state;
    exports::Scene scene{open_surface(state).surface};
    read_drawing(target, scene);
    if (!state.load_cases->empty()) {
        const simulation::LoadCase load_case = load_case_of(situation);
        scene.conditions = simulation::resolve(load_case, scene.surface);
        scene.load_case = load_case;
        if (solved) {
            scene.results.push_back({solved->model, solved->result});
            scene.results.front().result.subject = simulation::result_subject(
                scene.surface, load_case, {.model = *state.model, .analysis = state.analysis});
        }
    }
    if (writer.is_made()) scene.making = read_making(target, scene.conditions);
    exports::Written written = writer.write(scene);
    if (writer.is_made()) {
        for (const std::string& doubt :
             making_doubts(scene.surface, scene.making.shape, scene.making.facts.clearance).words)
            written.remarks.push_back(doubt);
    }
    return {.type = "application/octet-stream",
            .body = std::move(written.text),
            .download_name = target.value("to"),
            .remark = base::printable(base::join(written.remarks, "; "))};
}

/// Where there is a file already, it must be a project: others are not to be lost.
void require_project_file(const std::filesystem::path& path) {
    if (path.extension() != ".json")
        throw base::InputError(path.string(), "", "is not a name for a project, which ends with .json");
    if (!std::filesystem::exists(path)) return;
    const auto json = base::JsonReader::from_file(path);
    json.expect_format("project", 1000);
}

/// The lock that the commands take, too: who changes a file locks it, and who makes one locks its folder.
base::FileLock lock_for_writing(const std::filesystem::path& path) {
    auto lock = base::FileLock::try_lock(std::filesystem::exists(path) ? path : path.parent_path());
    if (!lock)
        throw base::InputError(path.string(), "",
                               "is being written by another program: try again in a moment");
    return std::move(*lock);
}

/// Why a file is not replaced without a question.
std::string conflict_text(const std::filesystem::path& path, bool is_own) {
    return path.filename().string() + (is_own ? " was changed by another program since it was read here"
                                              : " is there already, and is another project");
}

}  // namespace

void Studio::Impl::make_new(const Request& request) {
    in_background(
        files_, request, [this, request, wanted = read_new(request.json)](const base::Control& control) {
            const auto made = std::make_shared<const NamedProject>(make(wanted, control));
            return [this, request, made] {
                answer(request,
                       {{"tiles", made->project.tessellation.tiles.size()}, {"remarks", made->remarks}});
                Document next(make_state(made->project, folder_of({})), next_revision());
                next = std::move(next).named(made->name);
                replace(request, {made->is_example ? std::move(next).found_elsewhere() : std::move(next)});
            };
        });
}

void Studio::Impl::measure(const Request& request) {
    request.json.allow_only({"id", "do", "outline"});
    in_background(
        files_, request,
        [this, request, sent = read_sent_outline(request.json.at("outline"))](const base::Control&) {
            const auto size = std::make_shared<const Json>(measured(take_outline(sent)));
            return [this, request, size] { answer(request, *size); };
        });
}

void Studio::Impl::open(const Request& request) {
    request.json.allow_only({"id", "do", "path", "discard"});
    Opened next = read_document(read_path(request.json.at("path")));
    answer(request);
    replace(request, std::move(next));
}

void Studio::Impl::upload(const Request& request) {
    request.json.allow_only({"id", "do", "name", "text_base64", "discard"});
    const auto name = request.json.find("name");
    const std::string source = name ? read_file_name(*name) : "the file";
    in_background(
        files_, request,
        [this, request, source, text = request.json.at("text_base64").string()](const base::Control&) {
            auto project = std::make_shared<Project>(
                simulation::parse_project(base::decode_base64(text, shown_name(source)), shown_name(source)));
            // Its library lies on another machine.
            project->library_path.clear();
            project->library_hash.clear();
            return [this, request, project, source] {
                answer(request);
                replace(request, {Document(make_state(*project, folder_of({})), next_revision())
                                      .named(std::filesystem::path(source).stem().string())
                                      .found_elsewhere()});
            };
        });
}

void Studio::Impl::download(const Request& request) {
    request.json.allow_only({"id", "do"});
    const Document& shown = document(request);
    answer(request,
           {{"text", simulation::project_text(make_project(*shown.now(), folder_of(shown.path())))}});
}

/// A file that this document was neither read from nor written to is replaced only by a page that has seen
/// it: `replaces` is the hash in the refusal.
void Studio::Impl::save(const Request& request) {
    request.json.allow_only({"id", "do", "path", "replaces"});
    Document& shown = document(request);
    const auto wanted = request.json.find("path");
    if (!wanted && !shown.path()) throw base::InputError("the document has no file yet: name one");
    const auto path = wanted ? read_path(*wanted) : *shown.path();
    const bool is_own = shown.path() == path;
    if (!is_own) require_project_file(path);
    const base::FileLock lock = lock_for_writing(path);
    if (const auto present = hash_of_file(path)) {
        const auto replaces = request.json.find("replaces");
        const bool is_known = is_own && shown.file_hash() == present;
        if (!is_known && (!replaces || replaces->string() != *present))
            return refuse_to_replace(request, path, {is_own, *present});
    }
    const std::string text = simulation::project_text(make_project(*shown.now(), folder_of(path)));
    base::write_file_atomically(path, text);
    forget_kept();
    if (path != shown.path()) autosave_place_ = place_for(path);
    shown.saved_as(path, base::sha256(text));
    answer(request, {{"path", path.string()}});
    broadcast(changed_event(*shown.now(), *shown.now(), shown.status()));
}

void Studio::Impl::refuse_to_replace(const Request& request, const std::filesystem::path& path,
                                     const PresentFile& present) {
    const Json conflict = {
        {"path", path.string()}, {"hash", present.hash}, {"reason", present.is_own ? "changed" : "exists"}};
    const Json json = {{"id", request.id},
                       {"ok", false},
                       {"error", conflict_text(path, present.is_own)},
                       {"conflict", conflict}};
    server_.send(request.client, {{text_part(json.dump(-1, ' ', false, Json::error_handler_t::replace))}});
}

void Studio::Impl::patterns(const Request& request) {
    request.json.allow_only({"id", "do", "layout"});
    const auto name = request.json.find("layout");
    const std::string layout = name ? read_name_or_path(*name) : std::string("paper7");
    const StatePtr state = document_ ? document_->now() : nullptr;
    in_background(files_, request, [this, request, layout, state](const base::Control& control) {
        const auto list = std::make_shared<const Json>(pattern_list(layout, state.get(), control));
        return [this, request, list] { answer(request, *list); };
    });
}

std::optional<AnswerToExport> Studio::Impl::answer_to_export() const {
    const Situation situation = document_->solver_input().situation;
    if (situation.state->load_cases->empty()) return AnswerToExport{};
    if (last_solved_ && last_solved_->situation == situation) {
        if (last_solved_->result.solution.converged()) return AnswerToExport{last_solved_, ""};
        return AnswerToExport{nullptr, last_solved_->warnings.front()};
    }
    if (last_failure_ && last_failure_->situation == situation)
        return AnswerToExport{nullptr, last_failure_->reason};
    return std::nullopt;
}

void Studio::Impl::resume_exports() {
    for (ExportRequest& request : std::exchange(waiting_exports_, {})) export_file(std::move(request));
}

void Studio::Impl::refuse_waiting_exports(const std::string& reason) {
    for (const ExportRequest& request : std::exchange(waiting_exports_, {}))
        request.answer(refused(409, reason));
}

void Studio::Impl::export_file(ExportRequest request) {
    check_keys(request.target);
    if (!document_) return request.answer({.status = 404, .body = "there is no document yet\n"});
    const bool is_project = request.target.value("to") == "project.json";
    const exports::WriterRow* writer = is_project ? nullptr : &find_target_writer(request.target);
    const auto answer = writer && shows_answer(*writer) ? answer_to_export() : AnswerToExport{};
    if (!answer) return waiting_exports_.push_back(std::move(request));
    if (!answer->missing.empty())
        return request.answer(refused(422, "there is no answer to export: " + answer->missing));
    const auto tell = [this, give = request.answer](HttpAnswer given) {
        server_.post([give, given = std::move(given)] { give(given); });
    };
    const auto write = [target = request.target, situation = document_->solver_input().situation,
                        folder = folder_of(document_->path()), solved = answer->solved, is_project] {
        if (!is_project) return exported(target, situation, solved);
        return HttpAnswer{.type = "application/json",
                          .body = simulation::project_text(make_project(*situation.state, folder)),
                          .download_name = target.value("to")};
    };
    files_.add({.work = [tell, write](const base::Control&) { tell(write()); },
                .failed = [tell](const std::string& error) { tell(refused(422, error)); }});
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
    try {
        if (target.path == "/") return answer(page());
        if (target.path == "/export") return export_file({target, answer});
        answer({.status = 404, .body = "there is nothing at this address\n"});
    } catch (const base::InputError& error) {
        answer(refused(422, in_words(error)));
    } catch (const base::Error& error) {
        answer(refused(503, error.what()));
    } catch (const std::filesystem::filesystem_error& error) {
        answer(refused(503, in_words(error)));
    }
}

}  // namespace fretwork::studio
