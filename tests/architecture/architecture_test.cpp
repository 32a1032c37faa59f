// SPDX-License-Identifier: GPL-3.0-or-later
// The architecture as a test: the direction of data, the fences around libraries, and the shape of files.
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fretwork {
namespace THIS_TEST {

namespace fs = std::filesystem;

const fs::path kSource = FRETWORK_SOURCE_DIR;
const fs::path kFramework = kSource / "framework" / "fretwork";

/// The arrows, written out transitively: a stage may include itself and these.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"geometry", {"base"}},
    {"pattern", {"base", "geometry"}},
    {"mechanics", {"base", "geometry"}},
    {"optimization", {"base"}},
    {"reduction", {"base", "geometry", "pattern", "mechanics", "optimization"}},
    {"library", {"base", "geometry", "pattern", "mechanics", "optimization", "reduction"}},
    {"outlines", {"base", "geometry"}},
    {"tiling", {"base", "geometry", "pattern", "outlines"}},
    {"simulation",
     {"base", "geometry", "pattern", "mechanics", "optimization", "reduction", "library", "outlines",
      "tiling"}},
    {"fabrication",
     {"base", "geometry", "pattern", "mechanics", "optimization", "reduction", "library", "outlines",
      "tiling", "simulation"}},
    {"design",
     {"base", "geometry", "pattern", "mechanics", "optimization", "reduction", "library", "outlines",
      "tiling", "simulation", "fabrication"}},
    {"exports",
     {"base", "geometry", "pattern", "mechanics", "optimization", "reduction", "library", "outlines",
      "tiling", "simulation", "fabrication", "design"}},
};

/// Libraries behind a fence: which stages may use them, and only in files that no user of the framework sees.
const std::map<std::string, std::set<std::string>> kFences = {
    {"CGAL/", {"geometry", "pattern", "outlines", "tiling", "fabrication", "design"}},
    {"OpenMesh/", {"outlines"}},
    {"boost/graph/", {"pattern"}},
    {"nauty/", {"pattern"}},
    {"cholmod", {"mechanics"}},
    {"Eigen/CholmodSupport", {"mechanics"}},
    {"ceres/", {"optimization"}},
    {"nlopt", {"optimization"}},
    {"pagmo/", {"optimization"}},
    {"sqlite3", {"library"}},
    {"nettle/", {"base"}},
    {"pugixml", {"outlines"}},
    {"png.h", {"tiling", "exports"}},
    {"ft2build", {"exports"}},
    {"muParser", {"tiling"}},
    {"polyclipping/", {"fabrication"}},
    {"zip.h", {"exports"}},
    {"nlohmann/",
     {"base", "pattern", "mechanics", "optimization", "reduction", "library", "outlines", "tiling",
      "simulation", "fabrication", "design", "exports"}},
};

/// Rooms of a stage: its folders. The headers of a room are the stage's own unless the room is public; those
/// in a folder detail/, of the stage or of a room, always are. Which other rooms of the stage each may
/// include; what lies in the stage's own folder and in its detail/ is open to a room unless it is closed.
enum class Headers { Private, Public };
enum class Door { Open, Closed };
struct Room {
    Headers headers = Headers::Private;
    std::set<std::string> may_include;
    Door to_stage = Door::Open;
};
const std::map<std::string, std::map<std::string, Room>> kRooms = {
    {"base", {{"files", {Headers::Public, {}}}, {"internal", {Headers::Public, {}}}}},
    {"geometry", {{"internal", {Headers::Public, {}}}}},
    {"pattern",
     {{"filters", {Headers::Private, {}}},
      {"internal", {Headers::Public, {}}},
      {"search", {Headers::Private, {}}}}},
    {"mechanics",
     {{"sparse", {Headers::Private, {}, Door::Closed}},
      {"frame", {Headers::Public, {"internal"}, Door::Closed}},
      {"elements", {Headers::Private, {}}},
      {"structure", {Headers::Private, {"sparse"}}},
      {"results", {Headers::Public, {"frame", "elements", "internal"}}},
      {"internal", {Headers::Public, {"frame", "results"}}},
      {"nonlinear", {Headers::Private, {"sparse", "elements", "structure", "results", "paths"}}},
      {"paths", {Headers::Public, {"nonlinear", "results"}}},
      {"decks", {Headers::Public, {"frame"}, Door::Closed}}}},
    {"optimization",
     {{"methods", {Headers::Public, {}}},
      {"problems", {Headers::Public, {}}},
      {"studies", {Headers::Public, {"methods", "problems"}}}}},
    {"reduction",
     {{"internal", {Headers::Public, {"scenarios"}}},
      {"scenarios", {Headers::Public, {"internal"}}},
      {"models", {Headers::Public, {"scenarios", "calibration"}}},
      {"ring", {Headers::Public, {"scenarios", "calibration", "models"}}},
      {"calibration", {Headers::Public, {"models", "ring", "scenarios"}}}}},
    {"outlines",
     {{"svg", {Headers::Private, {"regions"}}},
      {"dxf", {Headers::Private, {"regions"}}},
      {"meshes", {Headers::Private, {}}},
      {"regions", {Headers::Private, {}}}}},
    {"tiling",
     {{"remeshing", {Headers::Private, {}}},
      {"dual", {Headers::Private, {"remeshing"}}},
      {"painting", {Headers::Public, {}}}}},
    {"simulation",
     {{"derivatives", {Headers::Public, {"results"}}},
      {"internal", {Headers::Public, {"load_cases"}}},
      {"load_cases", {Headers::Public, {"internal"}}},
      {"project", {Headers::Public, {"load_cases", "internal"}}},
      {"results", {Headers::Public, {"load_cases", "internal"}}}}},
    {"design",
     {{"checks", {Headers::Private, {"goals", "search", "swaps", "target"}}},
      {"goals", {Headers::Private, {"target"}}},
      {"reach", {Headers::Private, {"goals", "search", "swaps", "target"}}},
      {"search", {Headers::Private, {"goals", "swaps", "target"}}},
      {"swaps", {Headers::Private, {}}},
      {"target", {Headers::Public, {}}}}},
    {"exports",
     {{"designs", {Headers::Public, {"pages"}}},
      {"pages", {Headers::Private, {}}},
      {"tables", {Headers::Public, {}}},
      {"drawings", {Headers::Public, {"tables"}}},
      {"space", {Headers::Public, {"drawings", "pages", "tables"}}},
      {"making", {Headers::Public, {}}}}},
};

/// Words of later stages that public headers of a stage do not say: what they name is born there.
const std::map<std::string, std::regex> kForeignWords = {
    {"mechanics", std::regex("tessellation|full.tiles|painting", std::regex::icase)},
    {"optimization", std::regex("\\b(beam|tile|pattern|frame)s?\\b", std::regex::icase)},
    {"outlines", std::regex("tessellation|\\btiles?\\b|painting", std::regex::icase)},
    {"tiling", std::regex("\\b(svg|dxf|stiffness)", std::regex::icase)},
};

struct SourceFile {
    std::string name;  ///< relative to framework/fretwork
    std::string stage;
    std::string room;  ///< the folder below the stage's, or nothing
    bool is_public;    ///< a header that is installed: not of a private room, of detail/ or of internal/
    std::vector<std::string> lines;
    std::vector<std::string> includes;
};

/// The parts of a file's path from its stage on: {"mechanics", "sparse", "ldlt.hpp"}.
std::string room_of(const std::vector<std::string>& parts) {
    return parts.size() >= 3 ? parts[1] : "";
}

/// The same for a path from its stage on, or for an include that starts with "fretwork/".
bool is_private(std::vector<std::string> parts) {
    if (!parts.empty() && parts.front() == "fretwork") parts.erase(parts.begin());
    if (std::ranges::find(parts, "detail") != parts.end()) return true;
    const auto rooms = kRooms.find(parts.front());
    if (rooms == kRooms.end()) return false;
    const auto room = rooms->second.find(room_of(parts));
    return room != rooms->second.end() && room->second.headers == Headers::Private;
}

SourceFile read_source(const fs::path& path) {
    SourceFile file;
    const fs::path relative = fs::relative(path, kFramework);
    file.name = relative.generic_string();
    file.stage = relative.begin()->string();
    file.room = room_of(base::split(file.name, '/'));
    file.is_public =
        path.extension() == ".hpp" && file.room != "internal" && !is_private(base::split(file.name, '/'));
    file.lines = base::split(base::read_text_file(path), '\n');
    const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    for (const std::string& line : file.lines) {
        std::smatch match;
        if (std::regex_search(line, match, include)) file.includes.push_back(match[1]);
    }
    return file;
}

const std::vector<SourceFile>& sources() {
    static const std::vector<SourceFile> files = [] {
        std::vector<SourceFile> list;
        for (const auto& entry : fs::recursive_directory_iterator(kFramework)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".hpp" || extension == ".cpp") list.push_back(read_source(entry.path()));
        }
        std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
        return list;
    }();
    return files;
}

