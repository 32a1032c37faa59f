# SPDX-License-Identifier: GPL-3.0-or-later
"""The program, as experiments run it."""
import subprocess


class Failed(SystemExit):
    """What the program said, in one line. Not caught, it ends the script with that line and the command before it."""

    def __init__(self, arguments, told):
        super().__init__(f"{' '.join(arguments)}: {told}")
        self.told = told


class Fretwork:
    def __init__(self, program, folder):
        self.program, self.folder = str(program), folder

    def __call__(self, *arguments, accepted=(0,)):
        """Run a command in the folder and give what it prints. Throws Failed at other exit codes than the accepted ones."""
        words = [str(argument) for argument in arguments]
        done = subprocess.run([self.program, *words], capture_output=True, text=True, cwd=self.folder)
        if done.returncode not in accepted:
            raise Failed(words, (done.stderr.strip() or done.stdout.strip() or "failed without a word").splitlines()[-1])
        return done.stdout
