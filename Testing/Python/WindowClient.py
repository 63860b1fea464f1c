# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""WebSocket clients (RFC 6455) with Python's standard library, for tests of vtkWindowServer.

They never wait for messages: a test calls poll() and the server in turn, in one thread.
"""

import base64
import hashlib
import os
import select
import socket
import struct
import urllib.parse

GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


class Refused(Exception):
    """The server answered with this HTTP status."""

    def __init__(self, status):
        super().__init__(f"HTTP status {status}")
        self.status = status


def request(address, lines, *, buffer_size=None):
    """Sends the lines of a request. Returns the socket, the head of the answer, and what follows."""
    connection = socket.socket()
    if buffer_size is not None:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer_size)
    connection.settimeout(20)
    try:
        connection.connect(address)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall("\r\n".join([*lines, "", ""]).encode())
        received = b""
        while b"\r\n\r\n" not in received:
            data = connection.recv(65536)
            if not data:
                raise ConnectionError("the server closed the connection")
            received += data
    except OSError:
        connection.close()
        raise
    head, rest = received.split(b"\r\n\r\n", 1)
    return connection, head.decode(), rest


def frame(opcode, data, *, is_last=True):
    """A frame of a client, which masks its data."""
    size = len(data)
    head = bytes([opcode | (0x80 if is_last else 0)])
    if size < 126:
        head += bytes([0x80 | size])
    elif size < 65536:
        head += struct.pack(">BH", 0xFE, size)
    else:
        head += struct.pack(">BQ", 0xFF, size)
    mask = os.urandom(4)
    repeated = (mask * (size // 4 + 1))[:size]
    number = int.from_bytes(data, "big") ^ int.from_bytes(repeated, "big")
    return head + mask + number.to_bytes(size, "big")


class WebSocket:
    def __init__(self, url, headers, **settings):
        parts = urllib.parse.urlsplit(url)
        key = base64.b64encode(os.urandom(16)).decode()
        path = parts.path + (f"?{parts.query}" if parts.query else "")
        lines = [
            f"GET {path} HTTP/1.1",
            *(f"{name}: {value}" for name, value in {"Host": parts.netloc, **headers}.items()),
            "Upgrade: websocket",
            "Connection: Upgrade",
            f"Sec-WebSocket-Key: {key}",
            "Sec-WebSocket-Version: 13",
        ]
        self.socket, head, self.received = request(
            (parts.hostname, parts.port), lines, **settings
        )
        self.is_open = True
        status = int(head.split()[1])
        if status != 101:
            self.socket.close()
            raise Refused(status)
        accepted = base64.b64encode(hashlib.sha1((key + GUID).encode()).digest()).decode()
        assert accepted in head, head

    def close(self):
        self.is_open = False
        self.socket.close()

    def send(self, *words):
        self.send_frame(TEXT, " ".join(map(str, words)).encode())

    def send_frame(self, opcode, data, **settings):
        self.socket.sendall(frame(opcode, data, **settings))

    def poll(self, wait=0):
        """The data of messages that have arrived, after at most this time in seconds."""
        messages = []
        while self.is_open and select.select([self.socket], [], [], wait)[0]:
            wait = 0
            try:
                data = self.socket.recv(1 << 20)
            except ConnectionError:
                data = b""
            if not data:
                self.close()
                break
            self.received += data
            self.take_messages(messages)
        return messages

    def take_messages(self, messages):
        while self.is_open and len(self.received) >= 2:
            # Servers do not mask, and these ones do not divide messages.
            assert self.received[0] & 0x80 and not self.received[1] & 0x80
            start, size = 2, self.received[1]
            if size > 125:
                start = 4 if size == 126 else 10
                size = int.from_bytes(self.received[2:start], "big")
            if len(self.received) < max(start, start + size):
                break
            opcode = self.received[0] & 15
            data = self.received[start : start + size]
            self.received = self.received[start + size :]
            if opcode in (TEXT, BINARY):
                messages.append(data)
            elif opcode == PING:
                self.send_frame(PONG, data)
            elif opcode == CLOSE:
                try:
                    self.send_frame(CLOSE, data)
                except OSError:
                    pass  # the server has ended
                self.close()


class WindowClient(WebSocket):
    """A client of vtkWindowServer. Unless it is slow, it confirms each picture at once."""

    def __init__(self, url, *, token=None, origin="", host=None, is_slow=False, **settings):
        parts = urllib.parse.urlsplit(url)
        if token is None:
            token = urllib.parse.parse_qs(parts.query)["token"][0]
        headers = {} if host is None else {"Host": host}
        if origin is not None:
            headers["Origin"] = origin or "http://" + (host or parts.netloc)
        super().__init__(f"http://{parts.netloc}/window?token={token}", headers, **settings)
        self.is_slow = is_slow
        self.pictures = []

    def update(self, wait=0):
        """Takes pictures that have arrived, JPEG or PNG files."""
        for picture in self.poll(wait):
            self.pictures.append(picture)
            if not self.is_slow and self.is_open:
                try:
                    self.send("shown")
                except ConnectionError:
                    self.close()

    def is_still(self):
        """Whether the last picture is lossless."""
        return bool(self.pictures) and self.pictures[-1][:4] == b"\x89PNG"