/// The stage of an include such as "fretwork/pattern/fan.hpp"; empty for any other.
std::string stage_of(const std::string& include) {
    const auto parts = base::split(include, '/');
    return parts.size() >= 3 && parts[0] == "fretwork" ? parts[1] : "";
}

/// The room of such an include, or nothing.
std::string included_room(const std::string& include) {
    auto parts = base::split(include, '/');
    if (!parts.empty()) parts.erase(parts.begin());
    return room_of(parts);
}

TEST(Architecture, HasAFolderForEveryStageAndNoOther) {
    std::set<std::string> found;
    std::set<std::string> wanted;
    for (const SourceFile& file : sources()) found.insert(file.stage);
    for (const auto& [stage, ignored] : kMayInclude) wanted.insert(stage);
    EXPECT_EQ(found, wanted);
}

TEST(Architecture, StagesIncludeOnlyWhatLiesBeforeThem) {
    for (const SourceFile& file : sources()) {
        for (const std::string& include : file.includes) {
            const std::string stage = stage_of(include);
            if (stage.empty() || stage == file.stage) continue;
            EXPECT_TRUE(kMayInclude.at(file.stage).contains(stage))
                << file.name << " includes <" << include << ">, against the direction of data";
        }
    }
}

TEST(Architecture, FencedLibrariesStayInTheirStages) {
    for (const SourceFile& file : sources()) {
        for (const std::string& include : file.includes) {
            for (const auto& [library, stages] : kFences) {
                if (!include.starts_with(library)) continue;
                EXPECT_TRUE(stages.contains(file.stage)) << file.name << " includes <" << include << ">";
                EXPECT_FALSE(file.is_public) << file.name << " is public and shows <" << include << ">";
            }
        }
    }
}

