// SPDX-License-Identifier: GPL-3.0-or-later
// The same counts from a formulation that shares no code with the search: an answer set program over the
// whole fan, solved by clingo, with geometry in plain doubles.
#include "pattern/small_layouts.hpp"
#include "support.hpp"

#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/search/wide_random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

namespace fretwork::pattern {
namespace THIS_TEST {

using Point = std::complex<double>;

constexpr int kSides = 6;
constexpr double kTolerance = 1e-9;
constexpr int kGrid = 24;  // of random layouts

/// A copy of a candidate edge in the fan of a unit hexagon; nodes of the fan have the names of their places.
struct Beam {
    std::size_t edge;
    int sector;
    std::array<Point, 2> ends;
};

double cross(const Point& a, const Point& b) {
    return a.real() * b.imag() - a.imag() * b.real();
}

std::vector<Beam> beams_of(const NodeLayout& layout) {
    std::vector<Beam> beams;
    for (int t = 0; t < kSides; ++t) {
        const auto place = [&](LayoutNodeIndex node) {
            const auto& b = layout.nodes()[node].place;
            return b[1].to_double() * std::polar(1.0, t * std::numbers::pi / 3) +
                   b[2].to_double() * std::polar(1.0, (t + 1) * std::numbers::pi / 3);
        };
        for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
            const Edge& edge = layout.candidate_edges()[e];
            beams.push_back({e, t, {place(edge.first), place(edge.second)}});
        }
    }
    return beams;
}

std::string name_of(const Point& point) {
    const auto digits = [](double x) {
        const long scaled = std::lround(x * 1e6);
        return (scaled < 0 ? "m" : "p") + std::to_string(std::labs(scaled));
    };
    return digits(point.real()) + digits(point.imag());
}

bool same(const Point& a, const Point& b) {
    return std::abs(a - b) < kTolerance;
}

bool cross_inside(const Beam& left, const Beam& right) {
    const auto side = [](const Beam& beam, const Point& point) {
        return cross(beam.ends[1] - beam.ends[0], point - beam.ends[0]);
    };
    const double a = side(left, right.ends[0]) * side(left, right.ends[1]);
    const double b = side(right, left.ends[0]) * side(right, left.ends[1]);
    return a < -kTolerance && b < -kTolerance;
}

bool enclose_less_than_15_degrees(const Beam& left, const Beam& right) {
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            if (!same(left.ends[i], right.ends[j])) continue;
            const double angle =
                std::abs(std::arg((left.ends[1 - i] - left.ends[i]) / (right.ends[1 - j] - right.ends[j])));
            if (angle < std::numbers::pi / 12 && angle > kTolerance) return true;
        }
    }
    return false;
}

void write_facts(const NodeLayout& layout, std::ostream& out) {
    const std::vector<Beam> beams = beams_of(layout);
    for (const Beam& beam : beams)
        out << "beam(" << beam.edge << "," << name_of(beam.ends[0]) << "," << name_of(beam.ends[1]) << ").\n";
    for (const Beam& left : beams) {
        for (const Beam& right : beams) {
            if (left.sector == 0 && (cross_inside(left, right) || enclose_less_than_15_degrees(left, right)))
                out << "conflict(" << left.edge << "," << right.edge << ").\n";
        }
    }
    const double inradius = std::sqrt(3.0) / 2;
    for (const Beam& beam : beams) {
        for (const Point& end : beam.ends) {
            const double along = std::arg(end) * 3 / std::numbers::pi;
            const double middle = (std::floor(along) + 0.5) * std::numbers::pi / 3;
            const bool is_outside = (end * std::polar(1.0, -middle)).real() > inradius - kTolerance;
            out << "weight(" << name_of(end) << "," << (is_outside ? 2 : 1) << ").\n";
            if (is_outside) out << "interface(" << name_of(end) << ").\n";
        }
    }
}

constexpr const char* kRules = R"(
edge(E) :- beam(E,_,_).
{ chosen(E) } :- edge(E).
:- conflict(E,F), chosen(E), chosen(F).
joined(U,V,E) :- beam(E,U,V), chosen(E).
joined(V,U,E) :- beam(E,U,V), chosen(E).
joined(U,V) :- joined(U,V,_).
used(U) :- joined(U,_).
:- weight(U,W), #sum { W,V,E : joined(U,V,E) } > 6.
:- interface(U), not used(U).
start(U) :- U = #min { V : interface(V) }.
reached(U) :- start(U).
reached(V) :- reached(U), joined(U,V).
:- used(V), not reached(V).
node(U) :- weight(U,_).
without(X,U) :- node(X), interface(U), U != X.
without(X,V) :- without(X,U), joined(U,V), V != X.
:- used(X), used(V), V != X, not without(X,V).
#show chosen/1.
)";

