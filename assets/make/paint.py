"""Grey canvases to paint textures on. Values are linear, 0 to 1; (0, 0) is the lower left corner, as in an OBJ file."""

from array import array
from math import exp

from png import write_png


class Canvas:
    def __init__(self, width, height, value=0.0):
        self.width, self.height = width, height
        self.data = array("f", [value]) * (width * height)

    def paint(self, function, box=(0.0, 0.0, 1.0, 1.0)):
        """Sets each texel in `box` (u0, v0, u1, v1) to function(u, v, old), with u and v running 0..1 across the box."""
        x0, x1 = round(box[0] * self.width), round(box[2] * self.width)
        y0, y1 = round(box[1] * self.height), round(box[3] * self.height)
        us = [(x + 0.5 - x0) / (x1 - x0) for x in range(x0, x1)]
        for y in range(y0, y1):
            v, at = (y + 0.5 - y0) / (y1 - y0), y * self.width + x0
            for i, u in enumerate(us, at):
                self.data[i] = function(u, v, self.data[i])

    def save(self, path):
        write_png(path, self.width, self.height, 1, bytes(self._rows(lambda value: (value,))))

    def save_tinted(self, path, tint):
        """Saves the canvas times an RGB `tint`."""
        write_png(path, self.width, self.height, 3, bytes(self._rows(lambda value: [value * c for c in tint])))

    def _rows(self, texel):
        for y in range(self.height - 1, -1, -1):
            for value in self.data[y * self.width:(y + 1) * self.width]:
                for c in texel(value):
                    yield max(0, min(255, int(c * 255 + 0.5)))


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
