# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the report, as SVG. Equal data give equal files."""
import io
import math

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

import measures

matplotlib.rcParams.update({"svg.hashsalt": "fretwork", "svg.fonttype": "none", "font.family": "DejaVu Sans",
                            "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                            "axes.grid": True, "grid.color": "#e4e4e4", "axes.axisbelow": True})

# One colour for a kind of method; its members differ by line style. The colours can be told apart by the colour blind.
KINDS = (("#0072b2", ("ceres-multistart", "gauss-newton-multistart")),
         ("#56b4e9", ("ceres-residuals", "ceres-dogleg", "ceres-sine", "ceres-smoothed", "ceres-smoothed-dogleg",
                      "ceres-smoothed-sine")),
         ("#009e73", ("bobyqa", "subplex", "slsqp", "direct-l", "mlsl", "crs2")),
         ("#cc79a7", ("cma-es", "differential-evolution")),
         ("#d55e00", ("simulated-annealing", "annealing-clamp", "annealing-reject", "annealing-raw", "annealing-cool",
                      "corana-annealing", "annealing-then-ceres")),
         ("#777777", ("random-search",)))
STYLES = ("-", "--", ":", "-.", (0, (6, 2, 1, 2, 1, 2)), (0, (1, 3)), (0, (8, 3)))


def style_of(name):
    for colour, members in KINDS:
        if name in members:
            return {"color": colour, "linestyle": STYLES[members.index(name) % len(STYLES)],
                    "linewidth": 2.4 if colour == "#0072b2" else 1.3}
    return {"color": "black", "linestyle": "-", "linewidth": 1.3}


def svg_of(figure):
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    text = buffer.getvalue()
    return text[text.index("<svg"):]


def legend_beside(axes):
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, handlelength=3.2, fontsize=8)


def step_curve(axes, name, values, total, limit):
    finite = values[np.isfinite(values)]
    shares = np.arange(1, len(finite) + 1) / total
    x = np.concatenate([[finite[0] if len(finite) else limit], finite, [limit]])
    y = np.concatenate([[0.0], shares, [shares[-1] if len(finite) else 0.0]])
    axes.step(x, y, where="post", label=name, **style_of(name))


def data_profiles(groups):
    figure, axes = plt.subplots(figsize=(7.2, 4.6))
    limit = 1e6
    for name, by_problem in groups.items():
        values = measures.data_profile(by_problem)
        step_curve(axes, name, values, len(values), limit)
    axes.set(xscale="log", xlim=(1, limit), ylim=(0, 1.01), xlabel="stiffness factorizations, with simulated restarts",
             ylabel="share of pairs (pattern, target) that are hit")
    legend_beside(axes)
    return svg_of(figure)


def performance_profiles(groups, target):
    figure, axes = plt.subplots(figsize=(7.2, 4.6))
    limit = 1e4
    for name, ratios in measures.performance_ratios(groups, target).items():
        step_curve(axes, name, np.sort(ratios), len(ratios), limit)
    axes.set(xscale="log", xlim=(1, limit), ylim=(0, 1.01), xlabel="aRT of the method over the least aRT on the pattern",
             ylabel="share of patterns")
    legend_beside(axes)
    return svg_of(figure)


def final_gaps(groups):
    names = list(groups)
    figure, axes = plt.subplots(figsize=(7.2, 0.26 * len(names) + 1.0))
    floor = 1e-8
    for row, name in enumerate(reversed(names)):
        gaps = np.array([max(run.gap, floor) for runs in groups[name].values() for run in runs])
        colour = style_of(name)["color"]
        low, middle, high = np.quantile(gaps, [0.25, 0.5, 0.75])
        jitter = np.random.default_rng(row).uniform(-0.28, 0.28, len(gaps))
        axes.plot(gaps, row + jitter, ".", color=colour, markersize=2.0, alpha=0.35, markeredgewidth=0.0)
        axes.plot([low, high], [row, row], color=colour, linewidth=3.5, alpha=0.9, solid_capstyle="butt")
        axes.plot([middle], [row], "o", color="white", markeredgecolor=colour, markersize=5.0)
    axes.axvline(1e-3, color="black", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", xlim=(floor / 1.5, 30), ylim=(-0.7, len(names) - 0.3), yticks=range(len(names)),
             yticklabels=list(reversed(names)), xlabel="(E - best known E) / best known E at the end of a run")
    return svg_of(figure)


def runtimes(table, targets):
    """`table`: optimizer -> for each target (aRT, low, high)."""
    names = [name for name in table if any(math.isfinite(entry[0]) for entry in table[name])]
    figure, axes = plt.subplots(figsize=(7.2, 0.3 * len(names) + 1.0))
    markers = ("o", "s", "D")
    limit = 1e8
    for row, name in enumerate(reversed(names)):
        for k, (value, low, high) in enumerate(table[name]):
            if not math.isfinite(value):
                continue
            y = row + 0.22 * (1 - k)
            colour = style_of(name)["color"]
            axes.plot([low, min(high, limit)], [y, y], color=colour, linewidth=1.2)
            axes.plot([value], [y], markers[k], color=colour, markersize=4.2,
                      label=f"within {100 * targets[k]:g} %" if row == len(names) - 1 else None)
    axes.set(xscale="log", xlim=(10, limit), ylim=(-0.7, len(names) - 0.3), yticks=range(len(names)),
             yticklabels=list(reversed(names)),
             xlabel="aRT in stiffness factorizations, with 95 % bootstrap intervals; cut where it reaches infinity")
    axes.legend(loc="lower right", frameon=True, fontsize=8)
    return svg_of(figure)


def convergence(groups, names):
    figure, axes = plt.subplots(figsize=(7.2, 4.2))
    costs = np.unique(np.round(np.logspace(0, math.log10(30000), 160)).astype(int))
    for name in names:
        if name not in groups:
            continue
        rows = []
        for runs in groups[name].values():
            for run in runs:
                steps = np.searchsorted([cost for cost, _ in run.gaps], costs, side="right")
                rows.append([run.gaps[step - 1][1] if step else math.inf for step in steps])
        axes.plot(costs, np.maximum(np.median(rows, axis=0), 1e-8), label=name, **style_of(name))
    axes.axhline(1e-3, color="black", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", yscale="log", ylim=(1e-6, 1e3), xlabel="stiffness factorizations of one run",
             ylabel="median of (E - best known E) / best known E")
    legend_beside(axes)
    return svg_of(figure)