TEST(Architecture, PrivateHeadersAreNotForPublicHeadersNorForOtherStages) {
    for (const SourceFile& file : sources()) {
        for (const std::string& include : file.includes) {
            if (stage_of(include).empty() || !is_private(base::split(include, '/'))) continue;
            EXPECT_FALSE(file.is_public) << file.name << " is public and includes <" << include << ">";
            EXPECT_EQ(stage_of(include), file.stage) << file.name << " includes <" << include << ">";
        }
    }
}

TEST(Architecture, PublicHeadersAreInstalled) {
    for (const SourceFile& file : sources()) {
        if (!file.is_public) continue;
        const std::string list = base::read_text_file(kFramework / file.stage / "CMakeLists.txt");
        const std::string headers = list.substr(list.find("HEADERS"));
        const std::regex name(
            "[ \n]" + std::regex_replace(file.name.substr(file.stage.size() + 1), std::regex("\\."), "\\.") +
            "[ \n]");
        EXPECT_TRUE(std::regex_search(headers, name))
            << file.name << " is public and not in the list of headers";
    }
}

TEST(Architecture, StagesDoNotSpeakOfLaterOnes) {
    for (const SourceFile& file : sources()) {
        const auto words = kForeignWords.find(file.stage);
        if (words == kForeignWords.end() || !file.is_public) continue;
        for (const std::string& line : file.lines)
            EXPECT_FALSE(std::regex_search(line, words->second)) << file.name << ": " << line;
    }
}

