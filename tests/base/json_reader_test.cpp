// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/json_reader.hpp>

#include <cmath>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

using test::complaint_of;
using testing::HasSubstr;
using testing::StartsWith;

JsonReader parsed(std::string_view text) {
    return JsonReader::from_text(text, "test.json");
}

TEST(JsonReader, ReadsWhatIsThere) {
    const auto json = parsed(R"({"a": 1.5, "b": [1, 2, 3], "c": "x", "d": true, "e": {"f": 7}})");
    EXPECT_EQ(json.at("a").number(), 1.5);
    EXPECT_EQ(json.at("b").numbers(3), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(json.at("c").string(), "x");
    EXPECT_TRUE(json.at("d").boolean());
    EXPECT_EQ(json.at("e").at("f").integer(0, 10), 7);
    EXPECT_FALSE(json.find("g").has_value());
    EXPECT_FALSE(json.at("d").is_null());
    EXPECT_TRUE(parsed("[null]").elements()[0].is_null());
    EXPECT_EQ(json.at("b").elements()[2].pointer(), "/b/2");
}

TEST(JsonReader, MembersKeepTheOrderOfTheFile) {
    const auto members = parsed(R"({"z": 1, "a": 2, "m": 3})").members();
    EXPECT_EQ(members[0].first + members[1].first + members[2].first, "zam");
}

/// The parser itself would stop there and take the rest for nothing.
TEST(JsonReader, NothingFollowsAByteOfZero) {
    const std::string text = "{}" + std::string(1, '\0') + "garbage{{{";
    EXPECT_THAT(complaint_of([&] { (void)JsonReader::from_text(text, "f.json"); }),
                HasSubstr("f.json: is no JSON: byte 3 is 0"));
}

TEST(JsonReader, MalformedTextIsRefusedWithLineAndColumn) {
    EXPECT_THAT(complaint_of([] { parsed("{\n  \"a\": 1,\n  \"b\" 2\n}"); }),
                StartsWith("test.json: line 3, column "));
    EXPECT_THAT(complaint_of([] { parsed(R"({"a": [1, 2)"); }), HasSubstr("line 1"));
    EXPECT_THAT(complaint_of([] { parsed(""); }), HasSubstr("malformed JSON"));
    EXPECT_THAT(complaint_of([] { parsed(R"({"a": NaN})"); }), HasSubstr("line 1, column 7"));
}

TEST(JsonReader, NumbersThatAreNotFiniteAreRefused) {
    EXPECT_THROW(parsed(R"({"a": 1e999})"), InputError);
    EXPECT_THROW(parsed(R"({"a": Infinity})"), InputError);
}

TEST(JsonReader, ARepeatedKeyIsRefused) {
    EXPECT_THAT(complaint_of([] { parsed(R"({"a": {"b": 1, "b": 2}})"); }), HasSubstr("'b' appears twice"));
    EXPECT_NO_THROW(parsed(R"({"a": {"b": 1}, "c": {"b": 2}})"));
}

TEST(JsonReader, ARepeatedKeyAmongManyIsFoundAndItsPlaceNamed) {
    std::string text = "{\"list\": [1, {";
    for (int i = 0; i < 1000; ++i) text += "\"k" + std::to_string(i) + "\": 0, ";
    EXPECT_EQ(complaint_of([&] { parsed(text + "\"k500\": 1}]}"); }),
              "test.json: /list/1: the key 'k500' appears twice in one object");
    EXPECT_NO_THROW(parsed(text + "\"k1000\": 1}]}"));
}

// Functions that call themselves would run out of stack on it.
TEST(JsonReader, ADeepNestIsRefused) {
    EXPECT_NO_THROW(parsed(std::string(100, '[') + std::string(100, ']')));
    EXPECT_THAT(complaint_of([] { parsed(std::string(1'000'000, '[')); }),
                HasSubstr("nested more than 100 deep"));
}

TEST(JsonReader, ATooLargeNumberIsNamedWithItsLine) {
    EXPECT_THAT(complaint_of([] { parsed("{\"a\":\n 1e999}"); }), StartsWith("test.json: line 2, column "));
}

// Two parsers share the work, and both have to read a number to its last bit.
TEST(JsonReader, NumbersAreReadToTheLastBit) {
    const auto json = parsed(R"([0.1, 5e-324, 1.7976931348623157e308, -0.0, -3, 18446744073709551615,
                                 18446744073709551616, 9007199254740993, 0.30000000000000004])");
    EXPECT_EQ(json.numbers(9),
              (std::vector<double>{0.1, 5e-324, 1.7976931348623157e308, -0.0, -3.0, 18446744073709551615.0,
                                   18446744073709551616.0, 9007199254740993.0, 0.1 + 0.2}));
    EXPECT_TRUE(std::signbit(json.elements()[3].number()));
}

TEST(JsonReader, HalvesOfCharactersAndBytesThatAreNoTextAreRefused) {
    for (const char* text : {R"("\ud800")", R"("\udc00")", R"("\ud800x")", "\"\xff\"", "\"\xed\xa0\x80\""})
        EXPECT_THAT(complaint_of([&] { parsed(text); }), HasSubstr("line 1, column ")) << text;
    EXPECT_EQ(parsed(R"("\ud83d\ude00")").string(), "\xf0\x9f\x98\x80");
}

TEST(JsonReader, OutlivesTheReaderThatItCameFrom) {
    const auto inner = [] { return parsed(R"({"a": [5]})").at("a").elements()[0]; }();
    EXPECT_EQ(inner.number(), 5);
    EXPECT_EQ(inner.pointer(), "/a/0");
}

