// SPDX-License-Identifier: GPL-3.0-or-later
// The corpora of the fuzzer, read by the ordinary build: as they are, cut short, and with bytes changed.
#include "fuzz/readers.hpp"
#include "support.hpp"

#include <fretwork/base/random.hpp>

#include <algorithm>
#include <set>

namespace fretwork::fuzz {

/// The name of a test is that of its reader.
static void PrintTo(const Reader& reader, std::ostream* out) {
    *out << reader.name;
}

namespace THIS_TEST {

namespace fs = std::filesystem;

const fs::path kCorpora = fs::path(FRETWORK_SOURCE_DIR) / "tests" / "fuzz" / "corpora";

/// In the order of their names, which does not depend on the file system.
std::vector<fs::path> inputs_of(const Reader& reader) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kCorpora / reader.name)) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// What a fuzzer found may be refused; all else is an example of what is valid.
bool was_found(const fs::path& file) {
    return file.filename().string().starts_with("found_");
}

class Readers : public testing::TestWithParam<Reader> {};

TEST_P(Readers, TakeTheExamplesOfTheirCorpora) {
    int examples = 0;
    for (const fs::path& file : inputs_of(GetParam())) {
        const Answer answer = feed(GetParam(), base::read_text_file(file));
        if (was_found(file)) continue;
        EXPECT_EQ(answer, Answer::Taken) << file;
        ++examples;
    }
    EXPECT_GT(examples, 0);
}

/// Whatever they answer: a finding would end this program.
TEST_P(Readers, AnswerWhateverIsCutShort) {
    constexpr std::size_t kCuts = 24;
    for (const fs::path& file : inputs_of(GetParam())) {
        const std::string whole = base::read_text_file(file);
        for (std::size_t cut = 0; cut < kCuts; ++cut)
            (void)feed(GetParam(), whole.substr(0, whole.size() * cut / kCuts));
    }
}

/// Bytes that mean something in most formats, beside any.
char another_byte(base::SplitMix64& random) {
    constexpr std::string_view kTelling = "0123456789-+.eE\"{}[],:<>/ \n";
    if (random.below(2) == 0) return kTelling[random.below(kTelling.size())];
    return static_cast<char>(random.below(256));
}

TEST_P(Readers, AnswerWhateverHasOtherBytes) {
    constexpr int kEdited = 40;
    base::SplitMix64 random(1);
    for (const fs::path& file : inputs_of(GetParam())) {
        const std::string whole = base::read_text_file(file);
        for (int i = 0; i < kEdited && !whole.empty(); ++i) {
            std::string edited = whole;
            for (std::size_t n = 1 + random.below(4); n > 0; --n)
                edited[random.below(edited.size())] = another_byte(random);
            (void)feed(GetParam(), edited);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Readers, testing::ValuesIn(readers().begin(), readers().end()));

TEST(Corpora, AreThoseOfTheReaders) {
    std::set<std::string> folders;
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(kCorpora)) folders.insert(entry.path().filename());
    for (const Reader& reader : readers()) names.emplace(reader.name);
    EXPECT_EQ(folders, names);
}

}  // namespace THIS_TEST
}  // namespace fretwork::fuzz
