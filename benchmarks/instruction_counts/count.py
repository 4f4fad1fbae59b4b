#!/usr/bin/env python3
"""What lens, time, textures and scatter cost a scene that has none of them, in instructions.

    benchmarks/instruction_counts/count.py [--build-folder build/instruction_counts] [--list]

Builds drt-render twice, whole and with these features compiled out (DRT_BARE), renders scene.yaml with both under
valgrind, and compares how many instructions samples take: the count at 32 samples per pixel less that at 8, so that
start-up and writing the picture cancel out. Ends with code 1 if the whole build needs over 2 % more. Needs Debian's
valgrind; builds for x86-64-v3, as valgrind knows no AVX-512. --list also prints the functions that differ most.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FEWER, MORE = 8, 32  # samples per pixel
PIXELS = 160 * 120
LIMIT = 1.02


def run(*command):
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def build(folder, bare):
    run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DDRT_ARCH=x86-64-v3",
        "-DDRT_BUILD_TESTS=OFF", f"-DDRT_BARE={'ON' if bare else 'OFF'}")
    run("cmake", "--build", folder, "--target", "drt-render")
    return folder / "bin/drt-render"


def count(program, folder, spp):
    """Instructions by function. One thread: they are the same in every run but for a few."""
    profile = folder / f"callgrind-{spp}.out"
    run("valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, HERE / "scene.yaml", "-o",
        folder / "counted.exr", "--spp", spp, "--threads", 1, "--quiet")
    listing = run("callgrind_annotate", "--threshold=100", profile)
    counts = collections.Counter()
    for line in listing.splitlines():
        found = re.match(r"\s*([\d,]+) \(.*?%\)\s+(?:[^:]*:)?(.*?)(?: \[.*\])?$", line)
        if found:
            counts[found.group(2)] += int(found.group(1).replace(",", ""))
    return counts


def count_samples(program, folder):
    more, fewer = count(program, folder, MORE), count(program, folder, FEWER)
    return {name: more[name] - fewer[name] for name in more}


def print_functions(whole, bare):
    names = sorted(set(whole) | set(bare), key=lambda n: -abs(whole.get(n, 0) - bare.get(n, 0)))
    print(f"{'whole':>14} {'bare':>14} {'difference':>12}")
    for name in names[:25]:
        w, b = whole.get(name, 0), bare.get(name, 0)
        print(f"{w:14,} {b:14,} {w - b:12,}  {name[:120]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build-folder", default=ROOT / "build/instruction_counts", type=pathlib.Path)
    parser.add_argument("--list", action="store_true", help="also print the functions that differ most")
    options = parser.parse_args()
    counts = {}
    for name in ("bare", "whole"):
        folder = options.build_folder / name
        counts[name] = count_samples(build(folder, name == "bare"), folder)
    total = "PROGRAM TOTALS"
    whole, bare = counts["whole"].pop(total), counts["bare"].pop(total)
    samples = PIXELS * (MORE - FEWER)
    print(f"whole build {whole:,} instructions, {whole / samples:.0f} a sample")
    print(f"bare build  {bare:,} instructions, {bare / samples:.0f} a sample")
    print(f"ratio {whole / bare:.4f} (at most {LIMIT})")
    if options.list:
        print_functions(counts["whole"], counts["bare"])
    return 0 if whole <= LIMIT * bare else 1


if __name__ == "__main__":
    sys.exit(main())
