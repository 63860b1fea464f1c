# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves the page of vtkWindowServer in Chromium, which DevTools drive."""

import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request

import relevo
from ErrorMessages import MessageCatcher
from WindowClient import WebSocket
from WindowScene import frame_counter, make_window, own_picture, read_picture

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
if CHROMIUM is None or not hasattr(relevo, "vtkWindowServer"):
    print("skipped: no chromium, or built without civetweb")
    sys.exit(125)
WAIT = 20  # seconds until a test gives up


class Browser:
    """A headless Chromium with one tab."""

    def __init__(self, *, size=(640, 480), ratio=1.0):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.program = subprocess.Popen(
            [
                CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--mute-audio",
                "--no-first-run", "--disable-background-networking", "--disable-extensions",
                "--disable-dev-shm-usage", "--remote-debugging-port=0",
                "--remote-allow-origins=*", f"--user-data-dir={self.folder.name}", "about:blank",
            ],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        port_file = pathlib.Path(self.folder.name, "DevToolsActivePort")
        end = time.monotonic() + WAIT
        while not (port_file.exists() and port_file.read_text().count("\n")):
            if time.monotonic() > end or self.program.poll() is not None:
                raise RuntimeError("Chromium does not start")
            time.sleep(0.05)
        port = port_file.read_text().split()[0]
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list") as answer:
            pages = [page for page in json.load(answer) if page["type"] == "page"]
        self.tab = WebSocket(pages[0]["webSocketDebuggerUrl"], {})
        self.last = 0
        self.answers = {}
        self.problems = []
        self.on_wait = lambda: None
        self.call("Log.enable")
        self.call("Runtime.enable")
        self.call("Page.enable")
        self.resize(size, ratio)

    def close(self):
        self.program.terminate()
        self.program.wait()
        self.tab.close()
        self.folder.cleanup()

    def resize(self, size, ratio):
        self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1],
                  deviceScaleFactor=ratio, mobile=False)

    def call(self, method, **parameters):
        """Runs a command while on_wait() is called."""
        self.last += 1
        number = self.last
        message = {"id": number, "method": method, "params": parameters}
        self.tab.send_frame(1, json.dumps(message).encode())
        end = time.monotonic() + WAIT
        while number not in self.answers:
            assert time.monotonic() < end, method
            self.on_wait()
            for data in self.tab.poll(0.005):
                answer = json.loads(data)
                if "id" in answer:
                    self.answers[answer["id"]] = answer
                elif answer["method"] in ("Log.entryAdded", "Runtime.exceptionThrown"):
                    self.problems.append(answer["params"])
        answer = self.answers.pop(number)
        assert "error" not in answer, answer
        return answer["result"]

    def run(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def press(self, key, code, *, modifiers=0, text=None):
        for kind in ("keyDown", "keyUp"):
            settings = {"text": text} if text and kind == "keyDown" else {}
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=code,
                      modifiers=modifiers, **settings)

    def move(self, kind, x, y, **settings):
        self.call("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, **settings)

    def touch(self, kind, *points):
        self.call("Input.dispatchTouchEvent", type="touch" + kind,
                  touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])


class TestWindowPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.window = make_window()
        self.camera = self.window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        self.server = relevo.vtkWindowServer()
        self.catcher = MessageCatcher(self.server)
        self.server.SetRenderWindow(self.window)
        self.assertTrue(self.server.Start())
        self.browser.on_wait = lambda: self.server.ProcessRequests(0.005)
        self.browser.resize((640, 480), 1.0)
        self.browser.problems.clear()
        self.browser.call("Page.navigate", url=self.server.GetURL())
        self.await_true("document.readyState === 'complete' && view.dataset.pictures > 0")

    def tearDown(self):
        self.browser.call("Page.navigate", url="about:blank")
        self.server.Stop()
        self.catcher.check(self)
        self.assertEqual(self.browser.problems, [])

    def await_true(self, expression):
        end = time.monotonic() + WAIT
        while not self.browser.run(expression):
            self.assertLess(time.monotonic(), end, expression)

    def shown(self):
        """The picture on the page."""
        url = self.browser.run("view.toDataURL('image/png')")
        return read_picture(base64.b64decode(url.split(",")[1]))

    def await_own_picture(self):
        end = time.monotonic() + WAIT
        while self.shown() != own_picture(self.window):
            self.assertLess(time.monotonic(), end)

    def await_change(self, old, what):
        end = time.monotonic() + WAIT
        while what() == old:
            self.assertLess(time.monotonic(), end)
            self.server.ProcessRequests(0.01)

    def test_picture(self):
        self.await_true("view.width === 640 && view.height === 480")
        self.assertEqual(self.window.GetSize(), (640, 480))
        self.await_own_picture()
        self.assertGreater(len(set(own_picture(self.window)[1])), 5)
        # Device pixels of a dense screen.
        self.browser.resize((400, 300), 2.0)
        self.await_true("view.width === 800 && view.height === 600")
        self.await_own_picture()
        self.assertEqual(self.browser.run("view.getBoundingClientRect().width"), 400)
        # While nothing changes, nothing is drawn.
        frames = frame_counter(self.window)
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            self.server.ProcessRequests(0.02)
        self.assertEqual(frames, [])

    def test_mouse_and_wheel(self):
        self.await_own_picture()
        old = self.camera.GetPosition()
        self.browser.move("Pressed", 320, 240, button="left", buttons=1, clickCount=1)
        for i in range(5):
            self.browser.move("Moved", 330 + 20 * i, 250, button="left", buttons=1)
        self.browser.move("Released", 410, 250, button="left", buttons=0, clickCount=1)
        self.await_change(old, self.camera.GetPosition)
        self.await_own_picture()
        old = self.camera.GetPosition()
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=320, y=240, deltaX=0,
                          deltaY=-200)
        self.await_change(old, self.camera.GetPosition)
        self.await_own_picture()

    def test_positions_and_double_clicks(self):
        self.await_true("view.width === 640 && view.height === 480")
        self.window.GetInteractor().SetInteractorStyle(None)
        seen = []
        for event in ("RightButtonPressEvent", "LeftButtonDoubleClickEvent"):
            self.window.GetInteractor().AddObserver(
                event, lambda interactor, event: seen.append((event, interactor.GetEventPosition()))
            )
        self.browser.move("Pressed", 100, 50, button="right", buttons=2, clickCount=1)
        self.browser.move("Released", 100, 50, button="right", buttons=0, clickCount=1)
        for count in (1, 2):
            self.browser.move("Pressed", 10, 479, button="left", buttons=1, clickCount=count)
            self.browser.move("Released", 10, 479, button="left", buttons=0, clickCount=count)
        self.await_change(True, lambda: len(seen) < 2)
        self.assertEqual(seen, [("RightButtonPressEvent", (100, 429)),
                                ("LeftButtonDoubleClickEvent", (10, 0))])

    def test_keys(self):
        seen = []
        self.window.GetInteractor().AddObserver(
            "KeyPressEvent",
            lambda interactor, _: seen.append((interactor.GetKeySym(), interactor.GetControlKey())),
        )
        self.browser.press("g", "KeyG", text="g")
        self.browser.press("ArrowLeft", "ArrowLeft")
        self.browser.press("z", "KeyZ", modifiers=2)
        self.await_change(True, lambda: len(seen) < 3)
        self.assertEqual(seen, [("g", 0), ("Left", 0), ("z", 1)])
        # The view turns by keys alone, and Tab leaves it.
        for key in ("ArrowLeft", "ArrowUp"):
            old = self.camera.GetPosition()
            self.browser.press(key, key, modifiers=1)
            self.await_change(old, self.camera.GetPosition)
        old = self.camera.GetFocalPoint()
        self.browser.press("ArrowRight", "ArrowRight", modifiers=9)
        self.await_change(old, self.camera.GetFocalPoint)
        old = self.camera.GetPosition()
        self.browser.press("+", "NumpadAdd", modifiers=1)
        self.await_change(old, self.camera.GetPosition)
        self.await_own_picture()
        self.assertEqual(self.browser.run("document.activeElement.id"), "view")
        self.browser.press("Tab", "Tab")
        self.assertEqual(self.browser.run("document.activeElement.tagName"), "SUMMARY")

    def test_touch(self):
        self.await_own_picture()
        old = self.camera.GetPosition()
        self.browser.touch("Start", (300, 200))
        self.browser.touch("Move", (340, 230))
        self.browser.touch("End")
        self.await_change(old, self.camera.GetPosition)
        # Two fingers: 100 pixels to the right, and twice as far from each other.
        old = self.camera.GetFocalPoint()
        distance = self.camera.GetDistance()
        self.browser.touch("Start", (280, 240), (360, 240))
        self.browser.touch("Move", (340, 240), (500, 240))
        self.browser.touch("End")
        self.await_change(old, self.camera.GetFocalPoint)
        self.await_change(True, lambda: self.camera.GetDistance() > 0.8 * distance)
        self.await_own_picture()

    def test_lost_connection(self):
        self.await_true("notice.hidden")
        self.server.SetPort(self.server.GetActivePort())
        self.server.Stop()
        self.await_true("!notice.hidden && notice.textContent.includes('connection is lost')")
        self.camera.Azimuth(40)
        self.window.Render()
        self.assertTrue(self.server.Start())
        self.await_true("notice.hidden")
        self.await_own_picture()
        self.browser.problems.clear()  # Chromium logs connections that fail

    def test_help(self):
        self.assertFalse(self.browser.run("document.querySelector('details').open"))
        self.browser.run("document.querySelector('summary').focus()")
        self.browser.press("Enter", "Enter", text="\r")
        self.await_true("document.querySelector('details').open")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
