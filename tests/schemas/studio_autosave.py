# SPDX-License-Identifier: GPL-3.0-or-later
"""The autosave that the studio itself writes of a document that somebody has painted."""

import base64
import json
import os
import pathlib
import re
import socket
import subprocess
import time

PATIENCE = 30  # s; an autosave comes within half a second, and a busy machine takes longer


def masked_frame(text):
    """A text message as a browser sends it (RFC 6455): its bytes are masked, here by zeros, which leave them as they are."""
    data = text.encode()
    assert len(data) < 126
    return bytes((0x81, 0x80 | len(data), 0, 0, 0, 0)) + data


def connect(address):
    """A WebSocket of the studio at an address with its token."""
    host, port, token = re.match(r"http://([\d.]+):(\d+)/\?token=(\w+)", address).groups()
    connection = socket.create_connection((host, int(port)), timeout=PATIENCE)
    key = base64.b64encode(os.urandom(16)).decode()
    connection.sendall(f"GET /socket?token={token} HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                       f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
    answer = connection.recv(4096)
    assert b" 101 " in answer.split(b"\r\n")[0], answer
    return connection


def wait_for_file(folder):
    for _ in range(PATIENCE * 20):
        found = list(folder.rglob("*.json"))
        if found:
            return found[0].read_text()
        time.sleep(0.05)
    raise AssertionError(f"the studio has kept nothing in {folder}")


def autosave_of(program, project, state):
    """Open a project in the studio, paint a tile, and give the text of the autosave. `state`: an empty folder for it."""
    command = [program, "studio", str(project), "--no-browser"]
    studio = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env={**os.environ, "XDG_STATE_HOME": str(pathlib.Path(state).resolve())})
    try:
        with connect(studio.stdout.readline().strip()) as connection:
            for request in ({"id": 1, "do": "hello", "protocol": 1}, {"id": 2, "do": "paint", "tiles": [0], "pattern": "0-5+5-6"}):
                connection.sendall(masked_frame(json.dumps(request)))
            return wait_for_file(pathlib.Path(state))
    finally:
        studio.terminate()
        studio.communicate(timeout=PATIENCE)
