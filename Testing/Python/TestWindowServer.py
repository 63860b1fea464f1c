# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves vtkWindowServer with a WebSocket client: pictures, events, slow clients, bad requests."""

import gc
import os
import pathlib
import random
import re
import socket
import subprocess
import sys
import time
import unittest
import urllib.parse

import relevo
from ErrorMessages import MessageCatcher
from WindowClient import BINARY, TEXT, Refused, WindowClient, frame, request
from WindowScene import frame_counter, make_window, own_picture, read_picture

if not hasattr(relevo, "vtkWindowServer"):
    print("skipped: built without civetweb")
    sys.exit(125)

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleJoystickCamera

WAIT = 20  # seconds until a test gives up


def resident_size():
    with open("/proc/self/statm", encoding="ascii") as numbers:
        return int(numbers.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


MESSAGES = ["move 1 2 0", "press 0 1 2 0 1", "release 2 -5 7 4", "wheel -1 3 4 0", "enter 0 0 0",
            "leave 9 9 7", "keydown 0 a", "keyup 7 Shift", "resize 80 60 100", "shown"]
NUMBERS = ["0", "1", "-1", "8", "25", "800", "801", "8193", "32768", "-32769", "2147483648", "1e3",
           "nan", "", " ", "0x1", "+1", "1.5", "9" * 30]
POSITION = [(-32767, 32767), (-32767, 32767), (0, 7)]
FIELDS = {
    "move": POSITION, "enter": POSITION, "leave": POSITION,
    "press": [(0, 2), *POSITION, (1, 2)],
    "release": [(0, 2), *POSITION],
    "wheel": [(-100, 100), *POSITION],
    "resize": [(1, 8192), (1, 8192), (25, 800)],
    "shown": [], "keydown": [(0, 7)], "keyup": [(0, 7)],
}


def is_message(data):
    """Whether the server must take these bytes for a message."""
    words = data.decode("latin-1").split(" ")
    fields = FIELDS.get(words[0])
    if fields is None or len(words) <= len(fields):
        return False
    numbers, rest = words[1 : len(fields) + 1], words[len(fields) + 1 :]
    for number, (low, high) in zip(numbers, fields):
        if not re.fullmatch(r"-?[0-9]+", number) or not low <= int(number) <= high:
            return False
    if not words[0].startswith("key"):
        return not rest
    key = " ".join(rest)
    return bool(rest) and 0 < len(key) <= 32 and not re.search(r"[\x00-\x1f\x7f]", key)


def change_bytes(rng, data, characters):
    """Inserts, replaces or removes a byte."""
    place = rng.randrange(len(data) + 1)
    data[place : place + rng.randrange(2)] = bytes([rng.choice(characters)] * rng.randrange(2))


def change_message(rng):
    """A good message with other numbers, words or bytes."""
    words = rng.choice(MESSAGES).split(" ")
    for _ in range(rng.randrange(1, 4)):
        change = rng.randrange(4)
        place = rng.randrange(len(words))
        if change == 0:
            words[place] = rng.choice(NUMBERS)
        elif change == 1:
            words.insert(place, rng.choice(NUMBERS))
        elif change == 2 and len(words) > 1:
            del words[place]
    data = bytearray(" ".join(words).encode())
    if rng.random() < 0.5:
        change_bytes(rng, data, b"\x00\xff -.,eax")
    return bytes(data[:250])


class TestWindowServer(unittest.TestCase):
    def setUp(self):
        self.window = make_window()
        self.server = relevo.vtkWindowServer()
        self.catcher = MessageCatcher(self.server)
        self.server.SetRenderWindow(self.window)
        self.assertTrue(self.server.Start())
        self.clients = []

    def tearDown(self):
        for client in self.clients:
            client.close()
        self.server.Stop()
        self.catcher.check(self)

    def connect(self, **settings):
        client = WindowClient(self.server.GetURL(), **settings)
        self.clients.append(client)
        return client

    def run_until(self, condition):
        """Runs the server and the clients in turn."""
        end = time.monotonic() + WAIT
        while not condition():
            self.assertLess(time.monotonic(), end, "nothing came")
            self.server.ProcessRequests(0.01)
            for client in self.clients:
                client.update()

    def run_for(self, seconds):
        end = time.monotonic() + seconds
        self.run_until(lambda: time.monotonic() > end)

    def await_still(self, *clients):
        """Waits until these clients have the window's picture, to the bit."""
        for client in clients:
            self.run_until(
                lambda client=client: client.is_still()
                and read_picture(client.pictures[-1]) == own_picture(self.window)
            )

    def observe(self, *events):
        """A list that gets each of these events of the interactor, with its data."""
        seen = []

        def add(interactor, event):
            seen.append(
                (event, interactor.GetEventPosition(), interactor.GetControlKey(),
                 interactor.GetShiftKey(), interactor.GetAltKey(), interactor.GetRepeatCount(),
                 interactor.GetKeyCode().rstrip("\0"), interactor.GetKeySym())
            )

        for event in events:
            self.window.GetInteractor().AddObserver(event, add, 1.0)
        return seen

    def test_still_pictures_are_the_windows(self):
        frames = frame_counter(self.window)
        client = self.connect()
        self.await_still(client)
        # The window was not drawn before: one frame, and nothing while nothing changes.
        self.assertEqual(len(frames), 1)
        size, pixels = read_picture(client.pictures[-1])
        self.assertEqual(size, (200, 150))
        self.assertGreater(len(set(zip(*[iter(pixels)] * 3))), 5)
        received = len(client.pictures)
        self.run_for(0.6)
        self.assertEqual((len(frames), len(client.pictures)), (1, received))
        # A second client gets the same picture without another frame.
        second = self.connect()
        self.await_still(second)
        self.assertEqual((len(frames), len(second.pictures)), (1, 1))
        self.assertEqual(second.pictures[0], client.pictures[-1])

    def test_drag_moves_the_camera(self):
        client = self.connect()
        self.await_still(client)
        camera = self.window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        first = camera.GetPosition()
        frames = frame_counter(self.window)
        client.pictures.clear()
        client.send("press", 0, 100, 75, 0, 1)
        client.send("move", 140, 60, 0)
        self.run_until(lambda: any(data[:2] == b"\xff\xd8" for data in client.pictures))
        client.send("release", 0, 140, 60, 0)
        self.await_still(client)
        self.assertGreater(sum((a - b) ** 2 for a, b in zip(first, camera.GetPosition())), 0.01)
        # All events that wait share a frame.
        self.assertLessEqual(len(frames), 3)

    def test_many_moves_share_a_frame(self):
        client = self.connect()
        self.await_still(client)
        frames = frame_counter(self.window)
        client.send("press", 0, 100, 75, 0, 1)
        for i in range(500):
            client.send("move", 100 + i % 50, 75, 0)
        client.send("move", 120, 90, 0)
        client.send("release", 0, 120, 90, 0)
        time.sleep(0.3)
        self.await_still(client)
        self.assertLessEqual(len(frames), 3)

    def test_events(self):
        self.window.GetInteractor().SetInteractorStyle(None)
        client = self.connect()
        self.run_until(lambda: client.pictures)
        seen = self.observe(
            "LeftButtonPressEvent", "LeftButtonReleaseEvent", "LeftButtonDoubleClickEvent",
            "RightButtonPressEvent", "RightButtonReleaseEvent", "MiddleButtonPressEvent",
            "MiddleButtonReleaseEvent", "MouseMoveEvent", "MouseWheelForwardEvent",
            "MouseWheelBackwardEvent", "EnterEvent", "LeaveEvent", "KeyPressEvent", "CharEvent",
            "KeyReleaseEvent",
        )
        # Positions are from the upper left corner, and VTK's from the lower left one.
        sent = [
            ("enter 5 6 0", [("EnterEvent", (5, 143), 0, 0, 0)]),
            ("move 10 20 1", [("MouseMoveEvent", (10, 129), 1, 0, 0)]),
            ("press 0 10 20 2 1", [("LeftButtonPressEvent", (10, 129), 0, 1, 0, 0)]),
            ("release 0 -3 160 4", [("LeftButtonReleaseEvent", (-3, -11), 0, 0, 1)]),
            ("press 0 1 2 0 2", [("LeftButtonPressEvent", (1, 147), 0, 0, 0, 1),
                                 ("LeftButtonDoubleClickEvent", (1, 147), 0, 0, 0, 1)]),
            ("release 0 1 2 0", [("LeftButtonReleaseEvent", (1, 147))]),
            ("press 1 1 2 0 1", [("MiddleButtonPressEvent", (1, 147))]),
            ("release 1 1 2 0", [("MiddleButtonReleaseEvent", (1, 147))]),
            ("press 2 1 2 7 1", [("RightButtonPressEvent", (1, 147), 1, 1, 1)]),
            ("release 2 1 2 0", [("RightButtonReleaseEvent", (1, 147))]),
            ("wheel 2 7 8 0", [("MouseWheelForwardEvent", (7, 141))] * 2),
            ("wheel -1 7 8 0", [("MouseWheelBackwardEvent", (7, 141))]),
            ("leave 5 6 0", [("LeaveEvent", (5, 143))]),
        ]
        for message, _ in sent:
            client.send(message)
        expected = [event for _, events in sent for event in events]
        self.run_until(lambda: len(seen) >= len(expected))
        self.assertEqual(
            [event[: len(wanted)] for event, wanted in zip(seen, expected)], expected
        )
        seen.clear()
        keys = [
            ("0 j", 0, "j", "j"), ("2 W", 0, "W", "W"), ("0 ArrowLeft", 0, "", "Left"),
            ("0  ", 0, " ", "space"), ("0 +", 0, "+", "plus"), ("0 Enter", 0, "\r", "Return"),
            ("0 F3", 0, "", "F3"), ("1 z", 1, "\x1a", "z"), ("0 Escape", 0, "\x1b", "Escape"),
        ]
        for message, *_ in keys:
            client.send("keydown " + message)
            client.send("keyup " + message)
        self.run_until(lambda: len(seen) >= 3 * len(keys))
        self.assertEqual(
            [(event[0], event[2], event[6], event[7]) for event in seen],
            [(name, *key[1:]) for key in keys
             for name in ("KeyPressEvent", "CharEvent", "KeyReleaseEvent")],
        )

    def test_timers_of_styles(self):
        # This style rotates while the button is held, by timers.
        self.window.GetInteractor().SetInteractorStyle(vtkInteractorStyleJoystickCamera())
        client = self.connect()
        self.await_still(client)
        frames = frame_counter(self.window)
        client.send("press", 0, 180, 75, 0, 1)
        self.run_until(lambda: len(frames) > 5)
        # A client that leaves lets go of its buttons.
        client.close()
        self.run_until(lambda: self.server.GetNumberOfClients() == 0)
        self.run_for(0.1)
        frames.clear()
        self.run_for(0.3)
        self.assertEqual(frames, [])

    def test_resizing(self):
        client = self.connect()
        self.await_still(client)
        dots = self.window.GetDPI()
        client.send("resize", 333, 222, 200)
        self.run_until(lambda: self.window.GetSize() == (333, 222))
        self.await_still(client)
        self.assertEqual(read_picture(client.pictures[-1])[0], (333, 222))
        self.assertEqual(self.window.GetDPI(), 2 * dots)
        self.server.AllowResizingOff()
        client.send("resize", 100, 100, 100)
        client.send("resize", 0, 100, 100)  # is malformed
        self.run_for(0.2)
        self.catcher.expect("malformed")
        self.assertEqual(self.window.GetSize(), (333, 222))
        # A program can change the size, too.
        self.window.SetSize(120, 90)
        self.await_still(client)
        self.assertEqual(read_picture(client.pictures[-1])[0], (120, 90))

    def test_quality_of_moving_pictures(self):
        client = self.connect()
        self.await_still(client)
        sizes = []
        for quality in (10, 95):
            self.server.SetJPEGQuality(quality)
            client.pictures.clear()
            self.window.Render()
            self.run_until(lambda: client.pictures)
            self.assertEqual(client.pictures[0][:2], b"\xff\xd8")
            sizes.append(len(client.pictures[0]))
            self.await_still(client)
        self.assertLess(2 * sizes[0], sizes[1])
        self.server.SetStillDelay(0)
        client.pictures.clear()
        self.window.Render()
        self.await_still(client)
        self.assertEqual(len(client.pictures), 1)

    def test_slow_clients(self):
        fast = self.connect()
        slow = self.connect(is_slow=True)
        self.await_still(fast)
        camera = self.window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        for _ in range(60):
            camera.Azimuth(1)
            self.window.Render()
            self.run_for(0.01)
        self.await_still(fast)
        # It gets two pictures, and the newest one after it has confirmed them.
        self.run_for(0.1)
        self.assertGreater(len(fast.pictures), 10)
        self.assertLessEqual(len(slow.pictures), 2)
        slow.is_slow = False
        for _ in slow.pictures:
            slow.send("shown")
        self.await_still(slow)
        self.assertLessEqual(len(slow.pictures), 4)

    def test_clients_that_stop_reading(self):
        client = self.connect(is_slow=True)
        self.run_until(lambda: client.pictures)
        camera = self.window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        for _ in range(10):
            self.window.Render()
            self.server.ProcessRequests(0.01)
        read = self.server.GetNumberOfReadFrames()
        sent = self.server.GetNumberOfPictures()
        self.assertLessEqual(sent, 2)
        frames = frame_counter(self.window)
        for _ in range(30):
            camera.Azimuth(1)
            self.window.Render()
            self.server.ProcessRequests(0)
        # No frame is lost, and none is read back.
        self.assertEqual(len(frames), 30)
        self.assertEqual(self.server.GetNumberOfReadFrames(), read)
        self.assertEqual(self.server.GetNumberOfPictures(), sent)

    def test_memory_of_clients_that_do_not_read(self):
        # This one confirms pictures that it has not read. They do not fit into the socket's buffers.
        window = make_window(size=(800, 600), is_noisy=True)
        self.server.SetRenderWindow(window)
        self.server.SetStillDelay(0)
        window.Render()
        client = self.connect(is_slow=True, buffer_size=65536)
        renderer = window.GetRenderers().GetFirstRenderer()
        picture = 3 * 800 * 600

        def draw(count):
            for i in range(count):
                renderer.SetBackground(0.01 * (i % 50), 0, 0)
                window.Render()
                client.send("shown")
                self.server.ProcessRequests(0.02)

        draw(15)
        gc.collect()
        before = resident_size()
        draw(30)
        self.assertLess(resident_size() - before, 2 * picture)
        self.server.SetRenderWindow(self.window)

    def test_requests_that_are_refused(self):
        url = self.server.GetURL()
        place = urllib.parse.urlsplit(url).netloc
        token = self.server.GetToken()
        for settings, status in (
            ({"token": ""}, 401),
            ({"token": "wrong"}, 401),
            ({"token": token[:-1]}, 401),
            ({"token": token + "0"}, 401),
            ({"token": token.upper() if token.upper() != token else token[::-1]}, 401),
            ({"token": "%00" + token}, 401),
            ({"origin": "http://example.org"}, 403),
            ({"origin": "null"}, 403),
            ({"origin": "http://" + place + ".example.org"}, 403),
            ({"host": "example.org", "origin": None}, 403),
            ({"host": "example.org:80", "origin": "http://example.org:80"}, 403),
            ({"host": "10.0.0.1", "origin": None}, 403),
            ({"host": "localhost:80; script-src *", "origin": None}, 403),
            ({"host": "", "origin": None}, 403),
        ):
            with self.subTest(settings), self.assertRaises(Refused) as error:
                self.connect(**settings)
            self.assertEqual(error.exception.status, status)
        self.server.ProcessRequests(0.05)
        self.assertEqual(self.server.GetNumberOfClients(), 0)
        # Programs send no origin. A tunnel has another port.
        self.connect(origin=None)
        self.connect(host="localhost:8080")
        self.run_until(lambda: self.server.GetNumberOfClients() == 2)

    def get(self, path, *, method="GET", **headers):
        """The status, the head and the body of an answer."""
        parts = urllib.parse.urlsplit(self.server.GetURL())
        lines = [f"{method} {path} HTTP/1.1", f"Host: {headers.pop('Host', parts.netloc)}"]
        lines += [f"{name}: {value}" for name, value in headers.items()]
        connection, head, body = request((parts.hostname, parts.port), lines)
        with connection:
            while data := connection.recv(65536):
                body += data
        return int(head.split()[1]), head, body.decode()

    def test_page(self):
        query = "?token=" + self.server.GetToken()
        status, head, page = self.get("/" + query)
        self.assertEqual(status, 200)
        self.assertIn("default-src 'none'", head)
        self.assertIn("no-store", head)
        # It needs nothing from elsewhere.
        self.assertNotRegex(page, r"https?://|src=|@import|url\(")
        self.assertNotIn("NONCE", page)
        self.assertLess(len(page), 16384)
        for path, method, status in (
            ("/", "GET", 401),
            ("/?token=", "GET", 401),
            ("/window", "GET", 401),
            ("/window" + query, "GET", 400),
            ("/other" + query, "GET", 404),
            ("/../../etc/passwd" + query, "GET", 404),
            ("/%2e%2e/etc/passwd" + query, "GET", 404),
            ("/" + query, "POST", 405),
            ("/" + query, "PUT", 405),
            ("/" + query, "OPTIONS", 405),
        ):
            with self.subTest(path=path, method=method):
                answer = self.get(path, method=method)
                self.assertEqual(answer[0], status)
                self.assertNotIn("Access-Control", answer[1])
        self.assertEqual(self.get("/" + query, Host="example.org")[0], 403)
        self.assertEqual(self.get("/" + query, Origin="http://example.org")[0], 403)

    def test_malformed_messages(self):
        client = self.connect()
        self.await_still(client)
        seen = self.observe("MouseMoveEvent", "LeftButtonPressEvent", "KeyPressEvent")
        messages = [
            b"", b" ", b"move", b"move 1", b"move 1 2", b"move 1 2 3 4", b"move  1 2 3",
            b"move 1 2 3 ", b" move 1 2 3", b"move 1 2 8", b"move 1.5 2 0", b"move nan 2 0",
            b"move 99999999999999999999 2 0", b"move 40000 2 0", b"MOVE 1 2 0", b"press 3 1 2 0 1",
            b"press 0 1 2 0 3", b"press -1 1 2 0 1", b"wheel 101 1 2 0", b"resize 0 1 100",
            b"resize 9000 9000 100", b"keydown 0", b"keydown 0 ", b"keydown 9 a",
            b"keydown 0 " + b"a" * 40, b"keydown 0 a\n", b"gone", b"\x00" * 20, b"\xff" * 200,
            b"<script>", b'{"move": [1, 2]}',
        ]
        for message in messages:
            client.send_frame(TEXT, message)
        client.send_frame(BINARY, b"move 1 2 0")
        client.send_frame(TEXT, b"move 1 ", is_last=False)
        client.send_frame(0, b"2 0")
        client.send("move 3 4 0")
        self.run_until(lambda: seen)
        self.assertEqual([event[1] for event in seen], [(3, 145)])
        # One line for the first, and one with their number in the end.
        self.catcher.expect("A client sent a malformed message of 0 bytes")
        client.close()
        self.run_until(lambda: self.server.GetNumberOfClients() == 0)
        self.run_for(0.05)
        self.catcher.expect(f"sent {len(messages) + 3} malformed messages")

    def test_many_malformed_messages(self):
        """Random changes of good messages. RELEVO_FUZZ_RUNS sets their number."""
        runs = int(os.environ.get("RELEVO_FUZZ_RUNS", "20000"))
        client = self.connect()
        self.await_still(client)
        rng = random.Random(int(os.environ.get("RELEVO_FUZZ_FIRST", "7")))
        sizes = []
        number = 0
        while number < runs or len(sizes) < 2:
            batch = []
            while len(batch) < 1000:
                message = change_message(rng)
                opcode = rng.choice((TEXT, TEXT, BINARY))
                if opcode == BINARY or not is_message(message):
                    batch.append(frame(opcode, message))
            client.socket.sendall(b"".join(batch))
            self.server.ProcessRequests(0)
            number += len(batch)
            sizes.append(resident_size())
        seen = self.observe("MouseMoveEvent")
        client.send("move 3 4 0")
        self.run_until(lambda: seen)
        self.assertEqual([event[1] for event in seen], [(3, 145)])
        self.assertLess(resident_size() - sizes[1], 2 << 20)
        self.catcher.expect("A client sent a malformed message")
        client.close()
        self.run_until(lambda: self.server.GetNumberOfClients() == 0)
        self.run_for(0.05)
        # None was taken for a good one.
        self.catcher.expect(f"sent {number} malformed messages")

    def test_many_malformed_requests(self):
        """Random changes of good requests, and random bytes, of pages and of windows."""
        runs = max(100, int(os.environ.get("RELEVO_FUZZ_RUNS", "20000")) // 100)
        client = self.connect()
        self.await_still(client)
        parts = urllib.parse.urlsplit(self.server.GetURL())
        rng = random.Random(int(os.environ.get("RELEVO_FUZZ_FIRST", "7")))
        good = [
            f"GET /?{parts.query} HTTP/1.1\r\nHost: {parts.netloc}\r\n\r\n",
            f"GET /window?{parts.query} HTTP/1.1\r\nHost: {parts.netloc}\r\n"
            "Upgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n",
        ]
        sizes = []
        for _ in range(runs):
            data = bytearray(rng.choice(good).encode())
            for _ in range(rng.choice((1, 1, 2, 8, 40))):
                change_bytes(rng, data, b"\x00\xff\r\n :/%?&=-09aZ")
            if rng.random() < 0.2:
                data = data[: rng.randrange(len(data))]
            elif rng.random() < 0.1:
                data = bytearray(rng.randbytes(rng.randrange(1, 3000)))
            with socket.create_connection((parts.hostname, parts.port), timeout=WAIT) as connection:
                answer = b""
                try:
                    connection.sendall(data)
                    connection.shutdown(socket.SHUT_WR)
                    while len(answer) < 12 and (more := connection.recv(4096)):
                        answer += more
                except ConnectionError:
                    pass
            self.assertRegex(answer, rb"\A(HTTP/|\Z)")
            self.server.ProcessRequests(0)
            sizes.append(resident_size())
        seen = self.observe("MouseMoveEvent")
        client.send("move 3 4 0")
        self.run_until(lambda: seen)
        self.assertLess(sizes[-1] - sizes[runs // 2], 4 << 20)
        self.run_until(lambda: self.server.GetNumberOfClients() == 1)

    def test_large_messages(self):
        for size in (257, 1 << 24):
            client = self.connect()
            self.run_until(lambda client=client: client.pictures)
            try:
                client.send_frame(TEXT, b"x" * size)
            except ConnectionError:
                pass
            self.run_until(lambda client=client: not client.is_open)
            self.run_for(0.05)
            self.catcher.expect(f"sent a message of {size} bytes and was disconnected")
        self.assertTrue(self.server.ProcessRequests(0))

    def test_stop_and_start(self):
        self.server.SetPort(self.server.GetActivePort())
        url = self.server.GetURL()
        self.assertRegex(url, r"^http://127\.0\.0\.1:\d+/\?token=[0-9a-f]{32}$")
        client = self.connect()
        self.await_still(client)
        self.server.Stop()
        self.assertFalse(self.server.IsRunning())
        self.assertFalse(self.server.ProcessRequests(0))
        self.assertEqual(
            (self.server.GetURL(), self.server.GetActivePort(), self.server.GetNumberOfClients()),
            ("", 0, 0),
        )
        client.update(1)
        self.assertFalse(client.is_open)
        with self.assertRaises(ConnectionError):
            WindowClient(url)
        self.assertTrue(self.server.Start())
        self.assertEqual(self.server.GetURL(), url)
        self.await_still(self.connect())

    def test_other_servers(self):
        port = self.server.GetActivePort()
        second = relevo.vtkWindowServer()
        catcher = MessageCatcher(second)
        self.assertFalse(second.Start())
        catcher.expect("Call SetRenderWindow()")
        second.SetRenderWindow(self.window)
        second.SetPort(port)
        self.assertFalse(second.Start())
        catcher.expect(f"The port {port} of 127.0.0.1 cannot be opened: another program uses it.")
        self.assertEqual(second.GetURL(), "")
        second.SetPort(0)
        second.SetAddress("192.0.2.1")  # reserved for documentation
        self.assertFalse(second.Start())
        catcher.expect("The port 0 of 192.0.2.1 cannot be opened")
        second.SetAddress("127.0.0.1")
        self.assertTrue(second.Start())
        self.assertNotEqual(second.GetToken(), self.server.GetToken())
        with socket.create_connection(("127.0.0.1", second.GetActivePort())):
            pass
        second.Stop()
        catcher.check(self)

    def test_settings(self):
        for name, good, bad in (
            ("Port", 8080, (-1, 65536)),
            ("JPEGQuality", 1, (0, 101)),
            ("StillDelay", 1.0, (-1.0, float("nan"), 1e9)),
            ("Address", "0.0.0.0", ("", "example.org", "127.0.0.1,0.0.0.0", "1" * 200)),
            ("Token", "My-token_1.~", ("a b", "a&b", "ä", "a" * 129)),
        ):
            getattr(self.server, "Set" + name)(good)
            for value in bad:
                getattr(self.server, "Set" + name)(value)
                self.catcher.expect(name + " must")
            self.assertEqual(getattr(self.server, "Get" + name)(), good)
        self.server.SetToken("")
        self.assertRegex(self.server.GetToken(), r"^[0-9a-f]{32}$")
        self.server.ProcessRequests(float("nan"))
        self.catcher.expect("ProcessRequests() must be in [0, 1e+06]")
        self.assertIsNone(re.search(self.server.GetToken(), str(self.server)))

    def test_example(self):
        source = pathlib.Path(__file__).resolve().parents[2] / "Examples/Python/windowserver.py"
        with subprocess.Popen(
            [sys.executable, source, "3"], text=True, stdout=subprocess.PIPE
        ) as program:
            client = WindowClient(program.stdout.readline().strip())
            while client.is_open:
                client.update(0.1)
            output, _ = program.communicate(timeout=WAIT)
        self.assertEqual(program.returncode, 0)
        # On a busy machine, the program can end before a lossless picture.
        still = [data for data in client.pictures if data.startswith(b"\x89PNG")]
        self.assertLessEqual({read_picture(data)[0] for data in still}, {(800, 600)})
        self.assertEqual(output, f"{len(client.pictures)} pictures\n")

    def test_windows_end(self):
        client = self.connect()
        self.await_still(client)
        interactor = self.window.GetInteractor()
        self.assertIsNotNone(interactor)
        other = make_window(size=(80, 60))
        self.server.SetRenderWindow(other)
        self.run_until(lambda: client.is_still() and read_picture(client.pictures[-1])[0] == (80, 60))
        self.assertEqual(read_picture(client.pictures[-1]), own_picture(other))
        self.server.SetRenderWindow(None)
        self.run_for(0.1)
        self.assertIsNone(self.window.GetInteractor())
        self.server.SetRenderWindow(self.window)
        self.await_still(client)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
