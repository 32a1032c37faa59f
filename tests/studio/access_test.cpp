// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_studio.hpp"

#include <studio/server/access.hpp>
#include <studio/server/http_server.hpp>

#include <gmock/gmock.h>

#include <sys/resource.h>

namespace fretwork::studio {
namespace THIS_TEST {

using test::get_request;
using test::http;
using test::status_of;

class StudioAccess : public testing::Test {
  protected:
    [[nodiscard]] std::string get(const std::string& target, const std::string& host = "127.0.0.1",
                                  const std::string& more = "") const {
        return http(studio_.port(), get_request(target, host, more));
    }
    [[nodiscard]] std::string with_token(const std::string& path) const {
        return path + (path.find('?') == std::string::npos ? "?" : "&") + "token=" + studio_.token();
    }
    test::RunningStudio studio_;
};

TEST_F(StudioAccess, ThePageIsAtThePrintedAddress) {
    const std::string answer = get(with_token("/"));
    EXPECT_EQ(status_of(answer), 200);
    EXPECT_THAT(answer, testing::HasSubstr("make studio")) << "no page was built here, so it says how";
    (void)base::write_file_atomically(studio_.folder() / "page.html", "<p>the page");
    EXPECT_THAT(get(with_token("/")), testing::EndsWith("<p>the page"));
}

TEST_F(StudioAccess, NothingIsThereWithoutTheToken) {
    const std::string token = studio_.token();
    for (const std::string& target :
         {std::string("/"), std::string("/?token="), "/?token=" + token.substr(1), "/?token=" + token + "0",
          "/?token=" + token + "&token=" + token, std::string("/socket"),
          std::string("/export?to=project.json"), std::string("/nothing")}) {
        EXPECT_EQ(status_of(get(target)) / 100, 4) << target;
    }
}

TEST(StudioTarget, ATextComesBackFromAnAddress) {
    std::string all;
    for (int byte = 1; byte < 256; ++byte) all += static_cast<char>(byte);
    for (const std::string& text : {all, std::string("/a b/\xc3\xa4&=?#+%.json"), std::string()}) {
        const auto target = parse_target("/?layout=" + escaped(text) + "&page=layout");
        ASSERT_TRUE(target);
        EXPECT_EQ(target->value("layout"), text);
        EXPECT_EQ(target->value("page"), "layout");
    }
}

TEST_F(StudioAccess, HostsAndOriginsAreThisMachineWithAnyPort) {
    for (const char* host :
         {"127.0.0.1", "localhost", "[::1]", "localhost:1", "127.0.0.1:65535", "[::1]:80"}) {
        EXPECT_EQ(status_of(get(with_token("/"), host)), 200) << host;
        const std::string origin = std::string("Origin: http://") + host + "\r\n";
        EXPECT_EQ(status_of(get(with_token("/"), "localhost", origin)), 200) << host;
    }
    for (const char* host : {"example.org", "127.0.0.1.example.org", "localhost.example.org:8080", "",
                             "0.0.0.0", "127.0.0.1@example.org", "[::1", "192.168.1.7"}) {
        EXPECT_EQ(status_of(get(with_token("/"), host)) / 100, 4) << host;
        const std::string origin = std::string("Origin: http://") + host + "\r\n";
        EXPECT_EQ(status_of(get(with_token("/"), "localhost", origin)) / 100, 4) << host;
    }
    for (const char* origin : {"null", "https://localhost", "file://", "localhost"}) {
        EXPECT_EQ(
            status_of(get(with_token("/"), "localhost", std::string("Origin: ") + origin + "\r\n")) / 100, 4)
            << origin;
    }
}

TEST_F(StudioAccess, AWebSocketOfAnotherPageIsRefused) {
    const std::string upgrade =
        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    EXPECT_EQ(status_of(get(with_token("/socket"), "localhost", upgrade + "Origin: http://example.org\r\n")),
              403);
    EXPECT_EQ(status_of(get("/socket?token=0", "localhost", upgrade)), 403);
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", upgrade)), 404);
    EXPECT_EQ(status_of(get(with_token("/socket"))), 426);
}

TEST_F(StudioAccess, OtherPathsAndMethodsAreRefused) {
    for (const char* path :
         {"/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/page.html", "//", "/index.html", "/%00", "/%zz",
          "/export?to=../../etc/passwd", "/export?to=/etc/passwd", "/export?to=..%2f..%2fetc%2fpasswd"}) {
        const std::string answer = get(with_token(path));
        EXPECT_EQ(status_of(answer) / 100, 4) << path;
        EXPECT_THAT(answer, testing::Not(testing::HasSubstr("root:"))) << path;
    }
    const std::string rest = " " + with_token("/") + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE"})
        EXPECT_EQ(status_of(http(studio_.port(), method + rest)), 405) << method;
    EXPECT_EQ(status_of(http(studio_.port(), "HEAD" + rest)), 200);
}

TEST_F(StudioAccess, MalformedAndHugeRequestsAreRefused) {
    EXPECT_EQ(status_of(http(studio_.port(), "nonsense\r\n\r\n")), 400);
    EXPECT_EQ(status_of(http(studio_.port(), "GET / HTTP/1.1\r\n\r\n")), 403) << "no Host";
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", "Host: localhost\r\n")), 403) << "two";
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", "Content-Length: 1000000000\r\n")), 413);
    EXPECT_EQ(status_of(get("/?" + std::string(100'000, 'a'))), 431);
    EXPECT_EQ(status_of(get(with_token("/"))), 200) << "it is still there";
}

TEST_F(StudioAccess, TwoOriginsAreRefusedAsTwoHostsAre) {
    const std::string own = "Origin: http://localhost\r\n";
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", own)), 200);
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", own + own)), 403);
    EXPECT_EQ(status_of(get(with_token("/"), "localhost", own + "Origin: http://example.org\r\n")), 403);
}

TEST_F(StudioAccess, ConnectionsWhoseRequestNeverComesKeepNobodyOut) {
    std::vector<std::unique_ptr<test::Wire>> halves;
    for (int i = 0; i < 200; ++i) {
        halves.push_back(std::make_unique<test::Wire>(studio_.port()));
        (void)halves.back()->send("GET / HT");
    }
    EXPECT_EQ(status_of(get(with_token("/"))), 200);
    EXPECT_EQ(halves.front()->receive_all(), "") << "who waits longest gives way";
    ASSERT_TRUE(halves.back()->send("TP/1.1\r\n\r\n"));
    EXPECT_EQ(status_of(halves.back()->receive_all()), 403) << "no Host: it is still heard";
}

TEST_F(StudioAccess, NoMorePagesThanTheLimitAreServed) {
    std::vector<std::unique_ptr<test::Client>> pages;
    for (int i = 0; i < 64; ++i) pages.push_back(std::make_unique<test::Client>(studio_.address()));
    test::Wire further(studio_.port());
    EXPECT_EQ(status_of(further.receive_all()), 429) << "it need not send anything";
}

/// Nothing is behind it.
class NoService : public Service {
  public:
    void get(const Target&, std::function<void(HttpAnswer)> answer) override { answer({}); }
    void connected(ClientId) override {}
    void disconnected(ClientId) override {}
    void received(ClientId, std::string_view) override {}
};

class StudioServer : public testing::Test {
  protected:
    ~StudioServer() override {
        server_.stop();
        thread_.join();
    }
    NoService service_;
    HttpServer server_{{.token = "token", .request_time = std::chrono::milliseconds(20)}, service_};
    std::thread thread_{[this] { server_.run(); }};
};

TEST_F(StudioServer, GivesUpARequestThatDoesNotEnd) {
    test::Wire slow(server_.port());
    ASSERT_TRUE(slow.send("GET / HT"));
    EXPECT_EQ(slow.receive_all(), "");
}

TEST_F(StudioServer, GoesOnWhenTheSystemHasDescriptorsAgain) {
    rlimit usual{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &usual), 0);
    const int highest = ::dup(0);
    ASSERT_GE(highest, 0);
    std::optional<test::Wire> client;
    {
        ::close(highest);
        // The client's socket is the last descriptor that there is: the server has none to accept with.
        const rlimit few{static_cast<rlim_t>(highest) + 1, usual.rlim_max};
        ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
        client.emplace(server_.port());
        EXPECT_EQ(::dup(0), -1);
        ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &usual), 0);
    }
    ASSERT_TRUE(client->send(get_request("/?token=token")));
    EXPECT_EQ(status_of(client->receive_all()), 200);
}

TEST(StudioToken, IsLongAndAnotherOneEachTime) {
    const std::string token = make_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_NE(token, make_token());
    EXPECT_TRUE(is_token(token, token));
    EXPECT_FALSE(is_token(token.substr(0, 31), token));
    EXPECT_FALSE(is_token("", token));
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
