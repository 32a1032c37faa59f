// SPDX-License-Identifier: GPL-3.0-or-later
// Citations: comments and pages cite as [Key], or [Key, Other], and docs/references.bib has the keys.
#include <fretwork/base/files/file.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace fretwork {
namespace THIS_TEST {

namespace fs = std::filesystem;

const fs::path kRoot = FRETWORK_SOURCE_DIR;

std::set<std::string> first_groups(const std::string& text, const std::regex& form) {
    std::set<std::string> groups;
    for (std::sregex_iterator match(text.begin(), text.end(), form), end; match != end; ++match)
        groups.insert((*match)[1]);
    return groups;
}

std::set<std::string> keys_of_references() {
    static const std::regex entry(R"(@[a-z]+\{(\w+),)");
    return first_groups(base::read_text_file(kRoot / "docs" / "references.bib"), entry);
}

std::set<std::string> cited_keys(const std::string& text) {
    static const std::regex citation(R"(\[([A-Z][A-Za-z]+\d{4}(?:, [A-Z][A-Za-z]+\d{4})*)\])");
    static const std::regex key(R"(([A-Z][A-Za-z]+\d{4}))");
    std::set<std::string> keys;
    for (const std::string& list : first_groups(text, citation)) keys.merge(first_groups(list, key));
    return keys;
}

/// Where each key is cited first, in the order of the folders.
std::map<std::string, std::string> citations() {
    const std::set<std::string> endings = {".hpp", ".cpp", ".md", ".py"};
    std::map<std::string, std::string> found;
    for (const char* folder : {"docs", "framework", "experiments", "apps", "tests", "bench"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            if (!endings.contains(entry.path().extension().string())) continue;
            if (entry.path().string().find("node_modules") != std::string::npos) continue;  // not ours
            for (const std::string& key : cited_keys(base::read_text_file(entry.path())))
                found.try_emplace(key, fs::relative(entry.path(), kRoot).generic_string());
        }
    }
    return found;
}

TEST(Citations, AreInTheListOfReferences) {
    const std::set<std::string> references = keys_of_references();
    ASSERT_TRUE(references.contains("Manolas2022"));
    const auto cited = citations();
    ASSERT_FALSE(cited.empty());
    for (const auto& [key, file] : cited) {
        EXPECT_TRUE(references.contains(key)) << file << " cites [" << key << "]";
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork
