#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Starts `openltc view` and asks it what a browser asks, and what a stranger would.

    view_server.py OPENLTC WORK

Exit code 0: all is well; 1: it is not."""

import http.client
import os
import shutil
import signal
import socket
import subprocess
import sys

k_failures = []


def check(holds, what):
    if not holds:
        k_failures.append(what)
        print("FAILED " + what)


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as stream:
        stream.write(data)


def ask(port, path, method="GET", host=None):
    """Status, headers, and text of an answer."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    connection.putrequest(method, path, skip_host=True)
    if host != "":
        connection.putheader("Host", host or "127.0.0.1:%d" % port)
    connection.endheaders()
    answer = connection.getresponse()
    data = answer.read()
    connection.close()
    return answer.status, answer.headers, data


def raw(port, text):
    """What comes for bytes that are no request."""
    data = b""
    with socket.create_connection(("127.0.0.1", port), 20) as connection:
        try:
            connection.sendall(text)
            connection.shutdown(socket.SHUT_WR)
            while part := connection.recv(4096):
                data += part
        except OSError:
            pass # it was hung up on
    return data


def refused(openltc, *arguments):
    done = subprocess.run([openltc, "view", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
    return done.returncode, done.stderr


def check_files(port, scene):
    status, headers, _ = ask(port, "/")
    check(status == 302 and headers["Location"] == "/viewer.html?watch&scene=%2Fscene%2Fa%2520room.glb", "/: %s" % headers)
    status, headers, data = ask(port, "/viewer.html?watch&scene=x")
    check(status == 200 and data == b"<p>page" and headers["Content-Type"].startswith("text/html"), "the page")
    check(headers["X-Content-Type-Options"] == "nosniff" and headers["Cross-Origin-Resource-Policy"] == "same-origin",
          "headers: %s" % headers)
    status, headers, data = ask(port, "/scene/a%20room.glb")
    check(status == 200 and data == scene and headers["Content-Type"] == "model/gltf-binary", "the scene: %s" % status)
    status, headers, data = ask(port, "/scene/textures/wood.png", "HEAD")
    check(status == 200 and headers["Content-Length"] == "3" and data == b"", "HEAD of a picture: %s" % status)
    check(ask(port, "/module/part.js")[1]["Content-Type"].startswith("text/javascript"), "the type of a module")


def check_refusals(port):
    for path in ("/scene/../secret.png", "/scene/%2e%2e/secret.png", "/scene/..%2fsecret.png", "/../secret.png",
                 "/scene/link.png", "/scene/folder/secret.png", "/scene/../../../../../../../../etc/passwd",
                 "/%2e%2e/scenes/a%20room.glb", "/scene/notes.txt", "/scene/.hidden", "/scene/../nothing"):
        status, _, data = ask(port, path)
        check(status in (403, 404) and b"secret" not in data, "%s: %d %r" % (path, status, data[:40]))
    for path in ("/scene//etc/passwd", "/scene/", "/module", "/scene/none.png", "/none"):
        check(ask(port, path)[0] in (403, 404), path)
    for path in ("/scene/%00.png", "/scene/%zz", "/scene\\..\\secret.png", "/scene/%5c..%5csecret.png"):
        check(ask(port, path)[0] == 400, path)
    for host in ("evil.example", "evil.example:%d" % port, "127.0.0.1", "127.0.0.1:1", "", "127.0.0.1.evil.example:%d" % port):
        check(ask(port, "/viewer.html", host=host)[0] == 403, "host %r" % host)
    check(ask(port, "/viewer.html", host="LOCALHOST:%d" % port)[0] == 200, "localhost")
    check(ask(port, "/viewer.html", "POST")[0] == 405, "POST")
    check(raw(port, b"hello\r\n\r\n").startswith(b"HTTP/1.1 400 "), "words that are no request")
    check(raw(port, b"GET / HTTP/1.1\r\nX: " + 40000 * b"x") == b"", "a head that does not end")
    two = b"GET /viewer.html HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nHost: evil.example\r\n\r\n" % port
    check(raw(port, two).startswith(b"HTTP/1.1 403 "), "two hosts")


def listening(port):
    """Addresses on which a port of this machine is open, of IPv4, as the kernel writes them; and whether IPv6 has it."""
    with open("/proc/net/tcp", encoding="ascii") as stream:
        lines = [line.split() for line in stream][1:]
    found = [words[1].split(":")[0] for words in lines if words[3] == "0A" and int(words[1].split(":")[1], 16) == port]
    six = ""
    if os.path.exists("/proc/net/tcp6"):
        with open("/proc/net/tcp6", encoding="ascii") as stream:
            six = stream.read()
    return found, ":%04X 0" % port in six


def main():
    openltc, work = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    shutil.rmtree(work, ignore_errors=True)
    scene, path = b"glTF of a room", work + "/scenes/a room.glb"
    write(path, scene)
    write(work + "/scenes/textures/wood.png", b"png")
    write(work + "/scenes/notes.txt", b"secret")
    write(work + "/scenes/.hidden", b"secret")
    write(work + "/secret.png", b"secret")
    write(work + "/page/viewer.html", b"<p>page")
    write(work + "/page/module/part.js", b"0")
    os.symlink(work + "/secret.png", work + "/scenes/link.png")
    os.symlink(work, work + "/scenes/folder")
    page = ["--no-open", "--page", work + "/page"]
    for arguments, words in (([work + "/none.glb"] + page, "not found"), ([work + "/scenes/notes.txt"] + page, "not a .glb"),
                             ([path, "--no-open", "--page", work], "no viewer.html")):
        code, text = refused(openltc, *arguments)
        check(code == 1 and words in text and text.count("\n") == 1, "%s: %d %s" % (arguments, code, text))
    # A copy elsewhere has no page beside it.
    shutil.copy(openltc, work + "/openltc")
    code, text = refused(work + "/openltc", path, "--no-open")
    check(code == 1 and "`make web`" in text and "--page" in text, "without a page: %d %s" % (code, text))
    with subprocess.Popen([openltc, "view", path] + page, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as tool:
        try:
            address = tool.stdout.readline().strip()
            check(address.startswith("http://127.0.0.1:") and address.endswith("/"), "the address: " + address)
            port = int(address.split(":")[2].strip("/"))
            check(listening(port) == (["0100007F"], False), "it listens on the loopback interface alone: %s" % (listening(port),))
            code, text = refused(openltc, path, "--port", str(port), *page)
            check(code == 1 and "--port" in text, "a port that is taken: " + text)
            # One who says nothing keeps nobody waiting.
            with socket.create_connection(("127.0.0.1", port)):
                check_files(port, scene)
            check_refusals(port)
            before = ask(port, "/version")[2]
            check(ask(port, "/version")[2] == before, "the version stays")
            write(path, scene + b", changed")
            check(ask(port, "/version")[2] != before, "the version changes with the file")
            check(ask(port, "/scene/a%20room.glb")[2] == scene + b", changed", "and so does the scene")
            os.remove(path)
            check(ask(port, "/version")[0] == 404 and ask(port, "/scene/a%20room.glb")[0] == 404, "a file that has gone")
        finally:
            tool.send_signal(signal.SIGINT)
            check(tool.wait(20) == -signal.SIGINT, "it ends by the signal")
    print("%d failures" % len(k_failures))
    sys.exit(1 if k_failures else 0)


if __name__ == "__main__":
    main()
