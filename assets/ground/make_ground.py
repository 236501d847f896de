"""Makes ground.obj, ground.mtl and their textures, beside this script: `python3 make_ground.py`.

The plane y = 0 from -22.4 to 22.4 in x and z. Its texture coordinates run 0..1; repeated 64 times, one tile is a cell of 0.7.
"""

import sys
from math import exp
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "make"))

from material import write_mtl  # noqa: E402
from mesh import Part  # noqa: E402
from model import save_model  # noqa: E402
from paint import Canvas, noise, paint, save_maps  # noqa: E402

HALF = 22.4
QUADS = 16  # a side: the vectors to the lights are interpolated over quads of 2.8, not over the whole plane
SIZE = 256  # texels a side of each texture

LINE, EDGE, HALO = 0.009, 0.008, 0.05  # of a cell: half the line, its soft edge, the reach of its glow


def main():
    write_mtl(HERE / "ground.mtl", {"ground": 60})
    maps = [Canvas(SIZE, SIZE) for _ in range(3)]
    paint(maps, lambda u, v: (diffuse(u, v), specular(u, v), emissive(u, v)))
    save_maps(maps, HERE, "ground")
    box = (-HALF, 0.0, -HALF), (HALF, 0.0, HALF)
    save_model(HERE / "ground.obj", "ground.mtl", [make_plane()], *box, (2 * QUADS ** 2,) * 2, closed=False)


def make_plane():
    part = Part("ground")
    steps = [i / QUADS for i in range(QUADS + 1)]
    rows = [[((2 * u - 1) * HALF, 0.0, (1 - 2 * v) * HALF) for u in steps] for v in steps]
    part.grid(rows, [[(u, v) for u in steps] for v in steps])
    return part


def border(u, v):
    """The distances to the nearest vertical and horizontal border of the tile: the grid's lines lie there."""
    return min(u, 1 - u), min(v, 1 - v)


def emissive(u, v):
    """A bright core with a soft edge, and a halo that adds up where lines cross."""
    glow = 0.0
    for d in border(u, v):
        core = max(0.0, min(1.0, (LINE + EDGE - d) / EDGE))
        glow += core + 0.30 * exp(-max(0.0, d - LINE) / HALO) * (1 - core)
    return min(1.0, glow)


def diffuse(u, v):
    """A tile of four plates, brushed, with dark joints and a light bevel."""
    across = min(abs(u - 0.5), abs(v - 0.5))
    joint = 0.78 if across < 0.008 else 1.08 if across < 0.016 else 1.0
    plate = 0.03 * noise(int(u * 2), int(v * 2), 3)
    grain = 0.03 * noise(int(u * SIZE), int(v * SIZE / 8), 1) + 0.02 * noise(int(u * SIZE / 2), int(v * SIZE / 2), 2)
    return (0.62 + plate + grain) * joint * (0.75 if min(border(u, v)) < LINE else 1.0)


def specular(u, v):
    """Polished plates, dull joints."""
    across = min(abs(u - 0.5), abs(v - 0.5))
    polish = 0.42 + 0.08 * noise(int(u * 2), int(v * 2), 5) + 0.08 * noise(int(u * SIZE / 4), int(v * SIZE / 4), 4)
    return polish * (0.7 if across < 0.008 else 1.0)


if __name__ == "__main__":
    main()
