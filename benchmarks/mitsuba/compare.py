#!/usr/bin/env python3
"""Renders the scenes of this folder with drt and with Mitsuba 3 and asks whether the pictures are the same.

    python3 -m venv /tmp/mitsuba && /tmp/mitsuba/bin/pip install -r benchmarks/mitsuba/requirements.txt
    /tmp/mitsuba/bin/python benchmarks/mitsuba/compare.py build/release/bin/drt-render

Both render every scene several times, with seeds that are fixed, so that each picture comes with its own standard error. The
questions are those of tests/support/compare.h: is one block of pixels off, are many slightly off, is the whole picture off.
With probability alpha (per run, over all scenes and questions) equal renderers are called different. Then the same comparison
must find drt's picture different when it is made 1 % brighter, or moved by a quarter of a pixel.

Exit code: 0 the same, 1 different (or a planted fault not found), 2 could not compare.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import mitsuba as mi
import numpy as np
from scipy import stats

mi.set_variant("scalar_rgb")

from translate import load, mitsuba_scene  # noqa: E402  (needs the variant)

FOLDER = Path(__file__).resolve().parent
SCENES = ["point", "rectangle", "sphere", "together"]
BLOCKS = [8, 4]  # pixels along a side
RELATIVE, ABSOLUTE = 1e-5, 1e-7  # differences up to this are rounding (both keep pictures as floats)


def read_rgb(path):
    bitmap = mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, srgb_gamma=False)
    return np.array(bitmap, dtype=float)


def render_drt(program, path, replicates, spp):
    pictures = []
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.exr"
        for seed in range(1, replicates + 1):
            subprocess.run([program, path, "-o", out, "--spp", str(spp), "--seed", str(seed), "-q"], check=True)
            pictures.append(read_rgb(out))
    return np.stack(pictures)


def render_mitsuba(path, replicates, spp):
    scene = mitsuba_scene(load(path))
    return np.stack([np.array(mi.render(scene, spp=spp, seed=seed), dtype=float) for seed in range(1, replicates + 1)])


def block_means(pictures, size):
    n, height, width, channels = pictures.shape
    rows, columns = height // size, width // size
    cut = pictures[:, :rows * size, :columns * size]
    return cut.reshape(n, rows, size, columns, size, channels).mean(axis=(2, 4))


def scores(a, b):
    """Normal scores of the differences of the means of two sets of replicates: Welch's t, mapped through its p-value."""
    mean_a, mean_b = a.mean(0), b.mean(0)
    va, vb = a.var(0, ddof=1) / len(a), b.var(0, ddof=1) / len(b)
    variance = va + vb
    tolerance = ABSOLUTE + RELATIVE * np.maximum(np.abs(mean_a), np.abs(mean_b))
    beyond = np.maximum(np.abs(mean_a - mean_b) - tolerance, 0) * np.sign(mean_a - mean_b)
    with np.errstate(divide="ignore", invalid="ignore"):
        freedom = variance**2 / (va**2 / (len(a) - 1) + vb**2 / (len(b) - 1))
        t = beyond / np.sqrt(variance)
    z = np.sign(t) * stats.norm.isf(np.maximum(stats.t.sf(np.abs(t), freedom), 1e-300))
    return np.where(beyond == 0, 0.0, np.where(variance == 0, np.copysign(np.inf, beyond), z))


def questions(drt, mitsuba, alpha):
    """(what was asked, the score, the limit) for each question; alpha is shared evenly.

    Sums are for each channel by itself: the noise of one sample is in all channels."""
    share = alpha / (4 * len(BLOCKS) + 1)
    asked = []
    for size in BLOCKS:
        z = scores(block_means(drt, size), block_means(mitsuba, size))
        limit = stats.norm.isf(-np.expm1(np.log1p(-share) / z.size) / 2)  # Sidak
        y, x, channel = np.unravel_index(np.argmax(np.abs(z)), z.shape)
        asked.append((f"worst of {z.size} blocks of {size}x{size}: x {x * size} y {y * size}, {'rgb'[channel]}",
                      np.abs(z).max(), limit))
        for channel in range(3):
            noisy = z[..., channel][z[..., channel] != 0]  # blocks where nothing is to be seen have no score
            asked.append((f"sum of z^2 over {noisy.size} blocks of {size}x{size}, {'rgb'[channel]}", np.sum(noisy**2),
                          stats.chi2.isf(share, noisy.size)))
    z = scores(drt.mean(axis=(1, 2)), mitsuba.mean(axis=(1, 2)))
    asked.append(("mean of the picture", np.abs(z).max(), stats.norm.isf(share / 6)))
    return asked


def same(asked):
    return all(score <= limit for _, score, limit in asked)


def planted_faults(drt):
    yield "1 % brighter", drt * 1.01
    yield "moved by 1/4 pixel", 0.75 * drt + 0.25 * np.roll(drt, 1, axis=2)


def compare(name, arguments, alpha):
    path = FOLDER / "scenes" / f"{name}.yaml"
    drt = render_drt(arguments.drt_render, path, arguments.replicates, arguments.spp)
    mitsuba = render_mitsuba(path, arguments.replicates, arguments.spp)
    if drt.shape != mitsuba.shape:
        raise ValueError(f"sizes differ: {drt.shape} and {mitsuba.shape}")
    asked = questions(drt, mitsuba, alpha)
    good = same(asked)
    print(f"{name}: {'the same' if good else 'DIFFERENT'} (means {drt.mean():.5f} and {mitsuba.mean():.5f})")
    for what, score, limit in asked:
        print(f"  {'ok ' if score <= limit else 'BAD'} {score:10.2f} of at most {limit:8.2f}: {what}")
    for fault, faulty in planted_faults(drt):
        found = not same(questions(faulty, mitsuba, alpha))
        print(f"  {'ok ' if found else 'BAD'} planted fault {'' if found else 'not '}found: {fault}")
        good = good and found
    if arguments.keep:
        for who, pictures in ("drt", drt), ("mitsuba", mitsuba):
            mi.Bitmap(pictures.mean(0).astype(np.float32)).write(str(Path(arguments.keep) / f"{name}-{who}.exr"))
    return good


def main():
    parser = argparse.ArgumentParser(description="drt and Mitsuba 3 side by side (see the head of this file)")
    parser.add_argument("drt_render", help="path of drt-render")
    parser.add_argument("--replicates", type=int, default=16, help="pictures by each (%(default)s)")
    parser.add_argument("--spp", type=int, default=64, help="samples per pixel of each (%(default)s)")
    parser.add_argument("--alpha", type=float, default=1e-4, help="probability of a false alarm (%(default)s)")
    parser.add_argument("--keep", metavar="FOLDER", help="write the mean pictures there, as EXR")
    arguments = parser.parse_args()
    print(f"Mitsuba {mi.__version__} ({mi.variant()}), {arguments.replicates} pictures of {arguments.spp} samples per "
          f"pixel by each, alpha {arguments.alpha:g}")
    try:
        good = [compare(name, arguments, arguments.alpha / len(SCENES)) for name in SCENES]
    except (OSError, ValueError, RuntimeError, subprocess.CalledProcessError) as fault:
        print(f"error: {fault}", file=sys.stderr)
        return 2
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
