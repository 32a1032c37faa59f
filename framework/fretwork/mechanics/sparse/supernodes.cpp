// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/supernodes.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

/// The blocks of equations. The equations of one node form a block, because they have the same neighbours.
struct Blocks {
    std::vector<int> first;     ///< first equation of each block, followed by the number of equations
    std::vector<int> block_of;  ///< block of each equation
    [[nodiscard]] int count() const { return static_cast<int>(first.size()) - 1; }
    [[nodiscard]] int size(int block) const { return first[at(block) + 1] - first[at(block)]; }
};

Blocks blocks_of(const SystemLayout& layout) {
    Blocks blocks;
    blocks.block_of.resize(at(layout.equations()));
    for (int i = 0; i < layout.equations(); ++i) {
        if (i == 0 || layout.node_of(i) != layout.node_of(i - 1)) blocks.first.push_back(i);
        blocks.block_of[at(i)] = static_cast<int>(blocks.first.size()) - 1;
    }
    blocks.first.push_back(layout.equations());
    return blocks;
}

/// For each block, the blocks below its diagonal in the factor.
struct BlockFactor {
    std::vector<std::size_t> start;  ///< start of each block's rows in `row`; blocks + 1 entries
    std::vector<int> row;            ///< blocks below the diagonal, not sorted
    std::vector<int> parent;         ///< first block below the diagonal; -1: none
    [[nodiscard]] std::size_t count(int block) const { return start[at(block) + 1] - start[at(block)]; }
};

/// Symbolic elimination. A column of the factor has the rows of the matrix's column and of its children in
/// the elimination tree.
class BlockElimination {
  public:
    BlockElimination(const SystemLayout& layout, const Blocks& blocks)
        : layout_(layout),
          blocks_(blocks),
          marked_(at(blocks.count()), -1),
          first_child_(marked_),
          sibling_(marked_) {}

    BlockFactor run(const base::Control& control) {
        factor_.start.push_back(0);
        for (int block = 0; block < blocks_.count(); ++block) {
            control.check();
            marked_[at(block)] = block;
            add_matrix_rows(block);
            for (int child = first_child_[at(block)]; child >= 0; child = sibling_[at(child)])
                add_child_rows(block, child);
            const auto begin = factor_.row.begin() + static_cast<std::ptrdiff_t>(factor_.start.back());
            const int parent = begin == factor_.row.end() ? -1 : *std::min_element(begin, factor_.row.end());
            factor_.parent.push_back(parent);
            if (parent >= 0) sibling_[at(block)] = std::exchange(first_child_[at(parent)], block);
            factor_.start.push_back(factor_.row.size());
        }
        return std::move(factor_);
    }

  private:
    void add(int block, int row) {
        if (std::exchange(marked_[at(row)], block) != block) factor_.row.push_back(row);
    }

    void add_matrix_rows(int block) {
        const int column = blocks_.first[at(block)];
        const int begin = layout_.column_start()[at(column)];
        const int end = layout_.column_start()[at(column) + 1];
        for (int k = begin; k < end; ++k) add(block, blocks_.block_of[at(layout_.row()[at(k)])]);
    }

    void add_child_rows(int block, int child) {
        for (std::size_t k = factor_.start[at(child)]; k < factor_.start[at(child) + 1]; ++k)
            add(block, factor_.row[k]);
    }

    const SystemLayout& layout_;
    const Blocks& blocks_;
    BlockFactor factor_;
    std::vector<int> marked_;
    std::vector<int> first_child_, sibling_;
};

/// The blocks [first, last], with the rows of the last block.
struct Group {
    int first, last;
    long width, rows;  ///< numbers of equations
    long zeros;        ///< number of zeros that merging has added to the panel
};

/// True if a child should be merged with its parent. The fewer columns the merged group has, the more zeros
/// are accepted.
bool worth_merging(const Group& merged) {
    constexpr long kNarrow = 24;
    constexpr long kMiddling = 48;
    const auto entries = 0.5 * static_cast<double>(merged.width * (merged.width + 1 + 2 * merged.rows));
    const double share = static_cast<double>(merged.zeros) / entries;
    if (merged.width <= kNarrow) return share < 0.2;
    return share < (merged.width <= kMiddling ? 0.10 : 0.05);
}

class Grouping {
  public:
    Grouping(const Blocks& blocks, const BlockFactor& factor) : blocks_(blocks), factor_(factor) {}

    std::vector<Group> run() {
        for (int block = 0; block < blocks_.count(); ++block) {
            if (continues_last(block)) {
                Group& group = groups_.back();
                group.last = block;
                group.width += blocks_.size(block);
                group.rows -= blocks_.size(block);
                continue;
            }
            merge_finished();
            groups_.push_back({block, block, blocks_.size(block), rows_below(block), 0});
        }
        merge_finished();
        return std::move(groups_);
    }

  private:
    [[nodiscard]] long rows_below(int block) const {
        long rows = 0;
        for (std::size_t k = factor_.start[at(block)]; k < factor_.start[at(block) + 1]; ++k)
            rows += blocks_.size(factor_.row[k]);
        return rows;
    }

