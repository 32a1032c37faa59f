// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/sample.hpp"

#include <fretwork/exports/tables/library_stiffness.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>

#include <cstring>

namespace fretwork::exports {
namespace THIS_TEST {

using fretwork::test::TemporaryFolder;

constexpr int kSide = 36;

/// The matrix of one pattern of an array of this many, read as NumPy reads it.
Eigen::MatrixXd matrix_at(const std::string& npy, std::size_t count, std::size_t place) {
    const std::size_t bytes = kSide * kSide * sizeof(double);
    Eigen::Matrix<double, kSide, kSide, Eigen::RowMajor> matrix;
    std::memcpy(matrix.data(), npy.data() + npy.size() - (count - place) * bytes, bytes);
    return matrix;
}

TEST(LibraryStiffness, HoldsTheCondensedFrameOfEachPattern) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    const auto patterns = library.patterns();
    const std::string npy = stiffness_array(library, patterns);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const Eigen::MatrixXd expected = reduction::condensed_frame(
            reduction::pattern_frame(library.layout(), patterns[i].pattern, library.setting()), 6);
        EXPECT_EQ(matrix_at(npy, patterns.size(), i), expected) << patterns[i].id;
    }
}

TEST(LibraryStiffness, BeginsAsNumpyExpectsAndAligned) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    const std::string npy = stiffness_array(library, library.patterns());
    ASSERT_EQ(npy.substr(0, 6), "\x93NUMPY");
    const auto length = static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
    EXPECT_EQ((10 + length) % 64, 0U);
    EXPECT_EQ(npy.size(), 10 + length + library.pattern_count() * kSide * kSide * sizeof(double));
    const std::string shape = "'shape': (" + std::to_string(library.pattern_count()) + ", 36, 36)";
    EXPECT_NE(npy.substr(10, length).find(shape), std::string::npos);
    EXPECT_EQ(npy[9 + length], '\n');
}

TEST(LibraryStiffness, DoesNotDependOnTheNumberOfThreads) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    EXPECT_EQ(stiffness_array(library, library.patterns(), {.threads = 1}),
              stiffness_array(library, library.patterns(), {.threads = 3}));
}

TEST(LibraryStiffness, NamesItsPatternsInOrder) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    base::FolderBatch batch(folder.path() / "stiffness");
    add_stiffness(library, library.patterns(), {}, batch);
    batch.commit();
    std::string expected;
    for (const auto& entry : library.patterns()) expected += entry.id + "\n";
    EXPECT_EQ(base::read_text_file(folder.path() / "stiffness" / "patterns.txt"), expected);
}

/// Exports, or gives why not.
std::string refusal_of(const std::filesystem::path& folder, const library::Library& library,
                       std::span<const pattern::NamedPattern> patterns) {
    base::FolderBatch batch(folder);
    add_stiffness(library, patterns, {}, batch);
    try {
        require_same_stiffness(folder, batch);
    } catch (const base::InputError& error) {
        return error.what();
    }
    batch.commit();
    return "";
}

TEST(LibraryStiffness, IsRepeatedInItsFolderAndReplacesNoOther) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    const auto patterns = library.patterns();
    const std::filesystem::path place = folder.path() / "stiffness";
    EXPECT_EQ(refusal_of(place, library, patterns), "");
    const std::string before = base::read_text_file(place / "stiffness.npy");
    EXPECT_EQ(refusal_of(place, library, patterns), "") << "the same once more";
    EXPECT_THAT(refusal_of(place, library, std::span(patterns).first(2)), testing::HasSubstr("other"));
    reduction::Setting wider = library.setting();
    wider.section = mechanics::rectangle_section(0.003, 0.002);
    auto of_wide_bars = library::Library::create(folder.path() / "wide.db", library.layout(), wider);
    of_wide_bars.add_patterns(library::test::parse(library::test::sample_ids()));
    EXPECT_THAT(refusal_of(place, of_wide_bars, patterns), testing::HasSubstr("stiffness.npy: is there"));
    EXPECT_EQ(base::read_text_file(place / "stiffness.npy"), before);
}

/// One bit, one file alone, and a list that somebody has written.
TEST(LibraryStiffness, ComparesEveryByte) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    const std::filesystem::path place = folder.path() / "stiffness";
    ASSERT_EQ(refusal_of(place, library, library.patterns()), "");
    std::string bytes = base::read_text_file(place / "stiffness.npy");
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    base::write_file_atomically(place / "stiffness.npy", bytes);
    EXPECT_THAT(refusal_of(place, library, library.patterns()), testing::HasSubstr("stiffness.npy"));
    std::filesystem::remove(place / "stiffness.npy");
    EXPECT_EQ(refusal_of(place, library, library.patterns()), "") << "what is lacking is made";
    base::write_file_atomically(place / "patterns.txt", "flowers\n");
    EXPECT_THAT(refusal_of(place, library, library.patterns()), testing::HasSubstr("patterns.txt"));
    EXPECT_EQ(base::read_text_file(place / "patterns.txt"), "flowers\n");
}

TEST(LibraryStiffness, StopsWhenItIsAskedTo) {
    const TemporaryFolder folder;
    const auto library = library::test::make_library(folder.path() / "lib.db");
    const std::function<bool()> yes = [] { return true; };
    EXPECT_THROW(stiffness_array(library, library.patterns(), {.control = {.question = &yes}}),
                 base::Stopped);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
