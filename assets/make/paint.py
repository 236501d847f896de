"""Grey canvases to paint textures on. Values are linear, 0 to 1; (0, 0) is the lower left corner, as in an OBJ file."""

from array import array
from math import exp

from png import write_png


class Canvas:
    def __init__(self, width, height, value=0.0):
        self.width, self.height = width, height
        self.data = array("f", [value]) * (width * height)

    def save(self, path):
        flipped = (self.data[y * self.width:(y + 1) * self.width] for y in range(self.height - 1, -1, -1))
        write_png(path, self.width, self.height, bytes(max(0, min(255, int(v * 255 + 0.5))) for row in flipped for v in row))


def paint(canvases, function, box=(0.0, 0.0, 1.0, 1.0), margin=0.0):
    """Paints `box` (u0, v0, u1, v1) of several canvases of one size: function(u, v), with u and v running 0..1 across the box,
    gives a value for each. A margin around the box gets the colours of its edge, so that no filter reaches a neighbour's."""
    width, height = canvases[0].width, canvases[0].height
    xs = range(max(0, round((box[0] - margin) * width)), min(width, round((box[2] + margin) * width)))
    ys = range(max(0, round((box[1] - margin) * height)), min(height, round((box[3] + margin) * height)))
    for y in ys:
        v = max(0.0, min(1.0, ((y + 0.5) / height - box[1]) / (box[3] - box[1])))
        for x in xs:
            u = max(0.0, min(1.0, ((x + 0.5) / width - box[0]) / (box[2] - box[0])))
            for canvas, value in zip(canvases, function(u, v)):
                canvas.data[y * width + x] = value


def save_maps(canvases, folder, material):
    """Saves the diffuse, specular and emissive canvas of a material under the names that `write_mtl` gives them."""
    for canvas, kind in zip(canvases, ("diffuse", "specular", "emissive")):
        canvas.save(folder / f"{material}_{kind}.png")


def strip(distance, half_width, halo=0.0, strength=0.0):
    """The light of a glowing strip at a distance from its middle: 1 within, a soft edge, and a halo that fades over `halo`."""
    d = abs(distance)
    core = max(0.0, min(1.0, 1.5 - d / half_width)) if half_width else 0.0
    if halo and core < 1.0:
        return max(core, strength * exp(-max(0.0, d - half_width) / halo))
    return core


def noise(x, y, seed=0):
    """A repeatable value 0..1 for a pair of whole numbers."""
    n = (x * 374761393 + y * 668265263 + seed * 1442695041) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535.0
