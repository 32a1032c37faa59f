// SPDX-License-Identifier: GPL-3.0-or-later
// Node layouts that are drawn. The page keeps the layout with its undo; here it is read, changed by the rules
// of layouts, counted and written.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/pattern/internal/layout_json.hpp>
#include <studio/document/document.hpp>
#include <studio/files/saving.hpp>
#include <studio/layouts/layout_json.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/studio_impl.hpp>

namespace fretwork::studio {
namespace {

namespace fs = std::filesystem;
using base::Json;

/// A shipped layout gets another name, because the drawn layout will differ from it.
Json shipped_json(const std::string& name) {
    pattern::NodeLayoutDescription description = pattern::find_node_layout(name).description();
    description.name = "my-" + name;
    Json answer = layout_json(pattern::NodeLayout(std::move(description)));
    answer["path"] = nullptr;
    answer["hash"] = nullptr;
    return answer;
}

/// The file is read once, so that the hash is that of the layout which the page gets.
Json layout_file_json(const fs::path& path) {
    const std::string text = base::read_text_file(path);
    Json answer = layout_json(pattern::parse_node_layout(text, path.string()));
    answer["path"] = path.string();
    answer["hash"] = base::sha256(text);
    return answer;
}

Json count_event(const Json& key, std::uint64_t patterns, std::int64_t revision) {
    return {{"event", "layout_count"}, {"revision", revision}, {"key", key}, {"patterns", patterns}};
}

}  // namespace

void Studio::Impl::open_layout(const Request& request) {
    request.json.allow_only({"id", "do", "from"});
    const base::JsonReader from = request.json.at("from");
    const std::string name = read_name_or_path(from);
    pages_.answer(request,
                  pattern::is_layout_name(name) ? shipped_json(name) : layout_file_json(read_path(from)));
}

void Studio::Impl::draw_layout(const Request& request) {
    request.json.allow_only({"id", "do", "layout", "change", "grid", "mirror"});
    const LayoutHand hand = read_hand(request.json);
    ChangedLayout drawn{pattern::read_node_layout(request.json.at("layout"))};
    if (const auto change = request.json.find("change"))
        drawn = changed(drawn.layout, read_change(*change, drawn.layout), hand);
    Json answer = layout_json(drawn.layout);
    answer["node"] = base::or_null(drawn.node, &pattern::LayoutNodeIndex::value);
    pages_.answer(request, std::move(answer));
}

void Studio::Impl::count_layout(const Request& request) {
    request.json.allow_only({"id", "do", "layout", "key"});
    const Json key = request.json.at("key").integer(0, 1LL << 53);
    const auto layout =
        std::make_shared<const pattern::NodeLayout>(pattern::read_node_layout(request.json.at("layout")));
    Background& thread = counts_[request.client];
    thread.cancel();
    pages_.in_background(thread, request, [this, request, key, layout](const base::Control& control) {
        const auto tell = [this, client = request.client, key](std::uint64_t patterns) {
            server_.post([this, client, key, patterns] {
                pages_.send(client, count_event(key, patterns, revision()));
            });
        };
        const auto found =
            std::make_shared<const Json>(count_json(*layout, counted(*layout, {}, control, tell)));
        return [this, request, found] { pages_.answer(request, *found); };
    });
}

void Studio::Impl::save_layout(const Request& request) {
    request.json.allow_only({"id", "do", "layout", "path", "replaces"});
    const pattern::NodeLayout layout = pattern::read_node_layout(request.json.at("layout"));
    const fs::path path = read_path(request.json.at("path"));
    require_file_of_kind(path, "layout");
    const base::FileLock lock = lock_for_writing(path);
    const auto reason = request.json.find("replaces") ? Conflict::Reason::Changed : Conflict::Reason::Exists;
    if (refuses_to_replace(request, {.path = path, .reason = reason, .kind = "layout"})) return;
    const std::string text = pattern::node_layout_text(layout);
    base::write_file_atomically(path, text);
    pages_.answer(request, {{"path", path.string()}, {"hash", base::sha256(text)}});
}

}  // namespace fretwork::studio
