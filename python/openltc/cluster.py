# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Sequences, large pictures and many fits, on this machine or on the workers of a Dask cluster.

    pip install "openltc[cluster]"

Every function takes `client`: None works here, one task after the other; a distributed.Client, or the
address of a scheduler, has its workers do it. Workers must see the same folders under the same paths
and have the same version of openltc. The bytes of the files do not depend on who makes them, as long
as the processors have the same instruction set, which picks the shading kernel.

What is made is written whole or not at all, by the worker. A folder .openltc beside the files says
what each was made of: what is there and made of the same is left as it is. A worker that is lost costs
the time of its task, which another does again. What fails is named at the end, in an Unfinished; all
else is done by then.
"""

from __future__ import annotations

import os
import shutil
import threading
from typing import Any, Callable, Iterable, Mapping

import numpy as np

from . import _made, _many, _openltc, _tool
from ._fit import _over_arrays, fit
from ._many import Unfinished
from ._picture import Picture, read
from ._scene import Scene

__all__ = ["Unfinished", "fit_many", "render_sequence", "render_tiles"]

_local = threading.local()


def render_sequence(scene: str | os.PathLike[str], frames: str | Iterable[int], output: str | os.PathLike[str], *,
                    fps: float = 24, animation: str = "",
                    pose: Callable[[Scene, int], Mapping[str, Any] | None] | None = None,
                    client: Any = None, progress: bool | Callable[[float], Any] = False,
                    **options: Any) -> list[str]:
    """Renders frames of a scene to files; returns their paths, in order.

    scene    a .glb or .gltf
    frames   "1-240", "1-240x10", "1-24,48", or whole numbers
    output   the path of a frame, #### where its number goes: .exr, .hdr; .png with ev100=
    fps      frame N shows the animation of the file, by its name or number, at N / fps seconds
    pose     a function of the scene at that time and the number of the frame, which changes its lights,
             cameras and materials; it may return options of Scene.render for this frame, such as
             a camera. It is called by the workers, on a scene of its own for every frame
    client   None, a distributed.Client, or the address of a scheduler
    options  those of Scene.render; ev100 and half of Picture.save

    Without `pose` the frames are the files of `openltc render --frames`, byte for byte, and are known to
    be made by both. With it a frame is made again when what the function made of the scene is other
    than it was.

    Raises Unfinished at the end for frames that failed; openltc.Error at once for what concerns all.
    """
    scene, output = os.path.abspath(os.fspath(scene)), os.path.abspath(os.fspath(output))
    wanted = _tool.numbers(frames)
    if pose is None:
        if wanted:
            _tool.render_missing(_arguments(scene, output, fps, animation, options), _many.ranges(wanted),
                                 os.path.dirname(output), client, progress)
    else:
        if "#" not in os.path.basename(output):
            raise _openltc.Error(f"{output}: #### is wanted in the file's name, where the number of the frame goes")
        if output.lower().endswith(".png") and options.get("ev100") is None:
            raise _openltc.Error(f"{output}: give ev100=, or the exposure changes from frame to frame")
        common = {"scene": scene, "output": output, "fps": fps, "animation": animation, "pose": pose,
                  "options": options}
        _many.run({n: n for n in wanted}, _posed_frame, common, client, progress, f"rendering {len(wanted)} frames",
                  "frame")
    return [_tool.path_of_frame(output, n) for n in wanted]


def _arguments(scene, output, fps, animation, options):
    """What `openltc render` has for these."""
    arguments = [scene, "-o", output, "--fps", repr(fps)]
    if animation:
        arguments += ["--animation", animation]
    options = dict(options)
    width, height = options.pop("width", 1280), options.pop("height", 720)
    arguments += ["--size", f"{width}x{height}"]
    if options.pop("half", False):
        arguments.append("--half")
    if options.get("threads") == 0:
        del options["threads"]
    for name, value in options.items():
        name = {"background_nits": "background", "ev100": "exposure"}.get(name, name)
        if name not in ("integrator", "samples", "shadow_samples", "camera", "lights", "lobes", "specular", "filter",
                        "light_error", "background", "exposure", "seed", "threads"):
            raise TypeError(f"{name}: not an option of render_sequence without pose=")
        if name == "camera" and not isinstance(value, (str, int)):
            raise TypeError("camera: a name or number is wanted; give a Camera by pose=")
        if value is None or (value == "auto" and name in ("lobes", "specular", "lights")) or value == "":
            continue
        if name == "camera" and value == "auto":
            value = "frame"
        text = ",".join(map(repr, value)) if isinstance(value, (tuple, list)) else str(value)
        arguments.append(f"--{name.replace('_', '-')}={text}")
    return arguments


def _posed_frame(frame, *, scene, output, fps, animation, pose, options, threads):
    """One frame of a scene that a function poses."""
    loaded = Scene.load(scene, time_seconds=frame / fps, animation=animation)
    options = {**options, **(pose(loaded, frame) or {})}
    inputs = _made.fingerprint(
        _openltc.__version__, _made.digest_of_files(loaded._lower.files, os.path.dirname(scene)), frame / fps, animation,
        loaded.lights, loaded.cameras, loaded.materials, _of_picture(options))
    path = _tool.path_of_frame(output, frame)
    if _made.look_up(path, inputs) is None:
        saving = {name: options.pop(name) for name in ("ev100", "half") if name in options}
        loaded.render(**{"threads": threads, **options}).save(path, **saving)
        _made.record(path, inputs, [path])


def _of_picture(options):
    """Without what changes no pixel."""
    return {name: value for name, value in options.items() if name not in ("threads", "progress")}


def render_tiles(scene: str | os.PathLike[str], output: str | os.PathLike[str], *, width: int, height: int,
                 tile: int = 1024, time_seconds: float | None = None, animation: str = "",
                 client: Any = None, progress: bool | Callable[[float], Any] = False, **options: Any) -> str:
    """Renders one large picture in tiles of `tile` x `tile` pixels, a multiple of 16; returns its path.

    Tiles that are done are kept in .openltc/NAME.tiles beside the picture until it is whole, so that
    the next call goes on where one was stopped. The file is that of `openltc render --size`, byte for
    byte. It is put together here: 28 bytes a pixel of memory, 40 with the reference's standard error.

    options  those of Scene.render; ev100 and half of Picture.save
    The others are those of render_sequence and Scene.load.
    """
    scene, output = os.path.abspath(os.fspath(scene)), os.path.abspath(os.fspath(output))
    if tile < 16 or tile % 16:
        raise ValueError(f"tile={tile}: a multiple of 16 pixels is wanted")
    if min(width, height) < 1:
        raise ValueError(f"{width} x {height} pixels: each side must be 1 or more")
    saving = {name: options.pop(name) for name in ("ev100", "half") if name in options}
    posing = {"time_seconds": time_seconds, "animation": animation}
    loaded = Scene.load(scene, **posing)
    inputs = _made.fingerprint(
        _openltc.__version__, _made.digest_of_files(loaded._lower.files, os.path.dirname(scene)), posing, width, height,
        _of_picture(options))
    whole = _made.fingerprint(inputs, saving)
    if _made.look_up(output, whole):
        return output
    parts = os.path.join(os.path.dirname(output), ".openltc", os.path.basename(output) + ".tiles")
    windows = {(x, y): (x, y, min(x + tile, width), min(y + tile, height))
               for y in range(0, height, tile) for x in range(0, width, tile)}
    paths = {name: os.path.join(parts, f"{name[0]}-{name[1]}-{tile}.exr") for name in windows}
    missing = {name: (window, paths[name]) for name, window in windows.items()
               if _made.look_up(paths[name], inputs) is None}
    os.makedirs(parts, exist_ok=True)
    common = {"scene": scene, "posing": posing, "inputs": inputs,
              "options": {"width": width, "height": height, **options}}
    _many.run(missing, _tile, common, client, progress, f"rendering {len(missing)} tiles", "tile")
    radiance, errors = np.empty((height, width, 3), np.float32), None
    if options.get("integrator") == "reference" and options.get("samples") != 1:
        errors = np.empty_like(radiance)
    for name, (x0, y0, x1, y1) in windows.items():
        radiance[y0:y1, x0:x1] = read(paths[name])
        if errors is not None:
            errors[y0:y1, x0:x1] = read(paths[name], "stderr")
    Picture(radiance, {} if errors is None else {"stderr": errors}).save(output, **saving)
    _made.record(output, whole, [output])
    shutil.rmtree(parts)
    return output


def _tile(task, *, scene, posing, inputs, options, threads):
    """One tile of a picture, as a file of its own."""
    window, path = task
    facts = os.stat(scene)
    key = (inputs, facts.st_mtime_ns, facts.st_size)
    if getattr(_local, "key", None) != key:  # the next tile of this thread has the same scene
        _local.key, _local.scene = None, Scene.load(scene, **posing)
        _local.key = key
    _local.scene.render(**{"threads": threads, **options}, window=window).save(path)
    _made.record(path, inputs, [path])


def fit_many(brdfs: Mapping[str, Any] | Iterable[str], output: str | os.PathLike[str], *, client: Any = None,
             progress: bool | Callable[[float], Any] = False, **options: Any) -> dict[str, dict[str, Any]]:
    """Fits lobes to many BRDFs and writes them; returns by name what Fit.metadata says of each.

    brdfs    {name: brdf}, where brdf is what openltc.fit takes: a name, the path of a measured material,
             a function over arrays; or names and paths alone, which are called by the name of the file
    output   the path of a table, with {name}: "tables/{name}.ktx2"; any that Fit.save takes
    options  those of openltc.fit

    A fit is made again when its options, the file's bytes, or the function's values in 192 fixed pairs of
    directions are others than they were.
    """
    output = os.path.abspath(os.fspath(output))
    if "{name}" not in os.path.basename(output):
        raise _openltc.Error(f"{output}: {{name}} is wanted in the file's name, where the name of the BRDF goes")
    if not isinstance(brdfs, Mapping):
        brdfs = {os.path.splitext(os.path.basename(b))[0]: b for b in map(os.fspath, brdfs)}
    tasks, done = {}, {}
    for name, brdf in brdfs.items():
        if not callable(brdf):
            brdf = os.fspath(brdf)
            brdf = os.path.abspath(brdf) if os.path.exists(brdf) else brdf
        path = output.replace("{name}", name)
        try:
            inputs = _made.fingerprint(_openltc.__version__, name, _known_by(brdf, options), options)
        except Exception:  # the fit says what is wrong with it, when the others are done
            inputs = None
        made = inputs and _made.look_up(path, inputs)
        if made:
            done[name] = made["about"]
        else:
            tasks[name] = (name, brdf, path, inputs)
    done.update(_many.run(tasks, _fit, {"options": options}, client, progress, f"fitting {len(tasks)} BRDFs", "fit"))
    return {name: done[name] for name in brdfs}


def _known_by(brdf, options):
    """What tells a BRDF from another: of a function its values."""
    if not callable(brdf):
        return (brdf, _made.digest_of_file(brdf)) if os.path.exists(brdf) else brdf
    random = np.random.Generator(np.random.PCG64(1))
    z, angle = random.uniform(0.02, 1, (2, 64)), random.uniform(0, 2 * np.pi, (2, 64))
    across = np.sqrt(1 - z * z)
    wo, wi = np.stack([across * np.cos(angle), across * np.sin(angle), z], -1)
    function = _over_arrays(brdf, options.get("arrays", "numpy"))
    return [function(wo.copy(), wi.copy(), roughness) for roughness in (0.1, 0.4, 1.0)]


def _fit(task, *, options, threads):
    """One fit, on all cores: it takes no number of threads."""
    name, brdf, path, inputs = task
    lobes = fit(brdf, **{"name": name, **options}) if callable(brdf) else fit(brdf, **options)
    return _made.record(path, inputs, lobes.save(path), lobes.metadata)["about"]