/// The number of answer sets for each number of edges.
std::vector<std::uint64_t> count_by_clingo(const NodeLayout& layout) {
    std::ostringstream program;
    write_facts(layout, program);
    program << kRules;
    const test::TemporaryFolder folder;
    const auto path = folder.file("oracle.lp", program.str());
    const std::string command = "clingo 0 --verbose=0 " + path.string() + " 2>/dev/null";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
        text.append(buffer.data(), got);
    std::vector<std::uint64_t> counts(layout.candidate_edges().size() + 1);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::size_t edges = 0;
        for (auto at = line.find("chosen("); at != std::string::npos; at = line.find("chosen(", at + 1))
            ++edges;
        if (edges > 0) ++counts[edges];
    }
    return counts;
}

/// Shares of a grid of 24, each once.
std::set<int> some_shares(detail::WideRandom& random, int count) {
    std::set<int> shares;
    for (int i = 0; i < count; ++i) shares.insert(1 + static_cast<int>(random.below(kGrid - 1)));
    return shares;
}

std::vector<std::array<Rational, 3>> some_face_nodes(detail::WideRandom& random, int count) {
    std::set<std::pair<int, int>> places;
    for (int i = 0; i < count; ++i) {
        const int first = 1 + static_cast<int>(random.below(kGrid - 2));
        places.emplace(first, 1 + static_cast<int>(random.below(static_cast<GraphCount>(kGrid - 1 - first))));
    }
    std::vector<std::array<Rational, 3>> nodes;
    for (const auto& [a, b] : places)
        nodes.push_back({Rational(a, kGrid), Rational(b, kGrid), Rational(kGrid - a - b, kGrid)});
    return nodes;
}

/// One to three nodes, symmetric about the middle.
std::vector<Rational> some_interface(detail::WideRandom& random) {
    const auto count = 1 + random.below(3);
    const int share = 1 + static_cast<int>(random.below(kGrid / 2 - 1));
    if (count == 1) return {Rational(1, 2)};
    if (count == 2) return {Rational(share, kGrid), Rational(kGrid - share, kGrid)};
    return {Rational(share, kGrid), Rational(1, 2), Rational(kGrid - share, kGrid)};
}

/// A layout of 5 to 18 candidate edges with nodes at random places.
NodeLayout random_layout(std::uint64_t seed) {
    for (std::uint64_t attempt = 0;; ++attempt) {
        detail::WideRandom random(seed, attempt);
        NodeLayoutDescription description;
        description.name = "random" + std::to_string(seed);
        description.center = random.below(2) == 0;
        for (const int share : some_shares(random, static_cast<int>(random.below(3))))
            description.radial.emplace_back(share, kGrid);
        description.face = some_face_nodes(random, static_cast<int>(random.below(3)));
        description.interface = some_interface(random);
        if (!description.center && description.radial.empty() && description.face.empty()) continue;
        NodeLayout layout(description);
        if (layout.candidate_edges().size() > 4 && layout.candidate_edges().size() <= 18) return layout;
    }
}

void expect_equal_counts(const NodeLayout& layout) {
    EnumerationOptions options;
    options.edges = {1, kMaxCandidateEdges};
    EXPECT_EQ(count_patterns(layout, options).by_edges, count_by_clingo(layout)) << layout.name();
}

bool has_clingo() {
    return std::system("clingo --version >/dev/null 2>&1") == 0;
}

TEST(Oracle, AnswerSetProgramCountsTheSamePatterns) {
    if (!has_clingo()) GTEST_SKIP() << "clingo (package gringo) is not installed";
    for (const NodeLayout& layout : small_layouts()) expect_equal_counts(layout);
}

TEST(Oracle, AnswerSetProgramCountsTheSamePatternsOfRandomLayouts) {
    if (!has_clingo()) GTEST_SKIP() << "clingo (package gringo) is not installed";
    for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_equal_counts(random_layout(seed));
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
