# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Fits: those by name are the tool's files, byte for byte; those of functions are held to them."""

import gc
import os
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import numpy as np
import openltc


def ggx(wo, wi, roughness):
    """GGX with height-correlated Smith masking, F = 1 (Heitz 2014, "Understanding the Masking-Shadowing
    Function", equation 99)."""
    a2 = max(roughness**2, 1e-4) ** 2
    h = wo + wi
    h /= np.linalg.norm(h, axis=1)[:, None]
    o, i = wo[:, 2], wi[:, 2]
    d = a2 / (np.pi * (h[:, 2] ** 2 * (a2 - 1) + 1) ** 2)
    return d / 2 / (i * np.sqrt(a2 + (1 - a2) * o * o) + o * np.sqrt(a2 + (1 - a2) * i * i))


def tool(*arguments):
    subprocess.run([os.environ["OPENLTC"], *arguments], check=True, stdout=subprocess.DEVNULL)


def read_all(folder):
    result = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as file:
            result[name] = file.read()
    return result


class OnlyDlpack:
    """An array that can do nothing but to be handed over."""

    def __init__(self, array):
        self._array = array

    def __dlpack__(self, **options):
        return self._array.__dlpack__(**options)

    def __dlpack_device__(self):
        return self._array.__dlpack_device__()


class TheTool(unittest.TestCase):
    def assert_same_files(self, arguments, name, **options):
        with tempfile.TemporaryDirectory() as ours, tempfile.TemporaryDirectory() as theirs:
            openltc.fit(**options).save(os.path.join(ours, name))
            tool("fit", *arguments, "--quiet", "-o", os.path.join(theirs, name))
            self.assertEqual(read_all(ours), read_all(theirs))
            self.assertTrue(read_all(ours))

    def test_native_table(self):
        self.assert_same_files(["--brdf", "charlie", "--size", "12"], "a.json", brdf="charlie", size=12)

    def test_layout_and_precision(self):
        self.assert_same_files(["--size", "16", "--layout", "ltc_code", "--precision", "float16"], "a.dds",
                               brdf="ggx", size=16, layout="ltc_code", precision="float16")

    def test_polynomial(self):
        self.assert_same_files(["--form", "polynomial", "--degree", "3"], "a.glsl", brdf="ggx",
                               form="polynomial", degree=3)

    def test_engine(self):
        self.assert_same_files(["--engine", "godot"], "", engine="godot")

    def test_command(self):
        done = subprocess.run([sys.executable, "-m", "openltc", "--version"], capture_output=True, text=True)
        self.assertIn(openltc.__version__, done.stdout)


