// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/search/rule_counts.hpp>

#include <algorithm>
#include <bit>
#include <numeric>
#include <string>
#include <unordered_map>

namespace fretwork::pattern::detail {
namespace {

// The largest numbers of parts and of states (a few hundred bytes each), and of groups.
constexpr std::size_t kMostParts = 300'000;
constexpr std::size_t kMostStates = 200'000;
constexpr std::size_t kMostGroups = 16;

std::optional<CountsBySize> count(const ConflictRule& rule, int edge_count, const base::Control& control) {
    std::vector<Word128> conflicts;
    Word128 edges = 0;
    for (int e = 0; e < edge_count; ++e) {
        conflicts.push_back(to_word<Word128>(rule.conflicts[e]));
        edges |= single<Word128>(e);
    }
    const IndependentSets<Word128> sets(std::move(conflicts), edges, kMostParts, control);
    if (!sets.is_counted()) return std::nullopt;
    return sets.counts();
}

/// The number of sets that meet every group, by inclusion and exclusion: all sets, less the sets that miss
/// one group, plus the sets that miss two, ..
std::optional<CountsBySize> count(const CoverRule& rule, int edge_count, const base::Control& control) {
    if (rule.groups.size() > kMostGroups) return std::nullopt;
    control.check();
    Pattern::Bits all;
    for (int e = 0; e < edge_count; ++e) all.set(e);
    // By the number of edges outside of the missed groups: the number of terms to add, less the number of
    // terms to subtract, modulo 2^128.
    CountsBySize terms(edge_count + 1);
    for (unsigned missed = 0; missed < 1u << rule.groups.size(); ++missed) {
        Pattern::Bits left = all;
        for_each_bit(Word64{missed}, [&](int group) { left &= ~rule.groups[group].edges; });
        GraphCount& term = terms[left.count()];
        term = std::popcount(missed) % 2 == 0 ? term + 1 : term - 1;
    }
    CountsBySize counts(edge_count + 1);
    for (int left = 0; left <= edge_count; ++left) {
        if (terms[left] == 0) continue;
        for (int k = 0; k <= left; ++k) counts[k] += terms[left] * binomial(left, k);
    }
    return counts;
}

/// A map from loads on the resources to the numbers of sets with these loads, which grows edge by edge. A
/// resource that no later edge loads is dropped.
class LoadTable {
  public:
    /// @param order  the order in which edges will be offered
    LoadTable(const CapacityRule& rule, const std::vector<int>& order)
        : rule_(&rule), last_edge_(rule.resources.size(), -1) {
        for (std::size_t r = 0; r < rule.resources.size(); ++r) {
            for (const int edge : order) {
                if (rule.resources[r].loads[edge] > 0) last_edge_[r] = edge;
            }
        }
        table_[Loads(rule.resources.size(), '\0')] = {1};
    }

    /// Throws Stopped.
    void offer(int edge, const base::Control& control) {
        Table next;
        for (const auto& [loads, counts] : table_) {
            control.check();
            add(next, settled(loads, edge), counts, 0);
            if (const std::optional<Loads> heavier = with_edge(loads, edge))
                add(next, settled(*heavier, edge), counts, 1);
        }
        table_ = std::move(next);
    }
    [[nodiscard]] std::size_t size() const { return table_.size(); }
    [[nodiscard]] CountsBySize total() const {
        CountsBySize sum;
        for (const auto& [loads, counts] : table_) add_shifted(sum, counts, 0);
        return sum;
    }

  private:
    using Loads = std::string;  // one byte for each resource
    using Table = std::unordered_map<Loads, CountsBySize>;

    static void add_shifted(CountsBySize& sum, const CountsBySize& counts, std::size_t shift) {
        sum.resize(std::max(sum.size(), counts.size() + shift));
        for (std::size_t k = 0; k < counts.size(); ++k) sum[k + shift] += counts[k];
    }
    static void add(Table& table, Loads loads, const CountsBySize& counts, std::size_t shift) {
        add_shifted(table[std::move(loads)], counts, shift);
    }
    [[nodiscard]] Loads settled(Loads loads, int edge) const {
        for (std::size_t r = 0; r < loads.size(); ++r) {
            if (last_edge_[r] == edge) loads[r] = '\0';
        }
        return loads;
    }
    [[nodiscard]] std::optional<Loads> with_edge(Loads loads, int edge) const {
        for (std::size_t r = 0; r < loads.size(); ++r) {
            const int load = loads[r] + rule_->resources[r].loads[edge];
            if (load > rule_->limit) return std::nullopt;
            loads[r] = static_cast<char>(load);
        }
        return loads;
    }

    const CapacityRule* rule_;
    std::vector<int> last_edge_;
    Table table_;
};

/// An order of the edges that keeps the table small: all edges that load the first resource, then the
/// remaining edges that load the second, and so on. Resources are then dropped one by one.
std::vector<int> elimination_order(const CapacityRule& rule, int edge_count) {
    const auto first_resource = [&](int edge) {
        const auto loaded = std::find_if(rule.resources.begin(), rule.resources.end(),
                                         [&](const auto& resource) { return resource.loads[edge] > 0; });
        return loaded - rule.resources.begin();
    };
    std::vector<int> order(edge_count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return first_resource(a) < first_resource(b); });
    return order;
}

std::optional<CountsBySize> count(const CapacityRule& rule, int edge_count, const base::Control& control) {
    constexpr int kMostInAByte = 100;
    if (rule.limit > kMostInAByte) return std::nullopt;
    const std::vector<int> order = elimination_order(rule, edge_count);
    LoadTable table(rule, order);
    for (const int edge : order) {
        table.offer(edge, control);
        if (table.size() > kMostStates) return std::nullopt;
    }
    return table.total();
}

std::optional<CountsBySize> count(const GraphRule&, int, const base::Control&) {
    return std::nullopt;
}

std::optional<CountsBySize> count(const PredicateRule&, int, const base::Control&) {
    return std::nullopt;
}

}  // namespace

GraphCount binomial(int n, int k) {
    if (k < 0 || k > n) return 0;
    std::vector<GraphCount> row(k + 1);
    row[0] = 1;
    for (int i = 1; i <= n; ++i) {
        for (int j = std::min(i, k); j >= 1; --j) row[j] += row[j - 1];
    }
    return row[k];
}

std::optional<CountsBySize> count_graphs_that_keep(const Rule& rule, int edge_count,
                                                   const base::Control& control) {
    auto counts = std::visit([&](const auto& form) { return count(form, edge_count, control); }, rule);
    if (counts) counts->resize(edge_count + 1);
    return counts;
}

}  // namespace fretwork::pattern::detail
