# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts on logarithmic axes, as the parts of an SVG."""
import math

ROUNDING = 1e-9


class Axis:
    """A logarithmic axis from `low` to `high`, drawn from `first` to `last`, with ticks at these multiples of powers of ten."""

    def __init__(self, low, high, first, last, multiples=(1,)):
        self.low, self.high, self.first, self.last, self.multiples = low, high, first, last, multiples

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.first + share * (self.last - self.first)

    def ticks(self):
        powers = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        ticks = [multiple * 10.0**power for power in powers for multiple in self.multiples]
        return [tick for tick in ticks if self.low * (1 - ROUNDING) <= tick <= self.high * (1 + ROUNDING)]


def decades(values, first, last):
    """An axis of whole decades around positive values."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return Axis(10.0**low, 10.0**high, first, last)


def percent(tick):
    return f"{100 * tick:g} %"


def text(x, y, content, anchor="middle", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {extra}>{content}</text>'


def grid(across, up, titles, colour):
    """Lines and labels of both axes. `titles`: for each axis its name, and how its ticks are written."""
    (across_name, across_label), (up_name, up_label) = titles
    parts = []
    for tick in across.ticks():
        parts.append(f'<path d="M{across(tick):.1f} {up.first}V{up.last}" stroke="{colour}"/>')
        parts.append(text(across(tick), up.first + 18, across_label(tick)))
    for tick in up.ticks():
        parts.append(f'<path d="M{across.first} {up(tick):.1f}H{across.last}" stroke="{colour}"/>')
        parts.append(text(across.first - 6, up(tick) + 4, up_label(tick), "end"))
    middle = (up.first + up.last) / 2
    parts.append(text((across.first + across.last) / 2, up.first + 42, across_name))
    parts.append(text(18, middle, up_name, extra=f'transform="rotate(-90 18 {middle})"'))
    return parts
