# SPDX-License-Identifier: GPL-3.0-or-later
"""Random calls of all that the module has: random_calls.py SEED CALLS. test_calls.py runs it.

Most arguments are of the type that the stubs name, so that calls get far; some are not. It prints what no call may do, and
at its end how many calls there are to choose from, how many were answered, and how many raised. The line on standard error
before a crash is the call.
"""

import copy
import gc
import os
import pathlib
import pickle
import random
import re
import reprlib
import resource
import signal
import sys
import tempfile

import numpy as np

import fretwork as fw

import call_signatures
import call_values

SECONDS = 1.0  # of processor time; longer calls are interrupted, as by Ctrl-C
MOST_MEMORY = 6 << 30  # bytes; what is larger is a MemoryError
# Exceptions that C++'s own library throws and no binding has put into words.
RAW = re.compile(r"std::|vector::|basic_string|deque::|array::|bitset::|map::at|\bsto[id]\b|stod|bad_|_M_|regex_error|numpy\.core|Unable to (cast|convert)")


class Enough(Exception):
    pass


def interrupt(*_):
    raise Enough


def is_fault(error):
    """Whether an exception says nothing to who called, or not in one line."""
    text = str(error)
    if isinstance(error, (Enough, MemoryError, fw.Stopped)):
        return False
    if isinstance(error, fw.Error) and "\n" in text:
        return True
    return isinstance(error, (SystemError, UnicodeDecodeError)) or bool(RAW.search(text[:2000])) or not text


def shown(arguments):
    """Arguments as they are called, on one line."""
    return reprlib.repr(arguments).encode("ascii", "backslashreplace").decode().replace("\n", " ")[:400]


def plain(text):
    """Without places in memory."""
    return re.sub(r" at 0x[0-9a-f]+", "", text)


class Calls:
    def __init__(self, seed, folder):
        self.random = random.Random(seed)
        self.values = call_values.Values(self.random, folder)
        self.known = call_signatures.calls()
        self.faults = 0
        self.answered = 0
        self.raised = 0

    def run(self, count):
        for number in range(count):
            step = self.random.choice((self.call, self.call, self.call, self.call, self.look, self.copy_one))
            try:
                self.watched(step, number)
                self.answered += 1
            except (Exception, Enough) as error:
                self.raised += 1
                if is_fault(error):
                    self.fault(f"{number}: {type(error).__name__}: {str(error)[:300]!r}")

    @staticmethod
    def watched(step, number):
        signal.setitimer(signal.ITIMER_PROF, SECONDS)  # it fires once at most
        try:
            step(number)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)

    def fault(self, what):
        self.faults += 1
        print(f"fault at call {what}", flush=True)

    def arguments(self, call):
        random, values = self.random, self.values
        count = random.choice((call.needed, len(call.parameters), random.randint(0, len(call.parameters))))
        given = [values.of(parameter.annotation) for parameter in call.parameters[:count]]
        named = {parameter.arg: values.of(parameter.annotation) for parameter in call.keywords if random.random() < 0.25}
        if given and random.random() < 0.3:
            given[random.randrange(len(given))] = values.wrong()
        if random.random() < 0.03:
            given.append(values.wrong())
        if named and random.random() < 0.2:
            named[random.choice(list(named))] = values.wrong()
        return given, named

    def call(self, number):
        call = self.random.choice(self.known)
        owner, _, member = call.name.rpartition(".")
        given, named = self.arguments(call)
        print(number, call.name, shown(given), shown(named), file=sys.stderr)
        if call.kind == "field":
            subject = self.values._named(owner)
            if type(subject).__qualname__ == owner:
                setattr(subject, member, given[0] if given else None)
        elif call.kind == "method":
            self.values.keep(call.function()(self.values._named(owner), *given, **named))
        else:
            self.values.keep(call.function()(*given, **named))

    def look(self, number):
        """A part of an object is as it was when the object itself is gone."""
        owner = self.values.any_object()
        names = [name for name in dir(type(owner)) if not name.startswith("__") and isinstance(getattr(type(owner), name, None), property)]
        if not names:
            return
        name = self.random.choice(names)
        print(number, f"{type(owner).__qualname__}.{name}", file=sys.stderr)
        part = getattr(owner, name)
        before = repr(part)
        bits = np.array(part, copy=True) if isinstance(part, np.ndarray) else None
        self.values.drop(owner)
        is_shared = sys.getrefcount(owner) > 2
        del owner
        gc.collect()
        if not is_shared and repr(part) != before:
            self.fault(f"{number}: {name} is another value when its object is gone")
        if bits is not None and not is_shared and part.tobytes() != bits.tobytes():
            self.fault(f"{number}: the view {name} is another one when its object is gone")
        self.values.keep(part)

    def copy_one(self, number):
        value = self.values.any_object()
        print(number, f"copies of {type(value).__qualname__}", file=sys.stderr)
        repr(value)
        hash(value) if type(value).__hash__ else None
        how = self.random.randrange(4)
        if how < 2:
            again = pickle.loads(pickle.dumps(value)) if how == 0 else copy.deepcopy(value)
            if hasattr(type(value), "_fields") and plain(repr(again)) != plain(repr(value)):
                self.fault(f"{number}: a copy of {type(value).__qualname__} is another value")
            self.values.keep(again)
        elif how == 2:
            bool(value == self.values.wrong())
        elif hasattr(value, "__setstate__"):
            type(value).__setstate__(value, self.values.wrong())


def main():
    seed, count = int(sys.argv[1]), int(sys.argv[2])
    if "libasan" not in os.environ.get("LD_PRELOAD", ""):  # it needs more than any limit
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    signal.signal(signal.SIGPROF, interrupt)
    with tempfile.TemporaryDirectory() as name:
        os.chdir(name)
        calls = Calls(seed, pathlib.Path(name))
        calls.run(count)
        os.chdir("/")
    print(len(calls.known), calls.answered, calls.raised)
    return 1 if calls.faults else 0


if __name__ == "__main__":
    sys.exit(main())
