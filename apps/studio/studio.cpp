// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <studio/document/edits.hpp>
#include <studio/server/words.hpp>
#include <studio/studio.hpp>
#include <studio/studio_impl.hpp>

#include <algorithm>

namespace fretwork::studio {

using base::Json;
using base::JsonReader;

namespace {

/// The number that an unreadable message gives; null if it gives none.
Json number_of(std::string_view message) {
    const Json json = Json::parse(message, nullptr, false);
    if (!json.is_object() || !json.contains("id")) return {};
    const Json& id = json["id"];
    return id.is_number_integer() ? id : Json();
}

std::string compact(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::span<const Studio::Impl::RequestRow> Studio::Impl::requests() {
    static constexpr RequestRow kRequests[] = {
        {"hello", &Impl::hello},      {"undo", &Impl::undo},
        {"redo", &Impl::redo},        {"select_load_case", &Impl::select_load_case},
        {"new", &Impl::make_new},     {"open", &Impl::open},
        {"upload", &Impl::upload},    {"download", &Impl::download},
        {"save", &Impl::save},        {"patterns", &Impl::patterns},
        {"solve", &Impl::solve},      {"path", &Impl::path},
        {"modes", &Impl::modes},      {"buckling", &Impl::buckling},
        {"compare", &Impl::compare},  {"cancel", &Impl::cancel},
        {"show", &Impl::show_fields}, {"measure", &Impl::measure},
        {"recover", &Impl::recover},  {"recoverable", &Impl::recoverable},
        {"forget", &Impl::forget},
    };
    return kRequests;
}

Studio::Impl::Impl(const StudioOptions& options)
    : options_(options),
      token_(make_token()),
      server_({options.address, options.port, token_}, *this),
      autosave_([this](const std::string& error) {
          server_.post([this, error] { broadcast(Json{{"event", "warning"}, {"text", error}}); });
      }),
      solver_(listener()) {
    if (options.project)
        show(read_document(*options.project));
    else
        autosave_place_ = place_for(std::nullopt);  // whether one can be made is reported now
}

Studio::Impl::~Impl() = default;

std::string Studio::Impl::address() const {
    const bool is_version_6 = options_.address.find(':') != std::string::npos;
    const std::string host = is_version_6 ? "[" + options_.address + "]" : options_.address;
    return "http://" + host + ":" + std::to_string(server_.port()) + "/?token=" + token_;
}

void Studio::Impl::connected(ClientId) {}  // it says hello first

void Studio::Impl::disconnected(ClientId client) {
    clients_.erase(client);
}

void Studio::Impl::received(ClientId client, std::string_view message) {
    Json id;
    try {
        const JsonReader json = JsonReader::from_text(message, kMessageSource);
        if (const auto number = json.find("id")) id = number->integer(0, 1LL << 53);
        dispatch({client, id, json});
    } catch (const base::Error& error) {
        refuse(client, id.is_null() ? number_of(message) : id, in_words(error));
    } catch (const std::filesystem::filesystem_error& error) {
        refuse(client, id, in_words(error));
    } catch (const std::bad_alloc&) {
        refuse(client, id, "out of memory");
    }
}

void Studio::Impl::dispatch(const Request& request) {
    const std::string name = request.json.at("do").string();
    const auto row = std::ranges::find(requests(), name, &RequestRow::name);
    if (name != "hello" && !clients_.contains(request.client))
        throw base::InputError("the first request of a page is hello");
    if (row != requests().end()) return (this->*row->handle)(request);
    const StatePtr before = document(request).now();
    auto edit = edited(*before, name, request.json);
    if (!edit) request.json.at("do").fail("'" + base::shortened(name, 40) + "' is not a request");
    if (edit->state == *before) return answer(request, {{"unchanged", true}});
    document_->add(std::move(*edit));
    answer(request);
    tell_change(*before);
}

void Studio::Impl::answer(const Request& request, Json members) {
    Json json = {{"id", request.id}, {"ok", true}};
    json.update(members);
    server_.send(request.client, {{text_part(compact(json))}});
}

void Studio::Impl::refuse(ClientId client, const Json& id, const std::string& error) {
    const Json json = {{"id", id}, {"ok", false}, {"error", one_line(error)}};
    server_.send(client, {{text_part(compact(json))}});
}

void Studio::Impl::broadcast(const Outgoing& outgoing) {
    for (const auto& [client, fields] : std::map(clients_)) server_.send(client, outgoing);
}

void Studio::Impl::broadcast(const Json& event) {
    broadcast(Outgoing{{text_part(compact(event))}});
}

void Studio::Impl::in_background(Background& thread, const Request& request,
                                 std::function<std::function<void()>(const base::Control&)> work) {
    const auto failed = [this, request](const std::string& error) {
        server_.post([this, request, error] { refuse(request.client, request.id, error); });
    };
    const auto finish = [this, request](const std::function<void()>& rest) {
        try {
            rest();
        } catch (const base::Error& error) {
            refuse(request.client, request.id, in_words(error));
        } catch (const std::filesystem::filesystem_error& error) {
            refuse(request.client, request.id, in_words(error));
        }
    };
    thread.add({.work =
                    [this, work, finish](const base::Control& control) {
                        server_.post([finish, rest = work(control)] { finish(rest); });
                    },
                .failed = failed});
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
