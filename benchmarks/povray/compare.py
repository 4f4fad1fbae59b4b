#!/usr/bin/env python3
"""drt beside POV-Ray: time to equal error on one scene with area lights, focal blur and reflection.

    benchmarks/povray/compare.py [--drt build/release/bin/drt-render] [--out out/povray] [--threads 1]

Needs povray and oiiotool (Debian's povray and openimageio-tools) and Python's standard library; with matplotlib
(python3-matplotlib) it draws a plot as well. Renders both scenes with both programs to convergence (about ten minutes of CPU;
a reference that is in the output folder already is used again), prints how far the two programs' references are
apart, then renders the full scene at rising sample counts. Errors are against the program's own reference. Times are
CPU seconds (user and system) of the whole process, and those less the start-up (a picture of 8 x 8): with the same
number of threads for both they compare the work done, also on a machine that has other things to do.
"""
import argparse
import collections
import csv
import math
import pathlib
import re
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SIZE = (320, 240)
SCENES = {"diffuse": 0, "full": 1}  # scene file of drt, value of Full in scene.pov

# How POV-Ray is set: samples of each area light per shaded point, their adaptive level (-1: off), and what rises.
Setting = collections.namedtuple("Setting", "name grid adaptive samples variances")
SETTINGS = [
    Setting("lights 2x2", 2, -1, [4, 8, 16, 32, 64], [0]),
    Setting("lights 4x4", 4, -1, [4, 8, 16], [0]),
    Setting("lights 4x4, adaptive 0", 4, 0, [4, 8, 16, 32], [0]),
    Setting("lights 8x8, adaptive 1", 8, 1, [4, 8, 16], [0]),
    Setting("lights 2x2, blur by variance", 2, -1, [512], [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5]),
]
DRT = "drt"  # its one setting
DRT_SPP = [1, 2, 4, 8, 16, 32, 64, 128, 256]
REFERENCE = {"drt": {"diffuse": 4096, "full": 4096}, "povray": {"diffuse": 256, "full": 1024}}

ERRORS = [0.008, 0.006, 0.004, 0.003, 0.0025, 0.002]  # RMSE in linear values; the picture's mean is 0.31

Point = collections.namedtuple("Point", "program setting samples variance seconds rmse")