class Functions(unittest.TestCase):
    def test_function_fits_as_the_library_does(self):
        own, known = openltc.fit(ggx, size=16), openltc.fit("ggx", size=16)
        # The same but for the rounding of another order of operations, which moves the fit's end.
        self.assertLess(np.abs(own.arrays[0] - known.arrays[0]).max(), 2e-3)
        self.assertAlmostEqual(own.metadata["mean_tv"], known.metadata["mean_tv"], delta=1e-4)
        self.assertEqual(own.metadata["brdf"], "ggx")
        self.assertIn("tv", str(own.report))

    def test_arrays_are_those_that_were_promised(self):
        seen = []

        def look(wo, wi, roughness):
            seen.append((wo.shape == wi.shape == (len(wi), 3), wo.dtype, type(roughness),
                         bool((wo[:, 2] > 0).all() and (wi[:, 2] > 0).all()),
                         float(np.abs(np.linalg.norm(wi, axis=1) - 1).max()), threading.get_ident()))
            return ggx(wo, wi, roughness)

        openltc.fit(look, size=4)
        for shapes, dtype, kind, above, off, thread in seen:
            self.assertTrue(shapes and above)
            self.assertEqual((dtype, kind), (np.float64, float))
            self.assertLess(off, 1e-9)
            self.assertEqual(thread, threading.get_ident())

    def test_any_array(self):
        expected = openltc.fit(ggx, size=4).arrays[0]
        for other in (lambda v: v.tolist(), lambda v: v.astype(np.float32).astype(">f8"),
                      lambda v: np.repeat(v, 2)[::2], OnlyDlpack):
            got = openltc.fit(lambda wo, wi, r: other(ggx(wo, wi, r)), size=4).arrays[0]
            self.assertLess(np.abs(got - expected).max(), 1e-2)

    def test_torch_and_jax(self):
        for library, kind in (("torch", "Tensor"), ("jax", "Array")):
            with self.subTest(library):
                try:
                    of = getattr(__import__(library), kind)
                except ImportError:
                    self.skipTest(f"{library} is not installed")

                def flat(wo, wi, roughness):
                    self.assertIsInstance(wi, of)
                    return wi[:, 2] * 0 + 0.3

                fit = openltc.fit(flat, size=4, narrow=False, arrays=library)
                self.assertLess(fit.metadata["mean_tv"], 0.01)

    def test_faults_of_functions(self):
        def fit_of(value):
            return lambda: openltc.fit(value, size=4)

        for error, words, function in (
            (ZeroDivisionError, "division", lambda wo, wi, r: 1 / 0),
            (ValueError, r"shape \(.*, 3\)", lambda wo, wi, r: wi),
            (ValueError, "shape", lambda wo, wi, r: 1.0),
            (TypeError, "complex", lambda wo, wi, r: wi[:, 0] + 1j),
            (TypeError, "None", lambda wo, wi, r: None),
            (TypeError, "<U", lambda wo, wi, r: np.full(len(wi), "much")),
            (openltc.Error, "nan .*must be finite", lambda wo, wi, r: wi[:, 0] * np.nan),
            (openltc.Error, "-0\\.99.*not negative", lambda wo, wi, r: wi[:, 0] * 0 - 1),
            (openltc.Error, "reflects nothing", lambda wo, wi, r: wi[:, 0] * 0),
            (SystemExit, "3", lambda wo, wi, r: sys.exit(3)),
            (KeyboardInterrupt, "", lambda wo, wi, r: signal.raise_signal(signal.SIGINT)),
        ):
            with self.subTest(words):
                self.assertRaisesRegex(error, words, fit_of(function))

    def test_choices_that_there_are_not(self):
        for options in ({"brdf": "gold"}, {"layout": "quake"}, {"engine": "quake"}, {"form": "three"},
                        {"size": 1}, {"size": 9999}, {"objective": "best"}, {"degree": 99},
                        {"precision": "int8"}, {"engine": "godot", "size": 4}):
            with self.subTest(options):
                self.assertRaises(openltc.Error, lambda: openltc.fit(**options))
        self.assertRaisesRegex(openltc.Error, "there.binary", lambda: openltc.fit("not/there.binary"))
        lobes = openltc.fit(size=4)
        self.assertRaisesRegex(openltc.Error, "extension|\\.tiff", lambda: lobes.save("a.tiff"))

    def test_arguments_of_other_kinds(self):
        for words, options in (("size='8'", {"size": "8"}), ("degree=4.0", {"degree": 4.0}), ("objective=3", {"objective": 3}),
                               ("name=3", {"name": 3}), ("brdf: .*NoneType", {"brdf": None}), ("engine=1", {"engine": 1})):
            with self.subTest(words):
                self.assertRaisesRegex(TypeError, words, lambda: openltc.fit(**options))
        self.assertRaisesRegex(ValueError, "UTF-8", lambda: openltc.fit("a\0.binary"))

    def test_reports_in_threads_and_in_the_function(self):
        # The function of a fit is called by several jobs at once, and within one of its own calls.
        def inner(wo, wi, roughness):
            if made and not asked:
                asked.append(True)
                texts.append(str(made[0].report))
            return ggx(wo, wi, roughness)

        made, asked, texts = [], [], []
        made.append(openltc.fit(inner, size=2))
        threads = [threading.Thread(target=lambda: texts.append(str(made[0].report))) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(texts), 3)
        self.assertEqual(len(set(texts)), 1)
        self.assertGreater(made[0].metadata["mean_tv"], 0)

    def test_nothing_is_left_behind(self):
        class Model:
            def __call__(self, wo, wi, roughness):
                return ggx(wo, wi, roughness)

        model = Model()
        model.fitted = openltc.fit(model, size=4)  # a cycle
        gone = weakref.ref(model)
        del model
        gc.collect()
        self.assertIsNone(gone())

    def test_textures(self):
        lobes = openltc.fit("ggx", size=8)
        for engine in openltc.engines():
            for texture in lobes.to_texture(engine["name"]):
                self.assertEqual(texture.shape[:2], (engine["size"],) * 2)
                self.assertEqual(texture.dtype, engine["precision"])
        np.testing.assert_array_equal(lobes.to_texture()[0], lobes.arrays[0])

    def test_progress_rises_to_one(self):
        shares = []
        openltc.fit("ggx", size=16, progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1.0)


def run_script(script):
    """What a script prints and its exit code; nothing in between, such as a crash's words."""
    paths = [os.environ["PYTHONPATH"], os.path.dirname(os.path.abspath(__file__))]
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)})


class Interruption(unittest.TestCase):
    def test_the_interpreter_ends_in_the_middle(self):
        # By its end, while daemon threads fit, shade and render; and by a function that ends the process.
        done = run_script("""
import threading, time, numpy, openltc
from test_fit import ggx
scene, points = openltc.Scene.load("scenes/demo.glb"), numpy.zeros((1 << 18, 3), "f4")
def shade():
    while True:
        openltc.shade(points, (0, 1, 0), (0, 1, 1), None, openltc.Point((0, 1, 0), 1))
for work in (lambda: openltc.fit(ggx, size=512), shade, scene.render):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.3)
print("left")
""")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "left\n", ""))
        done = run_script("import openltc, os; openltc.fit(lambda wo, wi, roughness: os._exit(7), size=2)")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (7, "", ""))

    def test_progress_is_a_bar_or_a_line(self):
        # tqdm where it is installed, and without it.
        script = "import openltc; openltc.fit('ggx', size=8, progress=True)"
        hidden = "import sys; sys.modules['tqdm'] = sys.modules['tqdm.auto'] = None\n"
        self.assertIn("fitting ggx: 100% ", run_script(hidden + script).stderr)
        try:
            import tqdm  # noqa: F401
        except ImportError:
            self.skipTest("tqdm is not installed")
        self.assertRegex(run_script(script).stderr, r"fitting ggx: +100%\|.*\|")

    def test_ctrl_c_and_other_threads(self):
        # A fit of minutes; another thread notes that it goes on, and interrupts.
        script = """
import os, signal, threading, time, openltc
def interrupt():
    for k in range(5):
        time.sleep(0.1)
    print("went on", flush=True)
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt).start()
try:
    openltc.fit("ggx", size=512, form="two-lobe")
except KeyboardInterrupt:
    print("interrupted")
"""
        done = run_script(script)
        self.assertEqual(done.stdout, "went on\ninterrupted\n", done.stderr)
