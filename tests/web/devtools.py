# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""A browser without a window, led by the DevTools protocol through a pipe: real keys, real pointers, pictures of the
page. Nothing but Python's own library."""

import argparse
import base64
import functools
import http.server
import json
import os
import select
import subprocess
import sys
import tempfile
import threading
import time

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(k_here), "parity"), k_here]
import browser
from openltc import skip

# What a key is called, which code the protocol wants, and what it types.
k_keys = {"Tab": (9, ""), "Enter": (13, "\r"), "Escape": (27, ""), "Backspace": (8, ""), "ArrowLeft": (37, ""), "ArrowUp": (38, ""),
          "ArrowRight": (39, ""), "ArrowDown": (40, ""), " ": (32, " "), ".": (190, "."), "-": (189, "-")}


def app_arguments(page, build):
    """The words of a test of web/app, and the browser's program; where that or `page` is missing, it skips. `build` makes
    the page where there is none yet, and returns its folder; a test may be short."""
    parser = argparse.ArgumentParser()
    for name in ("openltc", "work"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--app")
    parser.add_argument("--short", action="store_true")
    arguments = parser.parse_args()
    program = browser.find()
    if not program:
        skip("chromium not found (package chromium)")
    if arguments.app is None:
        arguments.app = build(arguments.openltc, os.path.abspath(arguments.work))
    if not os.path.exists(os.path.join(arguments.app, page)):
        skip("%s/%s is not there; make web makes it" % (arguments.app, page))
    os.makedirs(arguments.work, exist_ok=True)
    return arguments, program


class Server:
    """Files of a folder on this machine alone."""

    def __init__(self, folder):
        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
        self.address = "http://127.0.0.1:%d/" % self.server.server_port
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def close(self):
        self.server.shutdown()
        self.server.server_close()


class Page:
    """One page. `size`: width and height of what is seen, in its pixels."""

    def __init__(self, program, size, flags=()):
        self.profile = tempfile.TemporaryDirectory(prefix="openltc_browser_", ignore_cleanup_errors=True)
        to_browser, own_out = os.pipe()
        own_in, from_browser = os.pipe()

        def lead():
            # The browser reads from 3 and writes to 4.
            a, b = os.dup(to_browser), os.dup(from_browser)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program] + browser.k_flags + browser.k_software + list(flags)
            + ["--remote-debugging-pipe", "--user-data-dir=" + self.profile.name, "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, close_fds=False, preexec_fn=lead)
        os.close(to_browser)
        os.close(from_browser)
        self.out, self.inward = own_out, own_in
        self.buffer, self.number, self.session, self.events = b"", 0, None, []
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")
        self.call("Emulation.setFocusEmulationEnabled", enabled=True) # a page without a window has no focus
        self.resize(*size)

    def _read(self, timeout):
        end = time.monotonic() + timeout
        while b"\0" not in self.buffer:
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.inward], [], [], left)[0]:
                raise TimeoutError("the browser does not answer")
            data = os.read(self.inward, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, timeout=120, **parameters):
        """The answer of a method of the protocol."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._read(timeout)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError("%s: %s" % (method, answer["error"]["message"]))
                return answer["result"]
            self.events.append(answer)

    def crash_graphics(self):
        """Ends the process that draws; every page loses its graphics device, and the browser starts another one."""
        session, self.session = self.session, None
        try:
            self.call("Browser.crashGpuProcess")
        finally:
            self.session = session

    def resize(self, width, height, mobile=False, density=1):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=density, mobile=mobile)

    def dark(self, is_dark):
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}])

    def open(self, address):
        self.call("Page.navigate", url=address)

    def evaluate(self, expression, timeout=120):
        """The value of an expression, awaited."""
        answer = self.call("Runtime.evaluate", timeout, expression=expression, awaitPromise=True, returnByValue=True,
                           userGesture=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise RuntimeError(details.get("exception", {}).get("description") or details["text"])
        return answer["result"].get("value")

    def until(self, expression, what, timeout=60):
        """Waits until an expression holds, and returns its value."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            value = self.evaluate("(() => { try { return %s; } catch { return false; } })()" % expression)
            if value:
                return value
            time.sleep(0.1)
        raise TimeoutError("waited in vain for " + what)

    def key(self, name, shift=False):
        """A key that is pressed and let go."""
        code, text = k_keys.get(name, (ord(name.upper()[0]), name))
        common = {"key": name, "code": name if len(name) > 1 else "", "windowsVirtualKeyCode": code, "modifiers": 8 if shift else 0}
        self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", text=text, **common)
        self.call("Input.dispatchKeyEvent", type="keyUp", **common)

    def type(self, text):
        for letter in text:
            self.key(letter)

    def pointer(self, kind, x, y, held=True):
        """kind: mousePressed, mouseMoved, mouseReleased."""
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left" if held else "none",
                  buttons=1 if held and kind != "mouseReleased" else 0, clickCount=1)

    def drag(self, begin, end, steps=8):
        self.pointer("mouseMoved", *begin, held=False)
        self.pointer("mousePressed", *begin)
        for k in range(1, steps + 1):
            self.pointer("mouseMoved", *(a + (b - a) * k / steps for a, b in zip(begin, end)))
        self.pointer("mouseReleased", *end)

    def screenshot(self, path, whole=False):
        # All pictures that the page has asked for come first.
        answer = self.call("Page.captureScreenshot", 600, format="png", captureBeyondViewport=whole)
        with open(path, "wb") as stream:
            stream.write(base64.b64decode(answer["data"]))

    def errors(self):
        """What the page's console has said of errors."""
        found = [e["params"]["exceptionDetails"].get("exception", {}).get("description", "") for e in self.events
                 if e.get("method") == "Runtime.exceptionThrown"]
        return found + [e["params"]["entry"]["text"] for e in self.events
                        if e.get("method") == "Log.entryAdded" and e["params"]["entry"]["level"] == "error"]

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.out)
        os.close(self.inward)
        self.profile.cleanup()