def cpu_seconds(command):
    """Runs a command; user and system seconds of it and its threads."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def render_drt(options, scene, picture, spp, seed, size=SIZE):
    return cpu_seconds([options.drt, HERE / f"{scene}.yaml", "-o", picture, "--resolution", "%dx%d" % size,
                        "--spp", spp, "--seed", seed, "--threads", options.threads, "--quiet"])


def render_pov(options, scene, picture, setting, samples, variance, size=SIZE):
    # Focal blur places its rays over the pixel as well, so anti-aliasing proper stays off (-A). OpenEXR holds linear
    # values; the half floats that POV-Ray writes round by 0.02 % at most, far less than the errors measured.
    return cpu_seconds(["povray", f"+I{HERE / 'scene.pov'}", f"+O{picture}", "+FE", "+W%d" % size[0], "+H%d" % size[1],
                        "-D", "-A", "-GA", f"+WT{options.threads}", f"Declare=Full={SCENES[scene]}",
                        f"Declare=Grid={setting.grid}", f"Declare=Adaptive={setting.adaptive}",
                        f"Declare=Samples={samples}", f"Declare=Variance={variance:.9f}"])


def oiiotool(*arguments):
    # --diff ends with an error code where pictures differ, which they always do here.
    return subprocess.run(["oiiotool", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True).stdout


def rmse(a, b):
    """Root of the mean square of the difference over all pixels and the channels R, G, B."""
    text = oiiotool(a, "--ch", "R,G,B", b, "--ch", "R,G,B", "--diff")
    found = re.search(r"RMS error = (\S+)", text)
    if not found:
        sys.exit(text)
    return float(found.group(1))


def mean(picture):
    text = oiiotool("--stats", picture)
    return sum(map(float, re.search(r"Stats Avg: (\S+) (\S+) (\S+)", text).groups())) / 3


def references(options):
    found = {}
    for scene in SCENES:
        for program in ("drt", "povray"):
            path = options.out / f"reference-{scene}-{program}.exr"
            samples = REFERENCE[program][scene]
            if not path.exists():
                print(f"rendering {path} ({samples} samples per pixel)", flush=True)
                partial = path.with_suffix(".part.exr")
                if program == "drt":  # another seed than the measured pictures: its error has nothing to do with theirs
                    render_drt(options, scene, partial, samples, 1)
                else:
                    render_pov(options, scene, partial, SETTINGS[0], samples, 0)
                partial.rename(path)
            found[scene, program] = path
    return found


def print_agreement(options, found):
    print("\nThe two references (linear values; whole picture, channels R, G, B):")
    for scene in SCENES:
        a, b = found[scene, "drt"], found[scene, "povray"]
        print(f"  {scene:8} mean drt {mean(a):.5f}  mean povray {mean(b):.5f}  RMS difference {rmse(a, b):.5f}")
        oiiotool(a, "--ch", "R,G,B", b, "--ch", "R,G,B", "--mosaic:pad=4", "2x1", "--colorconvert", "linear", "sRGB",
                 "-o", options.out / f"side-by-side-{scene}.png")


def sweep(options, found):
    points = []

    def add(program, setting, samples, variance, seconds, picture):
        error = rmse(picture, found["full", program])
        points.append(Point(program, setting, samples, variance, seconds, error))
        print(f"  {program:7} {setting:30} {samples:5} {variance:8g} {seconds:9.2f} {error:10.5f}", flush=True)

    print(f"\n  {'program':7} {'setting':30} {'rays':>5} {'variance':>8} {'CPU s':>9} {'RMSE':>10}")
    picture = options.out / "measured.exr"
    for spp in DRT_SPP:
        add("drt", DRT, spp, 0, render_drt(options, "full", picture, spp, 0), picture)
    for s in SETTINGS:
        for samples in s.samples:
            for variance in s.variances:
                add("povray", s.name, samples, variance, render_pov(options, "full", picture, s, samples, variance),
                    picture)
    return points


def start_up(options):
    """What each program takes for a picture of next to nothing; the least of a few runs."""
    picture, size = options.out / "measured.exr", (8, 8)
    return {"drt": min(render_drt(options, "full", picture, 1, 0, size) for _ in range(5)),
            "povray": min(render_pov(options, "full", picture, SETTINGS[0], 4, 0, size) for _ in range(5))}


def time_at(points, setting, error, start=0):
    """CPU seconds that a setting takes to an error, log-log between the measured points; None outside of them."""
    curve = sorted((p for p in points if p.setting == setting), key=lambda p: p.rmse)
    curve = [p._replace(seconds=max(p.seconds - start, 1e-3)) for p in curve]
    for a, b in zip(curve, curve[1:]):
        if a.rmse <= error <= b.rmse and b.rmse > a.rmse:
            t = math.log(error / a.rmse) / math.log(b.rmse / a.rmse)
            return math.exp(math.log(a.seconds) * (1 - t) + math.log(b.seconds) * t)
    return None


def print_ratios(points, start):
    """For each error: POV-Ray's fastest setting against drt."""
    print("\nStart-up: drt {drt:.2f} s, povray {povray:.2f} s".format(**start))
    print("Time to equal error (CPU seconds), whole and less start-up:")
    print(f"  {'RMSE':>7} {'drt':>6} {'povray':>7} {'ratio':>6} {'less start-up':>14}  povray's fastest setting")
    for error in ERRORS:
        times = [(time_at(points, s.name, error), s.name) for s in SETTINGS]
        times = sorted((seconds, name) for seconds, name in times if seconds)
        own = time_at(points, DRT, error)
        if own and times:
            seconds, name = times[0]
            rendering = time_at(points, name, error, start["povray"]) / time_at(points, DRT, error, start["drt"])
            print(f"  {error:7.4f} {own:6.2f} {seconds:7.2f} {seconds / own:6.1f} {rendering:14.1f}  {name}")


def write_files(options, points):
    with open(options.out / "points.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(Point._fields)
        writer.writerows(points)
    try:
        import matplotlib
    except ImportError:
        print("no matplotlib, no plot")
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    for name in [DRT] + [s.name for s in SETTINGS]:
        curve = [p for p in points if p.setting == name]
        pyplot.loglog([p.seconds for p in curve], [p.rmse for p in curve], marker="o",
                      label=name if name == DRT else f"POV-Ray, {name}")
    pyplot.xlabel("CPU seconds")
    pyplot.ylabel("RMSE against own reference")
    pyplot.legend()
    pyplot.grid(True, which="both", alpha=0.3)
    pyplot.savefig(options.out / "error-over-time.svg")
    print(f"wrote {options.out / 'error-over-time.svg'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = HERE.parent.parent
    parser.add_argument("--drt", default=root / "build/release/bin/drt-render", help="the drt-render to measure")
    parser.add_argument("--out", default=root / "out/povray", type=pathlib.Path, help="folder for pictures and results")
    parser.add_argument("--threads", default=1, type=int, help="of either program")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    found = references(options)
    print_agreement(options, found)
    points = sweep(options, found)
    print_ratios(points, start_up(options))
    write_files(options, points)


if __name__ == "__main__":
    main()
