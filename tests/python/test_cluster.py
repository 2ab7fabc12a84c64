# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Sequences, tiles and fits are the same files whoever makes them: this process, the tool, or two workers
of a cluster of which one is killed."""

import glob
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
import openltc
from moving_scene import k_demo, write_moving_scene

try:
    import distributed
except ImportError:
    distributed = None

k_small = dict(width=64, height=36, samples=2, shadow_samples=2)
k_small_options = ["--size", "64x36", "--samples", "2", "--shadow-samples", "2"]


def contents(paths):
    """The bytes of files by their names."""
    found = {}
    for path in paths:
        with open(path, "rb") as file:
            found[os.path.basename(path)] = file.read()
    return found


def dim(scene, frame):
    """Poses a scene: its lamps fade out."""
    scene.scale_lights(1 / (1 + frame))
    return {"background_nits": float(frame)}


def dim_or_fail(scene, frame):
    if frame == 2:
        raise LookupError("no light for this one")
    return dim(scene, frame)


def leave(scene, frame):
    """What no worker survives."""
    os.kill(os.getpid(), signal.SIGKILL)


def grey(wo, wi, roughness):
    return np.full(len(wi), 0.5 / np.pi)


def broken(wo, wi, roughness):
    raise LookupError("not measured")


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.scene = write_moving_scene(self.path("moving.glb"))

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def times(self, paths):
        return [os.stat(path).st_mtime_ns for path in paths]


class Here(Folder):
    """Without a cluster, and without Dask."""

    def test_frames_are_the_tools(self):
        subprocess.run([os.environ["OPENLTC"], "render", self.scene, *k_small_options, "--frames", "0,48", "--quiet",
                        "-o", self.path("tool.####.exr")], check=True)
        paths = openltc.cluster.render_sequence(self.scene, [0, 48], self.path("mine.####.exr"), **k_small)
        self.assertEqual([os.path.basename(p) for p in paths], ["mine.0000.exr", "mine.0048.exr"])
        self.assertEqual(list(contents(paths).values()),
                         [contents([self.path(f"tool.00{n}.exr")]).popitem()[1] for n in ("00", "48")])
        before = self.times(paths)
        openltc.cluster.render_sequence(self.scene, "0,48", self.path("mine.####.exr"), **k_small)
        self.assertEqual(self.times(paths), before)

    def test_a_function_poses_the_scene(self):
        output = self.path("a.#.exr")
        with self.assertRaises(openltc.cluster.Unfinished) as caught:
            openltc.cluster.render_sequence(self.scene, "1-3", output, pose=dim_or_fail, **k_small)
        self.assertIn("1 of 3 frames failed: 2\nframe 2: no light", str(caught.exception))
        self.assertIsInstance(caught.exception.failures[2], LookupError)
        made = [self.path("a.1.exr"), self.path("a.3.exr")]
        before = self.times(made)
        paths = openltc.cluster.render_sequence(self.scene, "1-3", output, pose=dim, **k_small)
        self.assertEqual(self.times(made), before)
        # What it is by hand.
        scene = openltc.Scene.load(self.scene, time_seconds=2 / 24)
        np.testing.assert_array_equal(openltc.read(paths[1]), scene.render(**k_small, **dim(scene, 2)))
        openltc.cluster.render_sequence(self.scene, "1-3", output, pose=lambda s, n: dim(s, min(n, 2)), **k_small)
        self.assertEqual([a == b for a, b in zip(self.times(made), before)], [True, False])

    def test_tiles_make_the_tools_picture(self):
        for more in ([], ["--integrator", "reference"]):
            subprocess.run([os.environ["OPENLTC"], "render", k_demo, "--size", "200x100", "--samples", "2",
                            "--shadow-samples", "2", "--quiet", "-o", self.path("tool.exr"), *more], check=True)
            options = dict(width=200, height=100, samples=2, shadow_samples=2, tile=64,
                           integrator=more[1] if more else "ltc")
            path = openltc.cluster.render_tiles(k_demo, self.path("tiles.exr"), **options)
            self.assertEqual(contents([path])["tiles.exr"], contents([self.path("tool.exr")])["tool.exr"])
        self.assertEqual(os.listdir(self.path(".openltc")), ["tiles.exr.made"])
        self.assertRaisesRegex(openltc.Error, "window", openltc.Scene.load(k_demo).render, 64, 64, window=(0, 0, 8, 64))

    def test_fits_that_are_there_stay(self):
        output, options = self.path("{name}.json"), dict(size=4, narrow=False, has_roughness=False)
        with self.assertRaises(openltc.cluster.Unfinished) as caught:
            openltc.cluster.fit_many({"grey": grey, "no": broken}, output, **options)
        self.assertEqual(list(caught.exception.failures), ["no"])
        before = self.times([self.path("grey.json")])
        about = openltc.cluster.fit_many({"grey": grey}, output, **options)
        self.assertLess(about["grey"]["mean_tv"], 0.01)
        self.assertEqual(self.times([self.path("grey.json")]), before)
        openltc.cluster.fit_many({"grey": lambda wo, wi, r: wi[:, 2]}, output, **options)
        self.assertNotEqual(self.times([self.path("grey.json")]), before)

    def test_wrong_words_are_told(self):
        render = openltc.cluster.render_sequence
        for words, call in (
            ("write frames as|write them as", lambda: render(self.scene, "3-", self.path("#.exr"))),
            ("no frame", lambda: render(self.scene, "3-1", self.path("#.exr"))),
            ("####", lambda: render(self.scene, "1-3", self.path("a.exr"))),
            ("####", lambda: render(self.scene, "1-3", self.path("a.exr"), pose=dim)),
            ("ev100", lambda: render(self.scene, "1-3", self.path("#.png"), pose=dim)),
            ("no animation", lambda: render(k_demo, "1-3", self.path("#.exr"))),
            ("there.glb", lambda: render("not/there.glb", "1-3", self.path("#.exr"))),
            ("no scheduler at", lambda: render(self.scene, "1", self.path("#.exr"), client="no such place")),
            ("{name}", lambda: openltc.cluster.fit_many(["ggx"], self.path("a.json"))),
        ):
            with self.subTest(words):
                self.assertRaisesRegex(openltc.Error, words, call)
        self.assertRaises(TypeError, lambda: render(self.scene, "1", self.path("#.exr"), colour="red"))
        self.assertRaises(ValueError, lambda: openltc.cluster.render_tiles(k_demo, "a.exr", width=9, height=9, tile=9))


@unittest.skipIf(distributed is None, "skipped: Dask (python/requirements/cluster.txt), which pip could not fetch")
class Cluster(Folder):
    """Two worker processes of one thread."""

    @classmethod
    def setUpClass(cls):
        # Workers start as fresh processes, which import openltc and this file.
        os.environ["PYTHONPATH"] = os.pathsep.join(
            [os.environ["PYTHONPATH"], os.path.dirname(os.path.abspath(__file__))])
        cls.cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                                               dashboard_address=None, silence_logs=50)
        cls.client = distributed.Client(cls.cluster)

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        cls.cluster.close()

    def kill_a_worker(self, pattern):
        """As soon as one file is there. Returns the thread that does it."""
        workers = list(self.client.run(os.getpid).values())

        def wait_and_kill():
            while not glob.glob(pattern):
                time.sleep(0.01)
            os.kill(workers[0], signal.SIGKILL)

        thread = threading.Thread(target=wait_and_kill)
        thread.start()
        return thread

    def test_a_killed_worker_costs_its_frame_alone(self):
        options = dict(k_small, samples=16)
        alone = openltc.cluster.render_sequence(self.scene, "1-6", self.path("one.####.exr"), **options)
        killing = self.kill_a_worker(self.path("two.*.exr"))
        shares = []
        paths = openltc.cluster.render_sequence(self.scene, "1-6", self.path("two.####.exr"), client=self.client,
                                                progress=shares.append, **options)
        killing.join()
        self.assertEqual(list(contents(paths).values()), list(contents(alone).values()))
        self.assertEqual(len(shares), 6)
        self.assertEqual(shares[-1], 1)
        self.assertEqual(glob.glob(self.path(".two*")), [])

    def test_the_command_sends_frames_to_a_cluster(self):
        command = [sys.executable, "-m", "openltc", "render", "moving.glb", *k_small_options, "-o", "c.###.exr",
                   "--fps=12"]

        def run(*more):
            done = subprocess.run([*command, *more], cwd=self.folder.name, capture_output=True, text=True)
            return done.returncode, done.stderr.splitlines()

        self.assertEqual(run("--frames", "0-5", "--quiet"), (0, []))
        alone = contents(glob.glob(self.path("c.*.exr")))
        for name in ("c.001.exr", "c.002.exr", "c.004.exr"):
            os.remove(self.path(name))
        os.mkdir(self.path("c.004.exr"))
        scheduler = ["--scheduler", self.cluster.scheduler_address]
        code, lines = run("--frames", "0-5", *scheduler)
        self.assertEqual((code, lines[-3:]), (1, [
            "2 of 6 frames made, 3 were there", "frame 4: c.004.exr: is a directory",
            "openltc render: 1 of 6 frames failed: 4"]))
        os.rmdir(self.path("c.004.exr"))
        self.assertEqual(run("--frames=0-5", f"--scheduler={scheduler[1]}", "--quiet"), (0, []))
        self.assertEqual(contents(glob.glob(self.path("c.*.exr"))), alone)
        code, lines = run("--frames", "5-1", *scheduler)
        self.assertEqual((code, len(lines)), (2, 1))

    def test_poses_tiles_and_fits_are_those_of_one_machine(self):
        for make in (
            lambda place, client: openltc.cluster.render_sequence(
                self.scene, "1-3", self.path(f"{place}.#.exr"), pose=dim, client=client, **k_small),
            lambda place, client: [openltc.cluster.render_tiles(
                k_demo, self.path(f"{place}.exr"), width=160, height=96, samples=2, tile=64, client=client)],
            lambda place, client: openltc.cluster.fit_many(
                {"grey": grey, "ggx": "ggx"}, self.path(place + "{name}.json"), size=4, narrow=False, has_roughness=False,
                client=client) and glob.glob(
                    self.path(place + "g*.json")),
        ):
            one, two = (sorted(make(place, client)) for place, client in (("one", None), ("two", self.client)))
            self.assertEqual(list(contents(one).values()), list(contents(two).values()))

    def test_what_kills_every_worker_is_named(self):
        # When the first did not survive it; Dask's own number is four.
        scheduler = self.cluster.scheduler
        self.addCleanup(setattr, scheduler, "allowed_failures", scheduler.allowed_failures)
        scheduler.allowed_failures = 0
        with self.assertRaises(openltc.cluster.Unfinished) as caught:
            openltc.cluster.render_sequence(self.scene, "1", self.path("a.#.exr"), pose=leave, client=self.client,
                                            **k_small)
        self.assertIn("frame 1", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
