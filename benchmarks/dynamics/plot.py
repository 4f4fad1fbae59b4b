#!/usr/bin/env python3
"""Draws what error_vs_time measured: python3 plot.py TABLE.csv [PICTURE.png]

Error against CPU time, one panel for each motion, one line for each method; and on standard output the table of
docs/dynamics.md. Needs matplotlib: Debian's python3-matplotlib, or
    python3 -m venv /tmp/plot && /tmp/plot/bin/pip install matplotlib
"""
import csv
import math
import sys

METHODS = {  # colour, marker, label
    "bullet": ("#d62728", "v", "Bullet's stepping, default settings"),
    "bullet-tuned": ("#ff9f1c", "^", "Bullet's stepping, best settings"),
    "step": ("#1f5fbf", "o", "drt, step by step"),
    "controller": ("#111111", "*", "drt, controlled"),
}
EXACT = 1e-15  # smaller errors are drawn here
LOST = 1e3  # larger ones (and those that are no number) here


def read(path):
    panels = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["motion"] == "break" and float(row["error"]) == 0:
                continue  # the very run that is the truth
            panels.setdefault((row["motion"], row["variant"]), {}).setdefault(row["method"], []).append(row)
    return panels


def error_of(row):
    error = float(row["error"])
    return min(max(error, EXACT), LOST) if math.isfinite(error) else LOST


def describe(row):
    setting = float(row["setting"])
    return f"tol. {setting:g}" if row["method"] == "controller" else f"1/{1 / setting:.0f} s"


def best(rows):
    """Of the smallest error; of those that are as good, the cheapest."""
    least = min(error_of(r) for r in rows)
    return min((r for r in rows if error_of(r) <= 1.1 * least), key=lambda r: float(r["milliseconds"]))


def print_table(panels):
    print("| motion | drt, step 1/96 s | drt, controlled | Bullet, default | Bullet, best settings |")
    print("| --- | --- | --- | --- | --- |")
    for (motion, variant), methods in panels.items():
        cells = [f"{motion}: {variant}"]
        if motion == "break":
            cells[0] += f", until {float(methods['step'][0]['until']):.3g} s"
        for method in ("step", "controller", "bullet", "bullet-tuned"):
            rows = methods.get(method, [])
            if method == "step":
                rows = [r for r in rows if abs(float(r["setting"]) * 96 - 1) < 1e-3]
            if not rows:
                cells.append("")
                continue
            row = best(rows)
            at = "" if method == "step" else f" ({describe(row)})"
            cells.append(f"{float(row['error']):.1e}, {float(row['milliseconds']):.3g} ms{at}")
        print("| " + " | ".join(cells) + " |")


def draw(panels, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    columns = 3
    rows = -(-len(panels) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(10, 2.35 * rows + 0.7), sharex=True,
                                 sharey=True)
    for axis, ((motion, variant), methods) in zip(axes.flat, panels.items()):
        for method, (colour, marker, _) in METHODS.items():
            points = methods.get(method, [])
            axis.loglog([float(r["milliseconds"]) for r in points], [error_of(r) for r in points], color=colour,
                        marker=marker, markersize=8 if marker == "*" else 4.5, linewidth=1.2,
                        linestyle="none" if method == "controller" else "-")
        axis.set_title(f"{motion}: {variant}", fontsize=9)
        axis.set_ylim(EXACT / 3, LOST * 3)
        axis.set_yticks([10.0**k for k in range(-15, 4, 3)])
        axis.set_yticks([], minor=True)
        axis.set_xlim(0.8, 8000)
        axis.set_xticks([1, 10, 100, 1000], ["1", "10", "100", "1000"])
        axis.set_xticks([], minor=True)
        axis.grid(True, alpha=0.3)
        axis.tick_params(labelsize=8)
    for axis in axes.flat[len(panels):]:
        axis.axis("off")
    for axis in axes[:, 0]:
        axis.set_ylabel("error / radius", fontsize=8)
    for axis in axes.flat[max(0, len(panels) - columns):len(panels)]:
        axis.set_xlabel("CPU time / ms", fontsize=8)
        axis.xaxis.set_tick_params(labelbottom=True)
    handles = [pyplot.Line2D([], [], color=c, marker=m, linestyle="none" if k == "controller" else "-", label=label)
               for k, (c, m, label) in METHODS.items()]
    figure.legend(handles=handles, loc="upper center", ncol=4, fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.35 / figure.get_figheight()))
    figure.savefig(path, dpi=90, pil_kwargs={"optimize": True})


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    panels = read(sys.argv[1])
    print_table(panels)
    if len(sys.argv) == 3:
        draw(panels, sys.argv[2])


if __name__ == "__main__":
    main()
