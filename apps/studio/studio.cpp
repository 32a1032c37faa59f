// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <studio/document/document_json.hpp>
#include <studio/document/edits.hpp>
#include <studio/server/words.hpp>
#include <studio/studio.hpp>
#include <studio/studio_impl.hpp>

#include <algorithm>

namespace fretwork::studio {

using base::Json;
using base::JsonReader;

namespace {

/// The `id` of a message that is refused, if it has one; else null.
Json number_of(std::string_view message) {
    const Json json = Json::parse(message, nullptr, false);
    if (!json.is_object() || !json.contains("id")) return {};
    const Json& id = json["id"];
    return id.is_number_integer() ? id : Json();
}

}  // namespace

std::span<const Studio::Impl::RequestRow> Studio::Impl::requests() {
    static constexpr RequestRow kRequests[] = {
        {"hello", &Impl::hello},
        {"undo", &Impl::undo},
        {"redo", &Impl::redo},
        {"select_load_case", &Impl::select_load_case},
        {"new", &Impl::make_new},
        {"open", &Impl::open},
        {"upload", &Impl::upload},
        {"download", &Impl::download},
        {"save", &Impl::save},
        {"folder", &Impl::folder},
        {"patterns", &Impl::patterns},
        {"solve", &Impl::solve},
        {"path", &Impl::path},
        {"modes", &Impl::modes},
        {"buckling", &Impl::buckling},
        {"compare", &Impl::compare},
        {"cancel", &Impl::cancel},
        {"show", &Impl::show_fields},
        {"measure", &Impl::measure},
        {"recover", &Impl::recover},
        {"recoverable", &Impl::recoverable},
        {"forget", &Impl::forget},
        {"design", &Impl::begin_design},
        {"stop_design", &Impl::stop_design},
        {"retile", &Impl::retile},
        {"open_layout", &Impl::open_layout},
        {"draw_layout", &Impl::draw_layout},
        {"count_layout", &Impl::count_layout},
        {"save_layout", &Impl::save_layout},
    };
    return kRequests;
}

Studio::Impl::Impl(const StudioOptions& options)
    : options_(options),
      token_(make_token()),
      server_({options.address, options.port, token_}, *this),
      pages_(server_),
      kept_(
          options.state_folder, [this](const std::string& warning) { warn(warning); },
          [this](const std::string& error) { server_.post([this, error] { warn(error); }); }),
      view_(pages_),
      jobs_(server_, pages_,
            [this](const LongJob& job) {
                const ShownBeams* beams = document_ ? view_.beams_of(*document_->now()) : nullptr;
                return view_.is_shown(job.input.revision) && beams && beams->revision == job.beams.revision;
            }),
      making_(server_, pages_, [this] { return document_->now(); }),
      errors_(server_, pages_, [this] { return document_->solver_input().situation; }),
      designs_(server_, pages_, [this](const DesignFound& found) { take_design(found); }),
      solver_(listener()) {
    if (options.layout) (void)pattern::find_node_layout(*options.layout);
    if (options.project)
        show(read_document(*options.project));
    else
        kept_.take_place(std::nullopt, std::nullopt);  // so that warning() tells if work cannot be kept
}

Studio::Impl::~Impl() = default;

std::string Studio::Impl::address() const {
    const bool is_version_6 = options_.address.find(':') != std::string::npos;
    const std::string host = is_version_6 ? "[" + options_.address + "]" : options_.address;
    std::string page = "http://" + host + ":" + std::to_string(server_.port()) + "/?token=" + token_;
    if (options_.layout) page += "&page=layout&layout=" + escaped(*options_.layout);
    return page;
}

void Studio::Impl::connected(ClientId) {}  // nothing until its hello

void Studio::Impl::disconnected(ClientId client) {
    pages_.remove(client);
    counts_.erase(client);
}

void Studio::Impl::received(ClientId client, std::string_view message) {
    Json id;
    try {
        const JsonReader json = JsonReader::from_text(message, kMessageSource);
        if (const auto number = json.find("id")) id = number->integer(0, 1LL << 53);
        dispatch({client, id, json});
    } catch (...) {
        pages_.refuse(client, id.is_null() ? number_of(message) : id, error_in_words());
    }
}

void Studio::Impl::dispatch(const Request& request) {
    const std::string name = request.json.at("do").string();
    const auto row = std::ranges::find(requests(), name, &RequestRow::name);
    if (name != "hello" && !pages_.contains(request.client))
        throw base::InputError("the first request of a page is hello");
    if (row != requests().end()) return (this->*row->handle)(request);
    const StatePtr before = document().now();
    auto edit = edited(*before, name, request.json);
    if (!edit) request.json.at("do").fail("'" + base::shortened(name, 40) + "' is not a request");
    base::Json answer = base::Json::object();
    if (!edit->remarks.empty()) answer["remarks"] = edit->remarks;
    if (edit->state == *before) {
        answer["unchanged"] = true;
        return pages_.answer(request, answer);
    }
    document_->add(std::move(*edit));
    pages_.answer(request, answer);
    follow_change(*before);
}

Studio::Studio(const StudioOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Studio::~Studio() = default;
std::string Studio::address() const {
    return impl_->address();
}
std::string Studio::warning() const {
    return impl_->warning();
}
void Studio::run() {
    impl_->run();
}
void Studio::stop() {
    impl_->stop();
}

}  // namespace fretwork::studio
