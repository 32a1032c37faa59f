// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/json_reader.hpp>

#include <gtest/gtest.h>

namespace fretwork::base {
namespace THIS_TEST {

/// The error that an action throws.
template <class SomeError, class Action>
ErrorData error_of(const Action& action) {
    try {
        action();
    } catch (const SomeError& error) {
        EXPECT_EQ(error.what(), text_of(error.data()));
        return error.data();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

TEST(Error, ItsTextIsMadeOfItsData) {
    EXPECT_STREQ(InputError("is empty").what(), "is empty");
    EXPECT_STREQ(InputError("a.json", "/nodes/1", "is empty").what(), "a.json: /nodes/1: is empty");
    EXPECT_STREQ(InputError("a.json", "", "is empty").what(), "a.json: is empty");
    EXPECT_EQ(text_of({.problem = "is not a number", .where = {{"a.json", "/b"}, {"b.json", "line 3"}}}),
              "a.json: /b: b.json: line 3: is not a number");
}

/// what() is a C string, which a NUL would end.
TEST(Error, ANulInAnyPartIsShown) {
    using namespace std::string_literals;
    EXPECT_STREQ(InputError("a.json"s, "/b\0c"s, "unknown key 'b\0c\0'; there is: format"s).what(),
                 "a.json: /b\\x00c: unknown key 'b\\x00c\\x00'; there is: format");
    const JsonReader json = JsonReader::from_text(R"({"b\u0000c": "d\u0000e"})", "a.json");
    EXPECT_EQ(text_of(error_of<InputError>([&] { json.allow_only({"format"}); })),
              "a.json: /b\\x00c: unknown key 'b\\x00c'; there is: format");
    EXPECT_EQ(text_of(error_of<InputError>([&] { (void)json.members().front().second.choice({"circle"}); })),
              "a.json: /b\\x00c: unknown choice 'd\\x00e'; there is: circle");
}

TEST(Error, InsideOfASourceKeepsItsTypeItsKindAndItsOwnPlace) {
    const ErrorData data = error_of<GeometryError>([] {
        try {
            throw GeometryError({.problem = "crosses itself",
                                 .where = {{"b.svg", "path 2"}},
                                 .kind = ErrorKind::MovesFreely,
                                 .about = {"node 3"}});
        } catch (const GeometryError& error) {
            throw within("a.json", "/outline", error);
        }
    });
    EXPECT_EQ(text_of(data), "a.json: /outline: b.svg: path 2: crosses itself");
    EXPECT_EQ(data.kind, ErrorKind::MovesFreely);
    EXPECT_EQ(data.about, std::vector<std::string>{"node 3"});
}

TEST(Error, OfTheWantedTypeIsLocatedAndNoOther) {
    EXPECT_EQ(located("a.json", "/b", [] { return 3; }), 3);
    const auto crossing = [] { throw GeometryError("crosses itself"); };
    const ErrorData data =
        error_of<GeometryError>([&] { located<GeometryError>("a.json", "/outline", crossing); });
    EXPECT_EQ(text_of(data), "a.json: /outline: crosses itself");
    const auto full = [] { throw IoError("disk full"); };
    EXPECT_EQ(text_of(error_of<IoError>([&] { located("a.json", "", full); })), "disk full");
}

TEST(Error, ASourceIsFoundAndRenamedAsAWhole) {
    const IoError error({.problem = "draft.db is full", .where = {{"list", ""}, {"draft.db", "row 1"}}});
    EXPECT_TRUE(names_source(error, "draft.db"));
    EXPECT_FALSE(names_source(error, "draft"));
    EXPECT_STREQ(renamed(error, "draft.db", "out.db").what(), "list: out.db: row 1: draft.db is full");
    EXPECT_STREQ(renamed(error, "draft", "out").what(), error.what());
}

TEST(Error, AValueOfAJsonDocumentThatIsRefusedKeepsItsKind) {
    const JsonReader json = JsonReader::from_text(R"({"model": "x"})", "p.json");
    const ErrorData data = error_of<InputError>([&] {
        json.at("model").located(
            [] { throw InputError({.problem = "is not known", .kind = ErrorKind::NotCalibrated}); });
    });
    EXPECT_EQ(text_of(data), "p.json: /model: is not known");
    EXPECT_EQ(data.kind, ErrorKind::NotCalibrated);
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
