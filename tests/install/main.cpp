#include <fretwork/reduction/response.hpp>

#include <cstdio>

int main() {
    using namespace fretwork;
    const auto layout = pattern::find_node_layout("paper7");
    const auto pattern = pattern::parse_pattern_id(layout, "0-1+1-5+1-6+5-6");
    for (const auto& response : reduction::compute_responses(layout, pattern, reduction::paper_setting())) {
        const auto& last = response.samples.back();
        const double largest = last.displacements.leftCols<3>().rowwise().norm().maxCoeff();
        std::printf("%-8s %5.2f N moves the tile's rim by %5.2f mm\n", response.scenario.c_str(),
                    last.magnitude, 1e3 * largest);
    }
}
