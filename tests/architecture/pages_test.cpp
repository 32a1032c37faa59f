// SPDX-License-Identifier: GPL-3.0-or-later
// The pages: tables keep their columns, and links lead to files.
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace fretwork {
namespace THIS_TEST {

namespace fs = std::filesystem;

const fs::path kRoot = FRETWORK_SOURCE_DIR;

/// Packages of the studio's page, where somebody works on it.
bool is_of_others(const fs::path& file) {
    return file.string().find("node_modules") != std::string::npos;
}

std::vector<fs::path> pages() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(kRoot))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    for (const char* folder : {"docs", "framework", "experiments", "apps", "tests", "bench"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.path().extension() == ".md" && !is_of_others(entry.path()))
                found.push_back(entry.path());
    return found;
}

/// The lines of a page; those of code blocks are empty.
std::vector<std::string> lines_of(const fs::path& page) {
    std::vector<std::string> lines = base::split(base::read_text_file(page), '\n');
    bool is_code = false;
    for (std::string& line : lines) {
        const bool is_fence = line.starts_with("```");
        if (is_code || is_fence) line.clear();
        if (is_fence) is_code = !is_code;
    }
    return lines;
}

/// The cells of a table's row; nothing for other lines. Bars within code are no borders.
std::optional<std::size_t> cell_count(const std::string& line) {
    static const std::regex code("`[^`]*`");
    if (!line.starts_with("|")) return std::nullopt;
    return base::split(std::regex_replace(line, code, ""), '|').size() - 2;
}

std::string place(const fs::path& page, std::size_t line) {
    return fs::relative(page, kRoot).generic_string() + ":" + std::to_string(line + 1);
}

TEST(Pages, RowsOfATableHaveTheCellsOfItsFirst) {
    std::size_t rows = 0;
    for (const fs::path& page : pages()) {
        std::optional<std::size_t> first;
        const auto lines = lines_of(page);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto count = cell_count(lines[i]);
            if (count && first) {
                EXPECT_EQ(*count, *first) << place(page, i);
                ++rows;
            }
            first = count ? (first ? first : count) : std::nullopt;
        }
    }
    EXPECT_GT(rows, 500U);
}

TEST(Pages, LinksLeadToFiles) {
    static const std::regex link(R"(\]\(([^)\s#]+)[^)]*\))");
    std::size_t links = 0;
    for (const fs::path& page : pages()) {
        const auto lines = lines_of(page);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (std::sregex_iterator match(lines[i].begin(), lines[i].end(), link), end; match != end;
                 ++match) {
                const std::string target = (*match)[1];
                if (target.starts_with("http")) continue;
                EXPECT_TRUE(fs::exists(page.parent_path() / target)) << place(page, i) << ": " << target;
                ++links;
            }
        }
    }
    EXPECT_GT(links, 50U);
}

/// The sum of a census's last column.
long valid_patterns(const fs::path& census) {
    long sum = 0;
    const auto lines = base::split(base::read_text_file(census), '\n');
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (!lines[i].empty()) sum += std::stol(base::split(lines[i], ',').back());
    return sum;
}

/// "| [`paper7`](paper7.svg) | the paper's | 17 | 1,824 | 1,726 | 440 |"
TEST(Pages, LayoutsHaveTheNumberOfPatternsOfTheirCensus) {
    static const std::regex row(R"(\| \[`(\w+)`\]\(\w+\.svg\) \|[^|]*\|[^|]*\| ([\d,]+) \|.*)");
    const fs::path folder = kRoot / "experiments/layouts";
    int layouts = 0;
    for (const std::string& line : lines_of(folder / "README.md")) {
        std::smatch match;
        if (!std::regex_match(line, match, row)) continue;
        const std::string number = std::regex_replace(match[2].str(), std::regex(","), "");
        EXPECT_EQ(std::stol(number), valid_patterns(folder / (match[1].str() + ".csv"))) << match[1];
        ++layouts;
    }
    EXPECT_EQ(layouts, 8);
}

}  // namespace THIS_TEST
}  // namespace fretwork
