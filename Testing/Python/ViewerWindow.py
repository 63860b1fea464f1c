# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""A window of relevo-view on a separate X server, with keys and mouse by xdotool."""

import ctypes
import os
import queue
import shutil
import subprocess
import sys
import threading
import time

from ViewerProgram import PROGRAM

SECONDS = 60  # limit for every action of a window

for tool in ("Xvfb", "xdotool"):
    if not shutil.which(tool):
        print(f"skipped: there is no {tool}")
        sys.exit(125)


def wait(condition, what):
    """Returns the first true value of a condition."""
    end = time.monotonic() + SECONDS
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"waited {SECONDS} s for {what}")
        time.sleep(0.02)


class Display:
    """An X server without a window manager, so that no other windows, keys or mice interfere.

    Xvfb resets by default when its last client disconnects, and may then refuse the next one. A
    server that terminates instead always refuses it."""

    def __init__(self, size="1024x768", terminates=False):
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{size}x24"]
            + ["-terminate" if terminates else "-noreset"],
            pass_fds=[writer],
            stderr=subprocess.DEVNULL,
        )
        os.close(writer)
        with os.fdopen(reader) as pipe:
            self.name = ":" + pipe.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name}

    def stop(self):
        self.server.terminate()
        self.server.wait()

    def do(self, *arguments):
        """The output of an xdotool command, or "" if it fails."""
        run = subprocess.run(
            ["xdotool", *map(str, arguments)],
            env=self.environment,
            capture_output=True,
            text=True,
        )
        return run.stdout.strip() if run.returncode == 0 else ""


class Window:
    """relevo-view in a window that has drawn and has the keyboard focus."""

    def __init__(self, display, folder, *arguments):
        self.display = display
        self.program = subprocess.Popen(
            [str(PROGRAM), *map(str, arguments), "--stats"],
            cwd=folder,
            env=display.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.lines = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()
        try:
            self.expect("frame time")  # the last of the statistics, after the first frames
            self.id = wait(lambda: display.do("search", "--name", "^relevo-view "), "the window")
            display.do("windowfocus", self.id)
            wait(lambda: display.do("getwindowfocus") == self.id, "the keyboard")
        except AssertionError:
            self.program.kill()
            raise

    def read(self):
        for line in self.program.stdout:
            self.lines.put(line.rstrip("\n"))

    def expect(self, words):
        """The next line of stdout that begins with these words."""
        end = time.monotonic() + SECONDS
        while True:
            try:
                line = self.lines.get(timeout=max(end - time.monotonic(), 0.0))
            except queue.Empty:
                self.program.kill()
                raise AssertionError(f"no line '{words}'; {self.program.stderr.read()}") from None
            if line.startswith(words):
                return line

    def key(self, name):
        self.display.do("key", name)

    def move(self, x, y):
        """Moves the mouse to a pixel, counted from the top left."""
        self.display.do("mousemove", "--window", self.id, x, y)

    def pixels(self):
        """The window's pixels on the screen, as bytes."""
        return read_screen(self.display.name, int(self.id))[0]

    def screen(self):
        """The same as rows of (red, green, blue), lowest first."""
        data, line = read_screen(self.display.name, int(self.id))
        rows = [data[start : start + line] for start in range(0, len(data), line)]
        # Blue, green, red and an unused byte.
        return [list(zip(row[2::4], row[1::4], row[0::4])) for row in reversed(rows)]

    def press(self):
        self.display.do("mousedown", 1)

    def release(self):
        self.display.do("mouseup", 1)

    def click_close_button(self):
        """Sends the message with which a window manager closes a window."""
        send_delete_window(self.display.name, int(self.id))

    def stop(self):
        """Ends the program of a test that failed. Otherwise the next test would find its window."""
        if self.program.poll() is None:
            self.program.kill()
            self.leave()

    def leave(self):
        """Exit code and stderr."""
        try:
            code = self.program.wait(SECONDS)
        finally:
            self.program.kill()
            self.reader.join()
            with self.program as program:
                errors = program.stderr.read()
        return code, errors


class ClientMessage(ctypes.Structure):
    _fields_ = [
        ("type", ctypes.c_int),
        ("serial", ctypes.c_ulong),
        ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p),
        ("window", ctypes.c_ulong),
        ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int),
        ("data", ctypes.c_long * 5),
        ("padding", ctypes.c_long * 12),  # an XEvent has 24 longs
    ]


class Image(ctypes.Structure):
    """The first members of an XImage."""

    _fields_ = [
        ("width", ctypes.c_int),
        ("height", ctypes.c_int),
        ("offset", ctypes.c_int),
        ("format", ctypes.c_int),
        ("data", ctypes.POINTER(ctypes.c_ubyte)),
        ("orders_and_depth", ctypes.c_int * 5),
        ("bytes_per_line", ctypes.c_int),
    ]


def read_screen(display_name, window):
    """A window's pixels as bytes, and the number of bytes per line."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XGetImage.restype = ctypes.POINTER(Image)
    display = ctypes.c_void_p(x11.XOpenDisplay(display_name.encode()))
    root, x, y, width, height, border, depth = (ctypes.c_ulong(), *(ctypes.c_int() for _ in range(6)))
    x11.XGetGeometry(
        display, ctypes.c_ulong(window), ctypes.byref(root), ctypes.byref(x), ctypes.byref(y),
        ctypes.byref(width), ctypes.byref(height), ctypes.byref(border), ctypes.byref(depth))
    all_planes, z_pixmap = ctypes.c_ulong(0xFFFFFF), 2
    image = x11.XGetImage(
        display, ctypes.c_ulong(window), 0, 0, width, height, all_planes, z_pixmap)
    line = image.contents.bytes_per_line
    data = ctypes.string_at(image.contents.data, line * height.value)
    x11.XDestroyImage(image)
    x11.XCloseDisplay(display)
    return data, line


def send_delete_window(display_name, window):
    """Sends WM_DELETE_WINDOW as the ICCCM specifies."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x11.XOpenDisplay(display_name.encode()))
    protocols, delete = (
        x11.XInternAtom(display, name, 0) for name in (b"WM_PROTOCOLS", b"WM_DELETE_WINDOW")
    )
    message = ClientMessage(
        type=33, window=window, message_type=protocols, format=32, data=(delete, 0, 0, 0, 0)
    )
    x11.XSendEvent(display, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(message))
    x11.XCloseDisplay(display)
