# SPDX-License-Identifier: GPL-3.0-or-later
"""An attack on the program: attack.py PROGRAM [--rounds N] [--seed S] [--only PART ..]

inputs    N damaged files of every kind that `fretwork check` reads: no signal, no time-out, one line, exit code 0 or 2
outputs   an output that is an input of the command, by name, link and hard link: the input is never lost
full      /dev/full as output: exit code 2 and one line
kills     SIGKILL, SIGTERM and SIGINT at random times: files are whole or absent, and nothing but SIGKILL ends by a signal
bits      the same file whatever the threads, the time zone, the locale and the environment
doors     what the studio must not answer: other hosts, origins, tokens, paths and methods

A line for each part. Exit code 1: something was found; it stands above its line."""
import argparse
import http.client
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPORA = ROOT / "tests" / "fuzz" / "corpora"
EXPERIMENTS = ROOT / "experiments"
ENDINGS = {"svg": "svg", "dxf": "dxf", "obj": "obj", "ply": "ply", "off": "off", "deck": "inp", "image": "png", "library": "db"}
JSON_KINDS = "outline autosave beams facts frame layout load-case painting project result scenario setting stages target".split()
PATIENCE = 60  # s; a machine may be busy
MOST_MEMORY = 4 << 30  # bytes


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


