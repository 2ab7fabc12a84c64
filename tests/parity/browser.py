# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Pages in a browser: Chromium without a window opens a page from a server of Python's own library, and the page
posts what it finds. No driver protocol, no Node."""

import http.server
import json
import mimetypes
import os
import shutil
import subprocess
import tempfile
import threading
import urllib.parse

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


def make_handler(page_file, folder, jobs, answers, done, root):
    class Handler(http.server.BaseHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def reply(self, content, kind="application/octet-stream"):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def reply_file(self, path):
            with open(path, "rb") as data:
                self.reply(data.read(), mimetypes.guess_type(path)[0] or "application/octet-stream")

        def do_GET(self):
            if self.path == "/":
                self.reply_file(page_file)
            elif self.path == "/jobs":
                self.reply(json.dumps(jobs).encode(), "application/json")
            elif self.path.startswith("/data/"):
                self.reply_file(os.path.join(folder, os.path.basename(self.path)))
            elif root and ".." not in self.path and os.path.isfile(root + self.path.split("?")[0]):
                self.reply_file(root + self.path.split("?")[0])
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


def run(program, page, folder, jobs, root=None, hardware=False, timeout=300):
    """Opens `page`, which finds jobs at /jobs, their files, those of `folder`, below /data, and all others below
    `root`, if there is one. Their results go to `folder` as NAME.bin. Returns what the page posted, name -> facts,
    and "done" if it came to its end."""
    answers, done = {}, threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), make_handler(page, folder, jobs, answers, done, root))
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
