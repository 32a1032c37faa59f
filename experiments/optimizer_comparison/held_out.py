#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Choose the held-out problems: 60 patterns of paper8 on which nothing was or is tuned.

Usage: held_out.py PATTERNS.txt > held_out.txt     PATTERNS: fretwork enumerate --layout paper8 --require n5 n6 --list PATTERNS.txt

paper8 is paper7 and the mirror twin of its face node; they are its nodes 5 and 6. A pattern that uses both is none of
paper7's, nor the mirror image of one. Of all these, the 60 whose names "paper8:ID" have the least SHA-256 hashes.
"""
import hashlib
import pathlib
import sys

COUNT = 60


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    names = [f"paper8:{line}" for line in pathlib.Path(sys.argv[1]).read_text().split()]
    names.sort(key=lambda name: hashlib.sha256(name.encode()).hexdigest())
    print("".join(f"calibration/{name}\n" for name in names[:COUNT]), end="")


if __name__ == "__main__":
    main()
