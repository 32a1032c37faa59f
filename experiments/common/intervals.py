# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals of 95 %: exact ones of shares, and of statistics by resampling."""
import math
import random

LEVEL = 0.95


def binomial_tail(hits, count, share):
    """The probability of at least `hits` hits in `count` trials."""
    if hits <= 0:
        return 1.0
    if share <= 0.0 or share >= 1.0:
        return float(share >= 1.0)
    logarithms = (math.lgamma(count + 1) - math.lgamma(k + 1) - math.lgamma(count - k + 1) + k * math.log(share) + (count - k) * math.log1p(-share)
                  for k in range(hits, count + 1))
    return math.fsum(math.exp(value) for value in logarithms)


def root(function):
    """Where an increasing function on [0, 1] becomes positive."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2.0
        low, high = (low, middle) if function(middle) > 0.0 else (middle, high)
    return (low + high) / 2.0


def exact_interval(hits, count):
    """Clopper and Pearson's interval of a share: never too narrow, also where all trials hit or none."""
    tail = (1.0 - LEVEL) / 2.0
    lower = 0.0 if hits == 0 else root(lambda share: binomial_tail(hits, count, share) - tail)
    upper = 1.0 if hits == count else root(lambda share: tail - (1.0 - binomial_tail(hits + 1, count, share)))
    return lower, upper


def resampled_interval(items, statistic, draws=2000, seed=1):
    """The middle 95 % of the statistic over resampled items."""
    generator = random.Random(seed)
    found = sorted(statistic(generator.choices(items, k=len(items))) for _ in range(draws))
    tail = (1.0 - LEVEL) / 2.0
    return found[round(tail * (draws - 1))], found[round((1.0 - tail) * (draws - 1))]
