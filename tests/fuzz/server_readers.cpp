// SPDX-License-Identifier: GPL-3.0-or-later
// The studio as whole servers: bytes on its socket, and conversations with it. Boost.Beast reads HTTP and the
// frames of WebSockets, so that the bytes are about what stands around it.
#include "fuzz/input_file.hpp"
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/sandbox.hpp"
#include "simulation/honeycomb.hpp"
#include "studio/client.hpp"

#include <fretwork/simulation/project/project_file.hpp>
#include <studio/server/http_server.hpp>
#include <studio/studio.hpp>

#include <algorithm>
#include <optional>
#include <thread>

namespace fretwork::fuzz {
namespace {

namespace fs = std::filesystem;
using base::Json;
using test::Client;

constexpr const char* kWireToken = "token";
constexpr std::size_t kMostMessages = 24;
constexpr std::size_t kMostMessageBytes = 8192;
/// What takes long is no finding, so documents stay small: tiles of this size or larger, m.
constexpr double kLeastTileSize = 0.02;
/// Stands for the folder of the project in messages.
constexpr std::string_view kFolderMark = "FOLDER";

/// Whether a text is UTF-8, as a message has to be.
bool is_unicode(std::string_view text) {
    try {
        (void)Json(std::string(text)).dump();
        return true;
    } catch (const Json::type_error&) {
        return false;
    }
}

/// Answers with the path that was asked for, and with each message that comes.
class Echo final : public studio::Service {
  public:
    Echo() {
        thread_ = std::thread([this] { server_.run(); });
    }
    Echo(const Echo&) = delete;
    Echo& operator=(const Echo&) = delete;
    ~Echo() override {
        server_.stop();
        thread_.join();
    }
    [[nodiscard]] int port() const { return server_.port(); }

    void get(const studio::Target& target, std::function<void(studio::HttpAnswer)> answer) override {
        answer({.body = target.path, .download_name = target.value("to")});
    }
    void connected(studio::ClientId) override {}
    void disconnected(studio::ClientId) override {}
    void received(studio::ClientId client, std::string_view message) override {
        promise(is_unicode(message), "a message is UTF-8", message);
        server_.send(client, {{studio::text_part(std::string(message))}});
    }

  private:
    studio::HttpServer server_{{.port = 0, .token = kWireToken}, *this};
    std::thread thread_;
};

/// A studio that shows six tiles, in a folder of its own.
class OwnStudio {
  public:
    OwnStudio() {
        simulation::Project project = test::honeycomb(3, 2, {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"});
        project.load_cases.push_back(test::cantilever({0.0, 0.0, -0.01}));
        project.setting = reduction::paper_setting();
        text_ = simulation::project_text(project);
        fs::create_directory(folder_);
        write_project();
        studio_.emplace(studio::StudioOptions{.project = file_,
                                              .port = 0,
                                              .page = folder_ / "page.html",
                                              .state_folder = state_.path() / "state"});
        thread_ = std::thread([this] { studio_->run(); });
        keeper_.emplace(test::StudioAddress(studio_->address()));
        keeper_->hello();
    }
    OwnStudio(const OwnStudio&) = delete;
    OwnStudio& operator=(const OwnStudio&) = delete;
    ~OwnStudio() {
        studio_->stop();
        thread_.join();
    }

    [[nodiscard]] const fs::path& folder() const { return folder_; }
    [[nodiscard]] Client new_page() const { return Client(test::StudioAddress(studio_->address())); }
    /// The project as it was, without files beside it, and nothing else at work.
    void begin() {
        for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry.path());
        write_project();
        stop_work();
        const Json opened = keeper_->ask("open", {{"path", file_.string()}, {"discard", true}});
        promise(opened["ok"].get<bool>(), "the project can be opened again", opened.dump());
        keeper_->forget();
    }
    void stop_work() {
        (void)keeper_->ask("stop_design");
        (void)keeper_->ask("cancel");
    }

  private:
    void write_project() const { std::ofstream(file_, std::ios::binary) << text_; }

    InputFolder state_;
    fs::path folder_ = state_.path() / "files";
    fs::path file_ = folder_ / "project.json";
    std::string text_;
    std::optional<studio::Studio> studio_;
    std::thread thread_;
    std::optional<Client> keeper_;
};

/// Whether a message asks for tiles without number.
bool is_laborious(const Json& message) {
    if (!message.is_object()) return false;
    if (message.contains("outline") || message.contains("example")) return true;  // studio-new reads these
    const auto size = message.find("tile_size");
    return size != message.end() && size->is_number() && size->get<double>() < kLeastTileSize;
}

std::string with_folder(std::string line, const fs::path& folder) {
    for (std::size_t at = line.find(kFolderMark); at != std::string::npos; at = line.find(kFolderMark, at))
        line.replace(at, kFolderMark.size(), folder.string());
    return line;
}

/// The messages of a conversation, a line for each: those that a studio in a sandbox may be sent.
std::vector<std::string> messages_of(std::string_view bytes, const fs::path& folder) {
    std::vector<std::string> messages;
    while (!bytes.empty() && messages.size() < kMostMessages) {
        const std::string_view line = bytes.substr(0, bytes.find('\n'));
        bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
        if (line.size() > kMostMessageBytes || !is_unicode(line)) continue;
        std::string message = with_folder(std::string(line), folder);
        const Json json = Json::parse(message, nullptr, false);
        if (!leaves(json, folder) && !is_laborious(json)) messages.push_back(std::move(message));
    }
    return messages;
}

}  // namespace

/// Bytes on the socket, and then their end. They are answered by HTTP, or not at all.
void read_wire(std::string_view bytes) {
    static const Echo kServer;
    test::Wire wire(kServer.port());
    (void)wire.send(bytes);
    wire.end();
    const std::string answer = wire.receive_all();
    const bool is_http = answer.starts_with("HTTP/1.1 ") || answer.starts_with("HTTP/1.0 ");  // as was asked
    promise(answer.empty() || is_http, "an answer is one of HTTP", bytes);
}

/// Each message of a page is answered once, and the studio goes on.
void read_conversation(std::string_view bytes) {
    static OwnStudio studio;
    studio.begin();
    Client page = studio.new_page();
    const std::vector<std::string> messages = messages_of(bytes, studio.folder());
    for (const std::string& message : messages) promise(page.send_text(message), "it is heard", message);
    for (std::size_t answered = 0; answered < messages.size();)
        if (page.receive().json.contains("ok")) ++answered;
    studio.stop_work();
}

}  // namespace fretwork::fuzz