TEST(Architecture, InternalHeadersAreForAllStagesButNotForPublicHeaders) {
    for (const SourceFile& file : sources()) {
        for (const std::string& include : file.includes) {
            if (included_room(include) != "internal") continue;
            EXPECT_FALSE(file.is_public) << file.name << " is public and includes <" << include << ">";
        }
    }
}

TEST(Architecture, RoomsIncludeOnlyTheRoomsThatTheyMay) {
    for (const SourceFile& file : sources()) {
        const auto rooms = kRooms.find(file.stage);
        if (rooms == kRooms.end() || !rooms->second.contains(file.room)) continue;
        const Room& room = rooms->second.at(file.room);
        for (const std::string& include : file.includes) {
            const std::string other = included_room(include);
            if (stage_of(include) != file.stage || other == file.room) continue;
            EXPECT_TRUE(other.empty() || other == "detail" ? room.to_stage == Door::Open
                                                           : room.may_include.contains(other))
                << file.name << " includes <" << include << ">";
        }
    }
}

TEST(Architecture, StagesHaveAFolderForEachOfTheirRoomsAndNoOther) {
    for (const auto& [stage, ignored] : kMayInclude) {
        const auto listed = kRooms.find(stage);
        const auto rooms = listed != kRooms.end() ? listed->second : std::map<std::string, Room>{};
        std::set<std::string> found;
        std::set<std::string> wanted;
        for (const SourceFile& file : sources()) {
            if (file.stage == stage && !file.room.empty() && file.room != "detail") found.insert(file.room);
        }
        for (const auto& [room, rule] : rooms) wanted.insert(room);
        EXPECT_EQ(found, wanted) << stage;
    }
}

TEST(Architecture, IncludesOfTheProjectStartAtItsRoot) {
    for (const SourceFile& file : sources()) {
        for (const std::string& line : file.lines) {
            EXPECT_FALSE(line.starts_with("#include \"")) << file.name << ": " << line;
        }
    }
}

TEST(Architecture, EveryFileStartsWithItsLicence) {
    for (const SourceFile& file : sources()) {
        ASSERT_FALSE(file.lines.empty()) << file.name;
        EXPECT_EQ(file.lines.front(), "// SPDX-License-Identifier: GPL-3.0-or-later") << file.name;
    }
}

TEST(Architecture, HeadersHaveNoBoolParameters) {
    const std::regex parameter(R"([(,]\s*(const )?bool \w+( = \w+)?\s*[,)])");
    for (const SourceFile& file : sources()) {
        if (!file.name.ends_with(".hpp")) continue;
        for (const std::string& line : file.lines) {
            EXPECT_FALSE(std::regex_search(line, parameter)) << file.name << ": " << line;
        }
    }
}

TEST(Architecture, FoldersHoldFewFilesSideBySide) {
    constexpr int kMostFiles = 25;
    std::map<std::string, int> counts;
    for (const char* root : {"framework", "apps/fretwork", "apps/python", "apps/studio"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kSource / root)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".hpp" || extension == ".cpp")
                ++counts[fs::relative(entry.path().parent_path(), kSource).generic_string()];
        }
    }
    for (const auto& [folder, count] : counts) EXPECT_LE(count, kMostFiles) << folder << " wants rooms";
}

TEST(Architecture, FilesStaySmall) {
    constexpr std::size_t kMostLines = 400;
    for (const SourceFile& file : sources()) {
        EXPECT_LE(file.lines.size(), kMostLines) << file.name << " holds more than one idea";
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork
