#!/usr/bin/env python3
"""Make the textures of the scenes: python3 make_textures.py [NAME...]

Needs numpy and Pillow (both on PyPI). Every picture is a function of fixed seeds, so that making it again gives the
same texels. Pictures that repeat (wood, cloth, marble, tiles, checker) have no seam.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

FOLDER = Path(__file__).resolve().parent


def save(name, pixels, colors=None):
    """Write an array of sRGB values in [0, 1]; `colors`: as a palette of so many, for small files."""
    data = np.clip(np.asarray(pixels) * 255 + 0.5, 0, 255).astype(np.uint8)
    picture = Image.fromarray(data) if data.ndim == 3 else Image.fromarray(data).convert("RGB")
    if colors:
        picture = picture.quantize(colors, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.FLOYDSTEINBERG)
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    picture.save(path, **({"optimize": True} if path.suffix == ".png" else {}))


def smooth(x, low, high):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return np.asarray(a, float) * (1 - t[..., None]) + np.asarray(b, float) * t[..., None]


def noise(height, width, cells_y, cells_x, seed):
    """Smooth noise in [0, 1] that repeats at the picture's edges; cells_y x cells_x random values."""
    grid = np.random.default_rng(seed).random((cells_y, cells_x))
    y = np.arange(height)[:, None] * cells_y / height
    x = np.arange(width)[None, :] * cells_x / width
    y0, x0 = np.floor(y).astype(int), np.floor(x).astype(int)
    fy, fx = y - y0, x - x0
    fy, fx = fy * fy * (3 - 2 * fy), fx * fx * (3 - 2 * fx)
    y1, x1 = (y0 + 1) % cells_y, (x0 + 1) % cells_x
    top = grid[y0, x0] * (1 - fx) + grid[y0, x1] * fx
    bottom = grid[y1, x0] * (1 - fx) + grid[y1, x1] * fx
    return top * (1 - fy) + bottom * fy


def octaves(height, width, cells_y, cells_x, seed, count):
    total, weight = np.zeros((height, width)), 0.0
    for k in range(count):
        total += noise(height, width, cells_y << k, cells_x << k, seed + k) * 0.5**k
        weight += 0.5**k
    return total / weight


def glyphs(text, size):
    """Coverage of a number, black on white, in a square of `size` pixels; 6 and 9 are underlined."""
    picture = Image.new("L", (size, size), 255)
    draw = ImageDraw.Draw(picture)
    font = ImageFont.load_default(size * (0.86 if len(text) == 1 else 0.7))
    box = draw.textbbox((0, 0), text, font=font, stroke_width=size // 40)
    at = ((size - box[0] - box[2]) / 2, (size - box[1] - box[3]) / 2)
    draw.text(at, text, fill=0, font=font, stroke_width=size // 40, stroke_fill=0)
    if text in "69":
        draw.rectangle((size * 0.3, size * 0.89, size * 0.7, size * 0.95), fill=0)
    return np.asarray(picture, float) / 255


BALL_COLORS = {1: "#f2b705", 2: "#10389c", 3: "#c8141c", 4: "#4b1f7a", 5: "#ee6410", 6: "#0b6b36", 7: "#7d1420",
               8: "#101012"}
IVORY = "#f4efdf"


def rgb(text):
    return np.array([int(text[i:i + 2], 16) for i in (1, 3, 5)]) / 255


def half_ball(size):
    """Directions of the texels of half a turn (scale_u: 0.5), spot at the middle: x across, y up, z to the spot."""
    lon = ((np.arange(size) + 0.5) / size - 0.5) * np.pi
    lat = (0.5 - (np.arange(size) + 0.5) / size) * np.pi
    lon, lat = np.meshgrid(lon, lat)
    return np.cos(lat) * np.sin(lon), np.sin(lat), np.cos(lat) * np.cos(lon)


def billiard_ball(number, size=384):
    """A numbered ball, over half a turn: 1-7 plain, 8 black, 9-15 with a band."""
    x, y, z = half_ball(size)
    edge = 1.5 * np.pi / size
    color, ivory = rgb(BALL_COLORS[number if number <= 8 else number - 8]), rgb(IVORY)
    band = 1 - smooth(np.abs(y), 0.56 - edge / 2, 0.56 + edge / 2) if number > 8 else np.ones_like(y)
    ball = mix(ivory, color, band)
    spot = 0.4  # sine of the spot's angular radius
    inside = (1 - smooth(np.hypot(x, y), spot - edge / 2, spot + edge / 2)) * (z > 0)
    ball = mix_arrays(ball, np.broadcast_to(ivory, ball.shape), inside)
    number_size = 256
    half = spot * 0.66  # half the side of the number's square, in the same unit
    ink = glyphs(str(number), number_size)
    column = np.clip((x / half + 1) / 2 * number_size - 0.5, 0, number_size - 1)
    row = np.clip((1 - y / half) / 2 * number_size - 0.5, 0, number_size - 1)
    covered = (np.maximum(np.abs(x), np.abs(y)) < half) & (z > 0)
    black = np.where(covered, 1 - ink[np.round(row).astype(int), np.round(column).astype(int)], 0)
    save(f"ball_{number:02d}.png", mix_arrays(ball, np.broadcast_to(rgb("#18181a"), ball.shape), black), 64)


def mix_arrays(a, b, t):
    return a * (1 - t[..., None]) + b * t[..., None]


def cue_ball(size=256):
    """The white ball with red dots, over half a turn: one on the equator, one at each pole."""
    x, y, z = half_ball(size)
    edge = 2 * np.pi / size
    dot = np.maximum(1 - smooth(np.hypot(x, y) + (z < 0), 0.13 - edge / 2, 0.13 + edge / 2),
                     1 - smooth(np.hypot(x, z), 0.13 - edge / 2, 0.13 + edge / 2))
    save("ball_cue.png", mix(rgb(IVORY), rgb("#b8141a"), dot), 32)


def ball_red(width=128, height=128):
    """The texture that the 2008 manual's example names: red with a light band and dots, so that one sees it roll."""
    u = (np.arange(width) + 0.5) / width
    v = (np.arange(height) + 0.5) / height
    u, v = np.meshgrid(u, v)
    shade = 0.92 + 0.08 * octaves(height, width, 4, 4, 11, 3)
    ball = mix(rgb("#8e0d10"), rgb("#d8231c"), noise(height, width, 2, 4, 5)) * shade[..., None]
    band = smooth(0.06 - np.abs(v - 0.5), 0, 0.012)
    dots = smooth(0.09 - np.hypot((u % 0.5 - 0.25), (v - 0.5) * 0.5) * 2, 0, 0.02)
    ball = mix_arrays(ball, np.broadcast_to(rgb(IVORY), ball.shape), band)
    ball = mix_arrays(ball, np.broadcast_to(rgb("#d8231c"), ball.shape), dots)
    save("ball_red.tga", ball)
    save("../legacy/textures/ball_red.tga", ball)


def wood(size=512):
    """Floor boards: four across, staggered, each with its own tone and grain along x."""
    boards, rows = 4, size // 4
    picture = np.zeros((size, size, 3))
    random = np.random.default_rng(7)
    for b in range(boards):
        tone = 0.8 + 0.35 * random.random()
        warp = octaves(rows, size, 2, 2, 100 + 10 * b, 3)
        y = (np.arange(rows) / rows)[:, None]
        rings = 0.5 + 0.5 * np.sin(2 * np.pi * (3.0 * y + 3.2 * warp))
        fibre = octaves(rows, size, 64, 4, 200 + 10 * b, 2)
        t = np.clip(0.15 + 0.5 * rings**2 + 0.55 * (fibre - 0.5), 0, 1)
        board = mix(rgb("#b98450"), rgb("#6f4321"), t) * tone
        seam = np.minimum(np.arange(rows), rows - 1 - np.arange(rows))[:, None] + np.zeros((1, size))
        start = int(random.random() * size)
        across = np.abs((np.arange(size) - start + size // 2) % size - size // 2)[None, :]
        gap = np.minimum(smooth(seam, 0, 2.2), smooth(across + 0.0 * seam, 0.3, 2.2))
        picture[b * rows:(b + 1) * rows] = board * (0.35 + 0.65 * gap)[..., None]
    save("wood.png", picture, 96)


def walnut(size=384):
    """Dark wood without seams between boards, grain along x: rails and furniture."""
    warp = octaves(size, size, 3, 2, 31, 4)
    y = (np.arange(size) / size)[:, None]
    rings = 0.5 + 0.5 * np.sin(2 * np.pi * (9 * y + 4 * warp))
    fibre = octaves(size, size, 128, 6, 41, 2)
    save("walnut.png", mix(rgb("#6b3f22"), rgb("#2b150b"), np.clip(0.65 * rings + 0.7 * (fibre - 0.35), 0, 1)), 64)


def cloth(size=256):
    """Billiard cloth: fine wool over faint clouds."""
    rough = np.random.default_rng(3).random((size, size))
    rough = (rough + np.roll(rough, 1, 0) + np.roll(rough, 1, 1)) / 3
    t = 0.5 + 0.55 * (rough - 0.5) + 0.25 * (octaves(size, size, 4, 4, 9, 3) - 0.5)
    save("cloth.png", mix(rgb("#0a5a3a"), rgb("#178a57"), np.clip(t, 0, 1)), 48)


def checker(size=128):
    """Two by two fields, cream and slate."""
    y, x = np.mgrid[0:size, 0:size] // (size // 2)
    save("checker.png", mix(rgb("#ebe4d2"), rgb("#39424e"), ((x + y) % 2).astype(float)), 4)


def marble(size=384):
    """White marble with grey veins."""
    cloud = octaves(size, size, 3, 3, 51, 5)
    y, x = np.mgrid[0:size, 0:size] / size
    veins = np.abs(np.sin(np.pi * (x + y + 3.2 * cloud)))
    fine = np.abs(np.sin(np.pi * (2 * x - y + 4 * octaves(size, size, 4, 4, 61, 4))))
    t = np.clip(0.75 * (1 - smooth(veins, 0, 0.3)) + 0.35 * (1 - smooth(fine, 0, 0.14)) + 0.3 * cloud, 0, 1)
    save("marble.png", mix(rgb("#f3f1ec"), rgb("#6f757d"), t), 48)


def tiles(size=256):
    """Four by four glazed tiles with joints, each of a slightly different blue."""
    count = 4
    y, x = np.mgrid[0:size, 0:size] * count / size
    tone = np.random.default_rng(23).random((count, count))[y.astype(int), x.astype(int)]
    edge = np.minimum(np.minimum(x % 1, 1 - x % 1), np.minimum(y % 1, 1 - y % 1))
    glaze = mix(rgb("#1f5f86"), rgb("#4fa3b8"), np.clip(tone + 0.25 * (octaves(size, size, 8, 8, 77, 3) - 0.5), 0, 1))
    save("tiles.png", mix_arrays(np.broadcast_to(rgb("#d9d3c5"), glaze.shape), glaze, smooth(edge, 0.025, 0.05)), 64)


def label(width=512, height=192):
    """The label of a tin: the renderer's name twice around."""
    picture = Image.new("RGB", (width, height), "#c9331f")
    draw = ImageDraw.Draw(picture)
    draw.rectangle((0, 0, width, 14), fill="#efe6cf")
    draw.rectangle((0, height - 15, width, height), fill="#efe6cf")
    draw.rectangle((0, 20, width, 23), fill="#efe6cf")
    draw.rectangle((0, height - 24, width, height - 21), fill="#efe6cf")
    font = ImageFont.load_default(96)
    for k in range(2):
        box = draw.textbbox((0, 0), "drt", font=font, stroke_width=3)
        at = (width * (0.25 + 0.5 * k) - (box[0] + box[2]) / 2, height / 2 - (box[1] + box[3]) / 2)
        draw.text(at, "drt", fill="#f8f0dc", font=font, stroke_width=3, stroke_fill="#f8f0dc")
    save("label.png", np.asarray(picture) / 255, 16)


def stripes(size=128):
    """Bright vertical stripes, something for glass to show."""
    colors = ["#e9e1cc", "#d1495b", "#e9e1cc", "#00798c", "#e9e1cc", "#edae49", "#e9e1cc", "#30638e"]
    column = (np.arange(size) * len(colors)) // size
    save("stripes.png", np.broadcast_to(np.array([rgb(c) for c in colors])[column], (8, size, 3)), 8)


MAKERS = [ball_red, cue_ball, wood, walnut, cloth, checker, marble, tiles, label, stripes]


def main():
    wanted = set(sys.argv[1:])
    for maker in MAKERS:
        if not wanted or maker.__name__ in wanted:
            maker()
    if not wanted or "billiard_ball" in wanted:
        for number in range(1, 16):
            billiard_ball(number)


if __name__ == "__main__":
    main()
