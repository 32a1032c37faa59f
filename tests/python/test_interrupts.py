# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work gives up the interpreter, tells its progress, and ends where it is asked to."""

import os
import signal
import tempfile
import threading
import unittest

import fretwork as fw
import support


def interrupt_soon(seconds=0.3):
    threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()


def long_work(**keywords):
    """An enumeration that takes far longer than any of these tests."""
    return fw.count_patterns(fw.find_node_layout("fifths12"), **keywords)


class Interrupts(unittest.TestCase):
    def test_ctrl_c_ends_long_work(self):
        for threads in (1, 2):
            interrupt_soon()
            with self.assertRaises(KeyboardInterrupt):
                long_work(threads=threads)

    def test_a_library_keeps_what_is_done(self):
        with tempfile.TemporaryDirectory() as folder:
            library = fw.Library.create(folder + "/own.db", fw.paper_layout(), fw.paper_setting())
            library.add_patterns(fw.enumerate_patterns(fw.paper_layout()))
            interrupt_soon(1.0)
            with self.assertRaises(KeyboardInterrupt):
                library.fill(seconds_between_stores=0)
            stored = sum(1 for summary in library.summaries() if summary.calibrations)
            self.assertLess(stored, 1824)
            self.assertEqual(library.failures(), [])

    def test_another_thread_runs_meanwhile(self):
        ticks = []
        stop = threading.Event()

        def tick():
            while not stop.wait(0.01):
                ticks.append(1)

        thread = threading.Thread(target=tick)
        thread.start()
        interrupt_soon(0.5)
        with self.assertRaises(KeyboardInterrupt):
            long_work()
        stop.set()
        thread.join()
        self.assertGreater(len(ticks), 5)

    def test_a_handler_of_ones_own_is_called(self):
        called = []

        def handler(number, frame):
            called.append(number)
            raise TimeoutError("enough")

        before = signal.signal(signal.SIGALRM, handler)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.2)
            with self.assertRaises(TimeoutError):
                long_work(threads=1)
        finally:
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(called, [signal.SIGALRM])

    def test_the_handler_of_sigint_is_as_before(self):
        before = signal.getsignal(signal.SIGINT)
        fw.count_patterns(fw.paper_layout())
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        with self.assertRaises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)


class Progress(unittest.TestCase):
    def test_goes_from_nothing_to_all(self):
        told = []
        fw.count_patterns(fw.paper_layout(), progress=lambda *how_far: told.append(how_far))
        self.assertEqual(told[0][1], 0)
        self.assertEqual(told[-1][1], told[-1][2])

    def test_its_exception_ends_the_work(self):
        def enough(task, done, total):
            raise ValueError("enough")

        with self.assertRaisesRegex(ValueError, "enough"):
            long_work(progress=enough)

    def test_something_else_is_refused(self):
        with self.assertRaisesRegex(TypeError, "progress"):
            fw.count_patterns(fw.paper_layout(), progress=3)

    def test_a_bar_is_drawn_for_long_tasks_only(self):
        import io

        from fretwork._progress import Bar

        stream = io.StringIO()
        bar = Bar(stream)
        bar("quick", 0, 10)
        bar("quick", 10, 10)
        self.assertEqual(stream.getvalue(), "")


class Sessions(unittest.TestCase):
    def test_edits_are_kept_when_a_solution_is_stopped(self):
        session = fw.Session(support.surface(), support.tip(), model="full")
        session.paint([0], support.OTHER)

        def stop(*_):
            raise InterruptedError

        with self.assertRaises(InterruptedError):
            session.solve(progress=stop)
        self.assertEqual(session.surface.tessellation.pattern_of(0).id, support.OTHER)
        self.assertTrue(session.solve().converged)


if __name__ == "__main__":
    unittest.main()
