# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module, for experiments that call it hundreds of times: `from module import fw`."""
try:
    import fretwork as fw  # noqa: F401
except ImportError as error:
    raise SystemExit(f"the Python module is needed: build it with `make python`, and name its folder in PYTHONPATH ({error})") from None