TEST(JsonReader, AnUnknownKeyIsRefusedWithTheNearestKnownOne) {
    const auto json = parsed(R"({"lenght": 1})");
    EXPECT_EQ(complaint_of([&] {
                  json.allow_only({"length", "width"});
              }),
              "test.json: /lenght: unknown key 'lenght'; did you mean 'length'?");
    EXPECT_THAT(complaint_of([&] { json.allow_only({"area"}); }), HasSubstr("there is: area"));
}

TEST(JsonReader, AMissingKeyIsNamedWithItsPlace) {
    EXPECT_EQ(complaint_of([] { (void)parsed(R"({"a": {}})").at("a").at("b"); }),
              "test.json: /a: the key 'b' is missing");
}

TEST(JsonReader, WrongTypesNameThePlaceAndTheValue) {
    const auto json = parsed(R"({"a": ["x", 3, 2.5, -1, null]})");
    const auto element = [&](std::size_t i) { return json.at("a").elements()[i]; };
    EXPECT_EQ(complaint_of([&] { (void)element(0).number(); }),
              "test.json: /a/0: is \"x\", where a number is needed");
    EXPECT_THAT(complaint_of([&] { (void)element(1).string(); }), HasSubstr("is 3, where a text is needed"));
    EXPECT_THAT(complaint_of([&] { (void)element(2).integer(0, 9); }),
                HasSubstr("a whole number from 0 to 9"));
    EXPECT_THAT(complaint_of([&] { (void)element(3).positive_number(); }), HasSubstr("above zero"));
    EXPECT_THAT(complaint_of([&] { (void)element(4).boolean(); }), HasSubstr("is null"));
    EXPECT_THAT(complaint_of([&] { (void)json.at("a").numbers(3); }),
                HasSubstr("has 5 elements, where 3 are needed"));
    EXPECT_THAT(complaint_of([&] { (void)json.elements(); }), HasSubstr("an array is needed"));
}

TEST(JsonReader, IntegersBeyondTheRangeAreRefused) {
    EXPECT_THROW((void)parsed("18446744073709551615").integer(-1, 10), InputError);
    EXPECT_THROW((void)parsed("-5").integer(-1, 10), InputError);
    EXPECT_EQ(parsed("-1").integer(-1, 10), -1);
}

TEST(JsonReader, TheFormatMustBeTheWantedOne) {
    EXPECT_NO_THROW(parsed(R"({"format": "fretwork/frame/1"})").expect_format("frame"));
    EXPECT_THAT(complaint_of([] { parsed(R"({"format": "fretwork/frame/2"})").expect_format("frame"); }),
                HasSubstr("\"fretwork/frame/1\" is needed"));
}

TEST(JsonReader, PointersEscapeTheirSpecialCharacters) {
    EXPECT_EQ(parsed(R"({"a/b~c": 1})").at("a/b~c").pointer(), "/a~1b~0c");
}

/// What checks a value does not know where the value stands.
TEST(JsonReader, AnErrorAboutAPartOfAValueNamesThePart) {
    const auto json = parsed(R"({"a": {"list": [{"width": 1}], "name": "x"}})");
    const auto complaint = [&](const std::string& place) {
        return complaint_of([&] { json.at("a").located([&] { throw InputError("", place, "is wrong"); }); });
    };
    EXPECT_EQ(complaint("/list/0/width"), "test.json: /a/list/0/width: is wrong");
    EXPECT_EQ(complaint(""), "test.json: /a: is wrong");
    EXPECT_EQ(complaint("line 3"), "test.json: /a: line 3: is wrong");
    // The document does not have these.
    EXPECT_EQ(complaint("/list/0/area"), "test.json: /a/list/0: area: is wrong");
    EXPECT_EQ(complaint("/list/1/area"), "test.json: /a/list: 1/area: is wrong");
    EXPECT_EQ(complaint("/name/first"), "test.json: /a/name: first: is wrong");
    // A source of its own is no part of the value.
    EXPECT_EQ(complaint_of(
                  [&] { json.at("a").located([] { throw InputError("other.json", "/list", "is wrong"); }); }),
              "test.json: /a: other.json: /list: is wrong");
}

TEST(JsonReader, APartOfASourceHasItsPlaceThere) {
    const auto json = JsonReader::from_text(R"({"b": [1]})", "whole.json", "/a/2");
    EXPECT_EQ(json.pointer(), "/a/2");
    EXPECT_EQ(complaint_of([&] { (void)json.at("b").elements()[0].string(); }),
              "whole.json: /a/2/b/0: is 1, where a text is needed");
}

TEST(JsonReader, AKeyThatItsFormatDoesNotHaveIsNamedAtItsPlace) {
    const auto json = parsed(R"({"format": "fretwork/k/1", "list": [{"old": 1}, {"new": 2}]})");
    EXPECT_EQ(complaint_of([&] { json.require_format("fretwork/k/2", "new"); }),
              "test.json: /list/1/new: fretwork/k/1 has no new; fretwork/k/2 has");
    EXPECT_NO_THROW(json.require_format("fretwork/k/1", "new"));
}

TEST(JsonReader, LongValuesAreShortenedInMessages) {
    const auto json = parsed("{\"a\": \"" + std::string(5000, 'x') + "\"}");
    EXPECT_LT(complaint_of([&] { (void)json.at("a").number(); }).size(), 200U);
    EXPECT_LT(complaint_of([&] { json.allow_only({"b"}); }).size(), 200U);
    const std::string key(5000, 'k');
    EXPECT_LT(complaint_of([&] { parsed("{\"" + key + "\": 1}").allow_only({"b"}); }).size(), 300U);
    EXPECT_LT(complaint_of([&] { parsed("{\"a\": " + key + "}"); }).size(), 300U);
    EXPECT_LT(complaint_of([&] { parsed("{\"a\": 1" + std::string(5000, '0') + "}"); }).size(), 300U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
