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

WIDTH = 6.9  # inches: as wide as a journal's page (177 mm), so that sizes of text are those in print
SMALL = 6.5  # points: journals ask for 6
MOST_POINTS = 150  # of one method in a figure
CONVERGENCE_FLOOR = 0.8e-3  # just below the last target: beyond it traces are thinned to their ends
OURS = ("ceres-multistart", "gauss-newton-multistart")  # the default of `calibrate` first
ANNEALING = ("simulated-annealing", "annealing-clamp", "annealing-reject", "annealing-raw", "annealing-cool",
             "corana-annealing", "annealing-then-ceres")
# One colour for a kind of method; its members differ by line style. The colours can be told apart by the colour blind.
KINDS = (("this project's calibrators", "#0072b2", OURS),
         ("Ceres on the residuals", "#2a8fc4", ("ceres-residuals", "ceres-dogleg", "ceres-sine", "ceres-smoothed",
                                                "ceres-smoothed-dogleg", "ceres-smoothed-sine", "ceres-subspace-dogleg",
                                                "ceres-smoothed-subspace-dogleg")),
         ("NLopt, local", "#009e73", ("bobyqa", "subplex", "slsqp")),
         ("NLopt, global", "#8a7a00", ("direct-l", "mlsl", "crs2")),
         ("annealing", "#d55e00", ANNEALING),
         ("evolution, and the floor", "#b0578d", ("cma-es", "differential-evolution", "random-search")))
ORDER = [name for _, _, members in KINDS for name in members]
STYLES = ("-", "--", ":", "-.", (0, (6, 2, 1, 2, 1, 2)), (0, (1, 3)), (0, (8, 3)), (0, (3, 1, 1, 1)))


def style_of(name):
    for _, colour, members in KINDS:
        if name in members:
            return {"color": colour, "linestyle": STYLES[members.index(name) % len(STYLES)], "linewidth": 1.6}
    return {"color": "black", "linestyle": "-", "linewidth": 1.3}


def svg_of(figure):
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    text = buffer.getvalue()
    return text[text.index("<svg"):].replace("<svg ", '<svg data-print-width="177mm" ', 1)


def legend_beside(axes):
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, handlelength=3.2, fontsize=8)


def step_curve(axes, values, limit, **style):
    """The ECDF of the values; infinite ones never come."""
    finite = values[np.isfinite(values)]
    if len(finite):
        # Thousands of jumps would make the file large and the picture no finer.
        x = np.unique(np.concatenate([np.geomspace(finite[0], limit, 140), finite if len(finite) < 140 else []]))
        axes.step(x, np.searchsorted(finite, x, side="right") / len(values), where="post", **style)
    else:
        axes.plot([1, limit], [0.0, 0.0], **style)


def profile_panels(curves, limit, labels):
    """One panel for each kind of method; the others stand behind in grey. `curves`: name -> sorted values."""
    figure, grid = plt.subplots(2, 3, figsize=(WIDTH, 7.6), sharex=True, sharey=True)
    for axes, (kind, _, members) in zip(grid.flat, KINDS):
        for name, values in curves.items():
            if name not in members:
                step_curve(axes, values, limit, color="#d0d0d0", linewidth=0.7)
        for name in members:
            if name in curves:
                step_curve(axes, curves[name], limit, label=name, **style_of(name))
        axes.set(xscale="log", xlim=(1, limit), ylim=(-0.01, 1.02))
        axes.set_title(kind, loc="left", fontsize=9)
        if set(members) & set(curves):
            axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), fontsize=SMALL, frameon=False, handlelength=3.2)
    figure.supxlabel(labels[0], fontsize=9)
    figure.supylabel(labels[1], fontsize=9)
    figure.tight_layout()
    return svg_of(figure)


def data_profiles(profiles, milliseconds=None):
    """Against cost, or against CPU time if the milliseconds that a unit of cost takes each method are given.

    `profiles`: name -> what `measures.data_profile` returns.
    """
    per_unit = milliseconds or dict.fromkeys(profiles, 1.0)
    what = "CPU time of one thread, ms" if milliseconds else "stiffness factorizations"
    curves = {name: per_unit[name] * profile for name, profile in profiles.items()}
    return profile_panels(curves, 1e5 if milliseconds else 1e6,
                          (f"{what}, with simulated restarts", "share of pairs (pattern, target) that are hit"))