    [[nodiscard]] bool continues_last(int block) const {
        return block > 0 && factor_.parent[at(block) - 1] == block &&
               factor_.count(block - 1) == factor_.count(block) + 1;
    }

    /// Merge the last group, which is complete, with the children directly before it.
    void merge_finished() {
        while (groups_.size() > 1) {
            const Group& child = groups_[groups_.size() - 2];
            const Group& parent = groups_.back();
            const int above = factor_.parent[at(child.last)];
            if (above < parent.first || above > parent.last) return;
            const long more = child.width * (parent.width + parent.rows - child.rows);
            const Group merged{child.first, parent.last, child.width + parent.width, parent.rows,
                               child.zeros + parent.zeros + more};
            if (!worth_merging(merged)) return;
            groups_.pop_back();
            groups_.back() = merged;
        }
    }

    const Blocks& blocks_;
    const BlockFactor& factor_;
    std::vector<Group> groups_;
};

void add_rows(const Blocks& blocks, const BlockFactor& factor, int block, SupernodeTree& tree) {
    std::vector<int> below(factor.row.begin() + static_cast<std::ptrdiff_t>(factor.start[at(block)]),
                           factor.row.begin() + static_cast<std::ptrdiff_t>(factor.start[at(block) + 1]));
    std::sort(below.begin(), below.end());
    for (const int row : below) {
        for (int equation = blocks.first[at(row)]; equation < blocks.first[at(row) + 1]; ++equation)
            tree.row.push_back(equation);
    }
}

void link(SupernodeTree& tree, int equations) {
    std::vector<int> supernode_of(at(equations));
    for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
        for (int i = 0; i < tree.supernodes[s].width; ++i)
            supernode_of[at(tree.supernodes[s].first + i)] = static_cast<int>(s);
    }
    tree.child_start.assign(tree.supernodes.size() + 1, 0);
    for (Supernode& supernode : tree.supernodes) {
        if (supernode.rows == 0) continue;
        supernode.parent = supernode_of[at(tree.row[supernode.row_start])];
        ++tree.child_start[at(supernode.parent) + 1];
    }
    for (std::size_t s = 0; s < tree.supernodes.size(); ++s) tree.child_start[s + 1] += tree.child_start[s];
    tree.child.resize(at(tree.child_start.back()));
    std::vector<int> next(tree.child_start.begin(), tree.child_start.end() - 1);
    for (std::size_t s = 0; s < tree.supernodes.size(); ++s) {
        const int parent = tree.supernodes[s].parent;
        if (parent >= 0) tree.child[at(next[at(parent)]++)] = static_cast<int>(s);
    }
}

void place_panels(SupernodeTree& tree) {
    for (Supernode& supernode : tree.supernodes) {
        supernode.panel_start = tree.factor_size;
        tree.factor_size += at(supernode.height()) * at(supernode.width);
    }
}

/// Find the place of each supernode's rows in its parent's front; both lists are ascending.
void place_in_parents(SupernodeTree& tree) {
    tree.place.resize(tree.row.size());
    for (const Supernode& child : tree.supernodes) {
        if (child.parent < 0) continue;
        const Supernode& parent = tree.supernodes[at(child.parent)];
        const int* rows = tree.row.data() + parent.row_start;
        int below = 0;
        for (std::size_t k = child.row_start; k < child.row_start + at(child.rows); ++k) {
            const int own = tree.row[k] - parent.first;
            if (own < parent.width) {
                tree.place[k] = own;
                continue;
            }
            while (rows[below] != tree.row[k]) ++below;
            tree.place[k] = parent.width + below;
        }
    }
}

void join_runs(SupernodeTree& tree) {
    tree.run_start.push_back(0);
    for (const Supernode& child : tree.supernodes) {
        const int* place = tree.place.data() + child.row_start;
        const int width = child.parent < 0 ? 0 : tree.supernodes[at(child.parent)].width;
        for (int i = 0; child.parent >= 0 && i < child.rows; ++i) {
            const bool continues = i > 0 && place[i] == place[i - 1] + 1 && place[i] != width;
            if (continues) {
                ++tree.run.back().length;
            } else {
                tree.run.push_back({i, place[i], 1});
            }
        }
        tree.run_start.push_back(tree.run.size());
    }
}

}  // namespace

SupernodeTree supernode_tree(const SystemLayout& layout, const base::Control& control) {
    const Blocks blocks = blocks_of(layout);
    const BlockFactor factor = BlockElimination(layout, blocks).run(control);
    SupernodeTree tree;
    for (const Group& group : Grouping(blocks, factor).run()) {
        control.check();
        tree.supernodes.push_back({.first = blocks.first[at(group.first)],
                                   .width = static_cast<int>(group.width),
                                   .rows = static_cast<int>(group.rows),
                                   .row_start = tree.row.size()});
        add_rows(blocks, factor, group.last, tree);
    }
    link(tree, layout.equations());
    place_panels(tree);
    place_in_parents(tree);
    join_runs(tree);
    return tree;
}

}  // namespace fretwork::mechanics::sparse
