# SPDX-License-Identifier: GPL-3.0-or-later
"""Random calls with nearly right arguments end by an answer or by an exception in words, never by a crash.

FRETWORK_RANDOM_CALLS=20000 makes more of them, FRETWORK_RANDOM_SEED=7 others.
"""

import os
import pathlib
import subprocess
import sys
import unittest

CALLS = int(os.environ.get("FRETWORK_RANDOM_CALLS", "1500"))
SEED = int(os.environ.get("FRETWORK_RANDOM_SEED", "1"))
HERE = pathlib.Path(__file__).resolve().parent


class RandomCalls(unittest.TestCase):
    def test_end_by_an_answer_or_by_words(self):
        for seed in (SEED, SEED + 1):
            with self.subTest(seed=seed):
                done = subprocess.run([sys.executable, "-B", str(HERE / "random_calls.py"), str(seed), str(CALLS)], capture_output=True, text=True)
                last = "\n".join(done.stderr.splitlines()[-60:])  # the call, and what a sanitizer says of it
                self.assertEqual(done.returncode, 0, f"ended by {done.returncode}: {done.stdout}\n{last}")
                known, answered, raised = map(int, done.stdout.split()[-3:])
                self.assertGreater(known, 500, "the stubs name all that can be called")
                self.assertGreater(answered, CALLS // 8, "else the values say little")
                self.assertGreater(raised, CALLS // 8)


if __name__ == "__main__":
    unittest.main()