def performance_profiles(groups, target):
    curves = {name: np.sort(ratios) for name, ratios in measures.performance_ratios(groups, target).items()}
    return profile_panels(curves, 1e4, ("aRT of the method over the least aRT on the pattern", "share of patterns"))


def final_gaps(groups):
    names = list(groups)
    figure, axes = plt.subplots(figsize=(WIDTH, 0.26 * len(names) + 1.0))
    floor, ceiling = 1e-8, 30.0
    for row, name in enumerate(reversed(names)):
        gaps = np.array([min(max(run.gap, floor), ceiling) for runs in groups[name].values() for run in runs])
        colour = style_of(name)["color"]
        low, middle, high = np.quantile(gaps, [0.25, 0.5, 0.75])
        ranks = np.unique(np.linspace(0, len(gaps) - 1, min(len(gaps), MOST_POINTS)).round().astype(int))
        shown = np.sort(gaps)[ranks]  # the file stays small
        jitter = np.random.default_rng(row).uniform(-0.28, 0.28, len(shown))
        axes.plot(shown, row + jitter, ".", color=colour, markersize=3.5, alpha=0.45, markeredgewidth=0.0)
        axes.plot([low, high], [row, row], color=colour, linewidth=3.5, alpha=0.9, solid_capstyle="butt")
        axes.plot([middle], [row], "o", color="white", markeredgecolor=colour, markersize=5.0)
    axes.axvline(1e-3, color="black", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", xlim=(floor / 1.5, 1.5 * ceiling), ylim=(-0.7, len(names) - 0.3), yticks=range(len(names)),
             yticklabels=list(reversed(names)), xlabel="(E - best known E) / best known E at the end of a run; dashed: 0.1 %")
    return svg_of(figure)


def runtimes(table, targets):
    """`table`: optimizer -> for each target (aRT, low, high)."""
    names = [name for name in table if any(math.isfinite(entry[0]) for entry in table[name])]
    figure, axes = plt.subplots(figsize=(WIDTH, 0.3 * len(names) + 1.0))
    markers = ("o", "s", "D")
    limit = 1e8
    for row, name in enumerate(reversed(names)):
        for k, (value, low, high) in enumerate(table[name]):
            if not math.isfinite(value):
                continue
            y = row + 0.22 * (1 - k)
            colour = style_of(name)["color"]
            axes.plot([low, min(high, limit)], [y, y], color=colour, linewidth=1.2)
            axes.plot([value], [y], markers[k], color=colour, markersize=4.2)
    axes.set(xscale="log", xlim=(10, limit), ylim=(-0.7, len(names) - 0.3), yticks=range(len(names)),
             yticklabels=list(reversed(names)),
             xlabel="aRT in stiffness factorizations, with 95 % bootstrap intervals; cut where it reaches infinity")
    for marker, target in zip(markers, targets):
        axes.plot([], [], marker, color="#444444", markersize=4.2, label=f"within {100 * target:g} %")
    axes.legend(loc="lower right", frameon=True, fontsize=8)
    return svg_of(figure)


def convergence(groups, names):
    figure, axes = plt.subplots(figsize=(WIDTH, 4.2))
    costs = np.unique(np.round(np.logspace(0, math.log10(40000), 160)).astype(int))
    for name in names:
        if name not in groups:
            continue
        rows = []
        for runs in groups[name].values():
            for run in runs:
                steps = np.searchsorted([cost for cost, _ in run.gaps], costs, side="right")
                rows.append([run.gaps[step - 1][1] if step else math.inf for step in steps])
        middle = np.maximum(np.median(rows, axis=0), CONVERGENCE_FLOOR)
        axes.plot(costs, middle, label=name, **style_of(name))
    axes.axhline(1e-3, color="black", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", yscale="log", ylim=(CONVERGENCE_FLOOR, 1e3), xlabel="stiffness factorizations of one run",
             ylabel="median of (E - best known E) / best known E")
    legend_beside(axes)
    return svg_of(figure)
