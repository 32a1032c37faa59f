// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/internal/json_text.hpp>

#include <limits>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

TEST(JsonText, ReadsBackAsTheSameDocument) {
    Json document;
    document["numbers"] = {0.1, 1e-300, 1.0 / 3.0, -0.0};
    document["nested"] = {{1, 2}, {3}, Json::array()};
    document["empty"] = Json::object();
    document["text"] = "quotes \" and\nlines";
    EXPECT_EQ(Json::parse(json_text(document)), document);
}

TEST(JsonText, WritesValuesWithTheCharactersOfDump) {
    const double numbers[] = {0.0, -0.0, 1.0, 0.1, 1.0 / 3.0, -2.5e-300, 1e23, 123456789.0, 5e-324, 1.7e308};
    for (const double number : numbers) EXPECT_EQ(json_text(Json(number)), Json(number).dump() + "\n");
    for (const long long number : {0LL, -1LL, std::numeric_limits<long long>::min()})
        EXPECT_EQ(json_text(Json(number)), Json(number).dump() + "\n");
    const Json largest = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(json_text(largest), "18446744073709551615\n");
    for (const char* text : {"", "plain ~", "a \"quote\"", "back\\slash", "tab\t"})
        EXPECT_EQ(json_text(Json(text)), Json(text).dump() + "\n");
}

TEST(JsonText, PutsARowOfNumbersOnOneLine) {
    Json document;
    document["rows"] = {{1, 2, 3}, {4, 5, 6}};
    EXPECT_EQ(json_text(document), "{\n  \"rows\": [\n    [1, 2, 3],\n    [4, 5, 6]\n  ]\n}\n");
}

TEST(JsonText, ATableIsWrittenAsTheArrayOfItsRows) {
    const std::vector<double> numbers = {0.1, -0.0, 3.0, 4e-300, 5.0, 6.0};
    Json table, rows;
    table["rows"] = number_rows(numbers, 3);
    rows["rows"] = {{0.1, -0.0, 3.0}, {4e-300, 5.0, 6.0}};
    EXPECT_EQ(json_text(table), json_text(rows));
    EXPECT_EQ(json_text(number_rows({}, 3)), json_text(Json::array()));
    EXPECT_THAT(test::complaint_of([&] { (void)number_rows(numbers, 4); }), testing::HasSubstr("rows of 4"));
}

// C0, C1, a mark that turns the direction of writing, and DEL; an umlaut is no danger.
TEST(JsonText, EscapesWhatATerminalObeys) {
    const Json document = "a\x1b[31m\xc2\x9b\xe2\x80\xae\x7f\xc3\xa4";
    const std::string text = json_text(document);
    for (const char* harmful : {"\x1b", "\xc2\x9b", "\xe2\x80\xae", "\x7f"})
        EXPECT_THAT(text, testing::Not(testing::HasSubstr(harmful)));
    EXPECT_EQ(Json::parse(text), document);
    EXPECT_EQ(json_text(Json("\xc3\xa4")), "\"\xc3\xa4\"\n");
}

TEST(JsonText, RefusesNumbersThatAreNotFinite) {
    Json document;
    document["bad"] = {1.0, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_THAT(test::complaint_of([&] { json_text(document); }), testing::HasSubstr("'bad'"));
    document["bad"] = number_rows(std::vector<double>{1.0, std::numeric_limits<double>::infinity()}, 2);
    EXPECT_THAT(test::complaint_of([&] { json_text(document); }), testing::HasSubstr("'bad'"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
