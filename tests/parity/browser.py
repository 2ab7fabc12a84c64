# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Shaders in a browser: Chromium without a window opens page.html from a server of Python's own library, and the
page posts what it finds. No driver protocol, no Node."""

import http.server
import json
import os
import shutil
import subprocess
import tempfile
import threading
import urllib.parse

k_here = os.path.dirname(os.path.abspath(__file__))
k_names = ("chromium", "chromium-browser", "google-chrome")

k_flags = ["--headless=new", "--no-first-run", "--disable-dev-shm-usage", "--enable-unsafe-webgpu",
           "--enable-features=Vulkan",
           # As root it starts only so; it sees no page but ours.
           "--no-sandbox"]
# Where there is no graphics processor, or none is asked for: SwiftShader, which Chromium brings.
k_software = ["--use-webgpu-adapter=swiftshader", "--use-vulkan=swiftshader", "--use-angle=swiftshader",
              "--enable-unsafe-swiftshader"]
k_hardware = ["--use-angle=vulkan", "--ignore-gpu-blocklist"]


def find():
    """The browser's program, or None. A snap of that name cannot read our profile's folder."""
    for name in k_names:
        path = shutil.which(name)
        if path and not os.path.realpath(path).startswith("/snap"):
            return path
    return None


def make_handler(folder, jobs, answers, done):
    class Handler(http.server.BaseHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def reply(self, content, kind="application/octet-stream"):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def do_GET(self):
            if self.path == "/":
                with open(os.path.join(k_here, "page.html"), "rb") as page:
                    self.reply(page.read(), "text/html")
            elif self.path == "/jobs":
                self.reply(json.dumps(jobs).encode(), "application/json")
            elif self.path.startswith("/data/"):
                with open(os.path.join(folder, os.path.basename(self.path)), "rb") as data:
                    self.reply(data.read())
            else:
                self.send_error(404)

        def do_POST(self):
            query = dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(self.path).query))
            data = self.rfile.read(int(self.headers["Content-Length"]))
            if data:
                with open(os.path.join(folder, os.path.basename(query["name"]) + ".bin"), "wb") as out:
                    out.write(data)
            answers[query["name"]] = json.loads(query["facts"])
            self.reply(b"")
            if query["name"] == "done":
                done.set()

    return Handler


def run(program, folder, jobs, hardware=False, timeout=300):
    """Runs jobs, whose files are in `folder`, where their results go as NAME.bin. Returns what the page posted,
    name -> facts, among them "webgpu" and "webgl2", and "done" if it came to its end."""
    answers, done = {}, threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), make_handler(folder, jobs, answers, done))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(prefix="openltc_browser_", ignore_cleanup_errors=True) as profile:
        command = ([program] + k_flags + (k_hardware if hardware else k_software)
                   + ["--user-data-dir=" + profile, "http://127.0.0.1:%d/" % server.server_port])
        # A session of its own, since its own processes are many.
        browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            for _ in range(int(timeout * 5)):
                if done.wait(0.2) or browser.poll() is not None:
                    break
        finally:
            browser.terminate()
            try:
                browser.wait(10)
            except subprocess.TimeoutExpired:
                browser.kill()
                browser.wait()
            server.shutdown()
            server.server_close()
    return answers