class Attack:
    def __init__(self, program, folder, options):
        self.program, self.folder, self.rounds = program, folder, options.rounds
        self.random = random.Random(options.seed)
        self.found = 0

    def run(self, *words, env=None):
        return subprocess.run([self.program, *map(str, words)], cwd=self.folder, capture_output=True, timeout=PATIENCE, preexec_fn=limit_memory, env=env)

    def made(self, *words):
        done = self.run(*words)
        if done.returncode > 1:
            raise SystemExit(f"attack.py: {words}: {done.stderr.decode(errors='replace')}")

    def fault(self, what):
        self.found += 1
        print(f"  found: {what}")

    def make_surface(self):
        self.made("tile", EXPERIMENTS / "outlines" / "specimen.svg", "--edge-length", "40mm", "--patterns", "0-1+1-6", "--out", "p.json")
        self.made("case", "add", "p.json", EXPERIMENTS / "cases" / "cantilever.json")
        self.made("simulate", "p.json", "--out", "r.json", "--frame-out", "f.json")

    def damaged(self, content):
        data = bytearray(content)
        for _ in range(self.random.choice((1, 1, 2, 4, 16))):
            place = self.random.randrange(len(data) + 1)
            kind = self.random.randrange(5)
            if kind == 0:
                data[place:place + 1] = self.random.randbytes(1)
            elif kind == 1:
                del data[place:place + self.random.choice((1, 4, 64, len(data)))]
            elif kind == 2:
                data[place:place] = data[self.random.randrange(len(data) + 1):][:self.random.choice((4, 64))]
            else:
                data[place:place + 1] = self.random.choice((b"1e308", b"-1", b"1e-300", b"99999999999999999999", b"nan", b"\x00", b"\xff", b'"', b"{", b"[", b"\n"))
        return bytes(data)

    def inputs(self):
        examples = [(file, ENDINGS.get(kind, "json")) for kind in [*ENDINGS, *JSON_KINDS] for file in sorted((CORPORA / kind).iterdir())]
        codes = {}
        for number in range(self.rounds):
            file, ending = self.random.choice(examples)
            bad = self.folder / f"bad.{ending}"
            bad.write_bytes(self.damaged(file.read_bytes()))
            try:
                done = self.run("check", bad.name)
            except subprocess.TimeoutExpired:
                self.keep(bad, number, "time-out")
                continue
            codes[done.returncode] = codes.get(done.returncode, 0) + 1
            lines = done.stderr.decode(errors="replace").splitlines()
            is_plain = len(lines) <= 1 and all(32 <= ord(c) for line in lines for c in line)
            if done.returncode not in (0, 2) or not is_plain or (done.returncode == 2) != (len(lines) == 1):
                self.keep(bad, number, f"exit code {done.returncode}, {len(lines)} lines: {' '.join(lines)[:200]}")
        return f"{self.rounds} damaged files, exit codes {dict(sorted(codes.items()))}"

    def keep(self, file, number, what):
        kept = ROOT / "out" / "attack" / f"{number}_{file.name}"
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_bytes(file.read_bytes())
        self.fault(f"{kept}: {what}")

    def outputs(self):
        commands = (("simulate", "p.json", "--out", "X"), ("export", "p.json", "--to", "X"), ("solve", "f.json", "--out", "X"), ("compare", "r.json", "r.json", "--out", "X"),
                    ("beams", "p.json", "r.json", "--out", "X"), ("simulate", "p.json", "--out", "r2.json", "--frame-out", "X"))
        tried = 0
        for command in commands:
            for victim in [word for word in command if word.endswith(".json") and (self.folder / word).exists()]:
                content = (self.folder / victim).read_bytes()
                link, hard = self.folder / "link.json", self.folder / "hard.json"
                for name in (link, hard):
                    name.unlink(missing_ok=True)
                link.symlink_to(victim)
                os.link(self.folder / victim, hard)
                for target in (victim, f"./{victim}", str(self.folder / victim), "link.json", "hard.json"):
                    self.run(*[target if word == "X" else word for word in command])
                    tried += 1
                    if (self.folder / victim).read_bytes() != content:
                        self.fault(f"{' '.join(command)} with X = {target} replaced its input")
                        (self.folder / victim).write_bytes(content)
        return f"{tried} outputs that are inputs"

    def full(self):
        commands = (("simulate", "p.json", "--out", "/dev/full"), ("enumerate", "--list", "/dev/full"), ("solve", "f.json", "--out", "/dev/full"),
                    ("tile", EXPERIMENTS / "outlines" / "specimen.svg", "--edge-length", "60mm", "--out", "/dev/full"))
        for command in commands:
            done = self.run(*command)
            if done.returncode != 2 or done.stderr.count(b"\n") != 1:
                self.fault(f"{command}: exit code {done.returncode}: {done.stderr[:200]}")
        return f"{len(commands)} commands that write to a full device"

    def kills(self):
        commands = (("calibrate", "--library", "l.db", "--starts", "8"), ("simulate", "p.json", "--out", "k.json"), ("paint", "p2.json", "--patterns", "random:1", "--palette", "0-6,0-1+1-6"),
                    ("tile", EXPERIMENTS / "outlines" / "specimen.svg", "--edge-length", "20mm", "--out", "t.json"))
        self.made("enumerate", "--layout", "faces5", "--library", "l.db")
        (self.folder / "p2.json").write_bytes((self.folder / "p.json").read_bytes())
        count = max(12, self.rounds // 50)
        for _ in range(count):
            command, how = self.random.choice(commands), self.random.choice((signal.SIGKILL, signal.SIGTERM, signal.SIGINT))
            running = subprocess.Popen([self.program, *map(str, command)], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # the attack itself may run in the background
            while running.poll() is None and not self.catches(running.pid, signal.SIGTERM):
                time.sleep(0.001)  # until main has begun, no program can do anything about a signal
            time.sleep(self.random.random() * 0.5)
            running.send_signal(how)
            code = running.wait(PATIENCE)
            if code < 0 and how != signal.SIGKILL:
                self.fault(f"{command[0]}: killed by signal {-code}")
            present = [name for name in ("l.db", "k.json", "p2.json", "t.json") if (self.folder / name).exists()]
            done = self.run("check", *present)
            if done.returncode != 0:
                self.fault(f"{command[0]} and signal {int(how)}: {done.stderr[:200]}")
        return f"{count} signals at random times"

    @staticmethod
    def catches(pid, number):
        try:
            status = pathlib.Path(f"/proc/{pid}/status").read_text()
        except OSError:
            return True
        caught = re.search(r"^SigCgt:\s*(\w+)", status, re.MULTILINE)
        return caught is None or bool(int(caught[1], 16) >> (number - 1) & 1)

    def bits(self):
        base = dict(os.environ)
        variants = {"threads": (["--threads", "3"], base), "time zone": ([], {**base, "TZ": "Asia/Tokyo"}), "locale": ([], {**base, "LC_ALL": "de_DE.UTF-8"}), "no environment": ([], {})}

        def result(more, env):
            self.run("simulate", "p.json", "--out", "bits.json", *more, env=env)
            return re.sub(rb'"seconds": [^,\n]*', b"", (self.folder / "bits.json").read_bytes())

        wanted = result(["--threads", "1"], base)
        for name, (more, env) in variants.items():
            if result(more, env) != wanted:
                self.fault(f"another result: {name}")
        return f"{len(variants)} surroundings"

    def doors(self):
        env = {**os.environ, "XDG_STATE_HOME": str(self.folder / "state")}
        studio = subprocess.Popen([self.program, "studio", "p.json", "--no-browser"], cwd=self.folder, stdout=subprocess.PIPE, text=True, env=env)
        try:
            port, token = re.match(r"http://127\.0\.0\.1:(\d+)/\?token=(\w+)", studio.stdout.readline().strip()).groups()
            good = {"Host": f"127.0.0.1:{port}"}
            tries = [("GET", f"/?token={token}", good, 200), ("GET", "/", good, 403), ("GET", f"/?token={token[:-1]}", good, 403), ("GET", f"/?token={token}{token}", good, 403),
                     ("POST", f"/?token={token}", good, None), ("GET", f"/../etc/passwd?token={token}", good, None), ("GET", f"/export?token={token}&to=../../x", good, None)]
            tries += [("GET", f"/?token={token}", {"Host": host}, 403) for host in ("evil.example", f"localhost.evil.example:{port}", f"127.0.0.1.evil.example:{port}", "localhost@evil", "")]
            tries += [("GET", f"/?token={token}", {**good, "Origin": origin}, 403) for origin in ("null", "http://evil.example", "file://", f"https://localhost.evil.example:{port}")]
            for method, path, headers, wanted in tries:
                connection = http.client.HTTPConnection("127.0.0.1", int(port), timeout=PATIENCE)
                connection.putrequest(method, path, skip_host=True)
                for name, value in headers.items():
                    connection.putheader(name, value)
                connection.endheaders()
                status = connection.getresponse().status
                if not (status == wanted or (wanted != 200 and 400 <= status < 500)):
                    self.fault(f"{method} {path} with {headers}: {status}")
            return f"{len(tries)} requests"
        finally:
            studio.terminate()
            studio.wait(PATIENCE)


PARTS = ("inputs", "outputs", "full", "kills", "bits", "doors")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS)
    options = parser.parse_args()
    found = 0
    for part in options.only:
        with tempfile.TemporaryDirectory() as name:
            attack = Attack(str(options.program.resolve()), pathlib.Path(name), options)
            attack.make_surface()
            summary = getattr(attack, part)()
            print(f"{part}: {summary}: {attack.found} found", flush=True)
            found += attack.found
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
