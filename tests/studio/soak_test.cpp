// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of a server that is edited for long. FRETWORK_SOAK_EDITS=200000 makes it an hour.
#include "running_studio.hpp"

#include <fretwork/simulation/load_cases/load_case_file.hpp>

#include <cstdlib>
#include <fstream>
#include <random>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using test::Client;

std::size_t resident_bytes() {
    std::size_t whole = 0;
    std::size_t resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

int wanted_edits() {
    const char* wanted = std::getenv("FRETWORK_SOAK_EDITS");
    return wanted != nullptr ? std::atoi(wanted) : 2000;
}

/// Actions of people, in random order.
class RandomEdits {
  public:
    RandomEdits(Client& client, std::size_t tiles) : client_(client), tiles_(tiles) {}

    void make_one() {
        switch (random_() % 8) {
            case 0:
            case 1:
                return ask("paint", {{"tiles", {random_() % tiles_}},
                                     {"pattern", kPatterns[random_() % kPatterns.size()]}});
            case 2:
                return ask("turn", {{"tiles", {random_() % tiles_}}, {"by", 1 + random_() % 5}});
            case 3:
                return ask("undo", Json::object());
            case 4:
                return ask("set_model", {{"model", random_() % 2 == 0 ? "condensed" : "corotational"}});
            case 5:
                return ask("show", {{"fields", random_() % 2 == 0 ? Json::array() : Json{"stress", "N"}}});
            default:
                return drag();
        }
    }

  private:
    void drag() {
        const double force = -0.001 * static_cast<double>(1 + random_() % 20);
        ask("set_load_case",
            {{"index", 0},
             {"load_case", Json::parse(simulation::load_case_text(test::cantilever({0, 0, force})))},
             {"merge", "drag " + std::to_string(random_() % 50)}});
    }
    void ask(const std::string& name, const Json& more) {
        (void)client_.ask(name, more);
        client_.forget();
    }

    static inline const std::vector<std::string> kPatterns = {"0-6", "0-5+5-6", "0-1+1-6", "0-1+1-3+1-6"};
    Client& client_;
    std::size_t tiles_;
    std::mt19937 random_{1};
};

TEST(StudioMemory, DoesNotGrowWithTheNumberOfEdits) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer keeps what is freed";
#endif
    const simulation::Project project = test::studio_project(12, 8);
    const test::RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    RandomEdits edits(client, project.tessellation.tiles.size());
    const int count = wanted_edits();
    // The first half fills what is bounded: undo, caches, the allocator's own.
    for (int i = 0; i < count / 2; ++i) edits.make_one();
    const std::size_t middle = resident_bytes();
    for (int i = 0; i < count / 2; ++i) edits.make_one();
    const std::size_t end = resident_bytes();
    // The allocator keeps a few MB here or there, and 1000 steps of undo have 2 MB. A solution has 50 kB: one
    // that were left over by each edit would be 50 MB in the shortest run.
    EXPECT_LT(end, middle + (std::size_t{16} << 20U));
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio
