# SPDX-License-Identifier: GPL-3.0-or-later
"""Build the wheel by CMake: a PEP 517 back end without dependencies, so that `pip install .` needs no net.

It builds in build/release, as `make python` and daily work do. With another Python than the one of that folder it
builds in a folder of its own. `--config-settings build-folder=FOLDER` takes a folder that is configured already.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAME = "fretwork"
EPOCH = (1980, 1, 1, 0, 0, 0)


def _version():
    return re.search(r"project\(fretwork VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


def _tag():
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{interpreter}-{interpreter}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _metadata():
    return (f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {_version()}\n"
            "Summary: Flat, tileable beam patterns that bend: enumerate, calibrate, tile, simulate\n"
            "License: GPL-3.0-or-later\nRequires-Python: >=3.11\nRequires-Dist: numpy\n"
            "Description-Content-Type: text/markdown\n\n" + (ROOT / "apps/python/README.md").read_text())


def _built_in(folder):
    """Build the package in a configured folder, and return where it lies."""
    subprocess.run(["cmake", "--build", str(folder), "--target", "fretwork_python"], cwd=ROOT, check=True)
    return pathlib.Path(folder) / "apps/python/fretwork"


def _build():
    """Configure, build the package and return its folder."""
    python = os.path.realpath(sys.executable)
    own = python.startswith(os.path.realpath("/usr/bin/python3"))
    folder = ROOT / "build" / ("release" if own else f"python-{_tag()}")
    configure = ["cmake", "--preset", "release", "-B", folder, "-DFRETWORK_BUILD_PYTHON=ON",
                 f"-DPython3_EXECUTABLE={python}"]
    subprocess.run(list(map(str, configure)), cwd=ROOT, check=True)
    return _built_in(folder)


def _content(path):
    """The bytes of a file of the package: of a library without its debug information."""
    if path.suffix != ".so":
        return path.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / path.name
        subprocess.run(["strip", "--strip-debug", "-o", copy, path], check=True)
        return copy.read_bytes()


def _record(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = (config_settings or {}).get("build-folder")
    package = _built_in(folder) if folder else _build()
    info = f"{NAME}-{_version()}.dist-info"
    files = {f"{NAME}/{path.name}": _content(path) for path in sorted(package.iterdir()) if path.is_file()}
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\n"
                              f"Tag: {_tag()}\n").encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(_record(name, content) for name, content in files.items()) + f"{info}/RECORD,,\n"
    files[f"{info}/RECORD"] = record.encode()
    wheel = f"{NAME}-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    name = f"{NAME}-{_version()}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True).stdout
    path = pathlib.Path(sdist_directory) / f"{name}.tar.gz"
    with tarfile.open(path, "w:gz") as archive:
        for file in filter(None, listed.decode().split("\0")):
            archive.add(ROOT / file, f"{name}/{file}")
    return path.name


if __name__ == "__main__":  # make python
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    made = target / build_wheel(target)
    print(f"{made}: {made.stat().st_size / 1e6:.1f} MB, tag {_tag()}")
