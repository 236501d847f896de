"""The hubless wheels: a tyre, and within it a rim that glows."""

from math import cos, pi, sin

from shape import ring


class Wheel:
    """A wheel on the ground: the place of its centre along the bike, its radius and half its width."""

    def __init__(self, z, radius, half_width):
        self.z, self.radius, self.half_width = z, radius, half_width
        self.axis = (radius, z)  # y, z
        self.hole = radius * 0.62


FRONT = Wheel(-1.08, 0.54, 0.14)
REAR = Wheel(1.08, 0.57, 0.185)
SEGMENTS = 64


def make_wheel(wheel):
    """The parts of a wheel. The texture of the tyre's profile runs from the left inner edge over the tread to the right."""
    return [
        ring("tyre", _tyre_profile(wheel), wheel.axis, (0.0, 0.0, 1.0, 1.0), SEGMENTS, crease=45.0),
        ring("rim", _rim_profile(wheel), wheel.axis, (0.0, 0.0, 1.0, 1.0), SEGMENTS, crease=30.0),
    ]


def _tyre_profile(wheel):
    """(x, radius, v): straight sides, round shoulders and a flat tread; open towards the rim, which hides it."""
    w, top, shoulder, inner = wheel.half_width, wheel.radius, 0.085, wheel.hole + 0.035
    tread = w - shoulder * 0.85
    turn = [i / 6 for i in range(1, 7)]
    half = [(-w * 0.82, inner, 0.0), (-w * 0.97, inner + 0.03, 0.05), (-w, top - shoulder * 1.15, 0.28)]
    half += [(-tread - shoulder * 0.85 * cos(s * pi / 2), top - shoulder + shoulder * sin(s * pi / 2), 0.28 + 0.1 * s) for s in turn]
    return _both_sides(half + [(-tread / 2, top, 0.44)], [(0.0, top, 0.5)])


def _rim_profile(wheel):
    """(x, radius, v): a band with a raised lip on each side, on which the light lies, and a groove within."""
    w, hole = wheel.half_width * 0.9, wheel.hole
    half = [(-w * 0.8, hole + 0.042, 0.0), (-w, hole + 0.036, 0.06), (-w - 0.006, hole + 0.030, 0.1), (-w - 0.006, hole + 0.002, 0.25),
            (-w * 0.95, hole - 0.006, 0.3), (-w * 0.55, hole - 0.006, 0.38), (-w * 0.45, hole + 0.012, 0.42)]
    return _both_sides(half, [])


def _both_sides(half, middle):
    return half + middle + [(-x, r, 1.0 - v) for x, r, v in reversed(half)]
