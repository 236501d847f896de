"""The rider, lying low behind the screen: a suit in one skin, lines of light upon it, and a helmet."""

from atlas import BOOT, HELMET, SUIT, VISOR, WHOLE
from field import Blend, nearest, skin
from shape import spline, tube
from vec import add, scale, sub

# Cones from (x, y, z, radius) to (x, y, z, radius), for x >= 0.
CHAINS = (
    ((0.02, 0.920, 0.42, 0.100), (0.09, 0.935, 0.41, 0.108)),  # pelvis
    ((0.00, 0.965, 0.38, 0.095), (0.00, 1.010, 0.16, 0.092), (0.00, 1.065, -0.14, 0.098)),  # spine
    ((0.05, 0.975, 0.24, 0.082), (0.105, 1.060, -0.12, 0.088)),  # flanks
    ((0.00, 1.085, -0.19, 0.082), (0.145, 1.095, -0.205, 0.074)),  # shoulders
    ((0.00, 1.125, -0.13, 0.052), (0.00, 1.090, 0.10, 0.030)),  # the hump on the back
    ((0.00, 1.100, -0.24, 0.072), (0.00, 1.160, -0.37, 0.068)),  # neck
    ((0.175, 1.102, -0.205, 0.082), (0.205, 1.080, -0.225, 0.078)),  # deltoid
    ((0.190, 1.085, -0.220, 0.066), (0.255, 1.010, -0.265, 0.062), (0.322, 0.910, -0.320, 0.046)),  # upper arm
    ((0.324, 0.905, -0.330, 0.048), (0.330, 0.892, -0.420, 0.054), (0.314, 0.897, -0.560, 0.034)),  # forearm
    ((0.310, 0.902, -0.590, 0.044), (0.303, 0.892, -0.650, 0.046)),  # fist
    ((0.105, 0.925, 0.38, 0.104), (0.190, 0.868, 0.17, 0.098), (0.282, 0.778, -0.075, 0.072)),  # thigh
    ((0.286, 0.768, -0.085, 0.074), (0.292, 0.735, -0.085, 0.070)),  # knee
    ((0.268, 0.800, 0.050, 0.055), (0.283, 0.690, 0.050, 0.055)),  # hollow of the knee
    ((0.290, 0.730, -0.060, 0.064), (0.290, 0.635, 0.090, 0.070), (0.268, 0.440, 0.330, 0.044)),  # shin
    ((0.267, 0.425, 0.375, 0.052), (0.270, 0.385, 0.310, 0.054), (0.277, 0.335, 0.165, 0.040)),  # boot
)
CELL = 0.026
GLOW_REACH = 0.12  # how far a line's glow spreads over the suit
BOOT_TOP, GLOVE_CUFF = 0.475, -0.555  # below this y and before this z the rider wears boots and gloves


def make_rider():
    body = Blend([pair for chain in CHAINS for pair in zip(chain, chain[1:])], 0.06)
    right = _lines(body)
    lines = [_spine(body)] + right + [[(-x, y, z) for x, y, z in line] for line in right]
    lit = [p for line in lines for p in line]

    def coordinate(point, normal):
        wears_leather = point[1] < BOOT_TOP and point[2] > 0.1 or point[2] < GLOVE_CUFF
        u0, v0, u1, v1 = BOOT if wears_leather else SUIT
        glow = min(1.0, nearest(point, lit) / GLOW_REACH)
        return u0 + (u1 - u0) * glow, v0 + (v1 - v0) * (0.5 + 0.5 * normal[1])

    suit = skin(body, "rider", (-0.455, 0.25, -0.75), (0.455, 1.27, 0.58), CELL, coordinate)
    return [suit] + [_ribbon(body, line) for line in lines] + _helmet()


def _spine(body):
    return _drape(body, spline([(0.0, 1.4, z) for z in (0.44, 0.24, 0.04, -0.10)], 24), (0.0, -1.0, 0.0))


def _lines(body):
    """Lines of light on the right side, each a row of points on the suit."""
    out, out_and_up = (1.0, 0.25, 0.0), (0.8, 0.75, 0.1)
    return [
        _drape(body, spline([(0.004, 1.4, -0.10), (0.075, 1.4, -0.165), (0.15, 1.4, -0.195)], 8), (0.0, -1.0, 0.0)),
        _along(body, [(0.07, 0.97, 0.30), (0.06, 1.00, 0.16), (0.09, 1.04, 0.00), (0.12, 1.08, -0.12)], (0.8, 0.6, 0.0), 12),
        _along(body, [(0.205, 1.08, -0.225), (0.255, 1.01, -0.265), (0.315, 0.92, -0.325), (0.330, 0.893, -0.420), (0.318, 0.896, -0.53)],
               out_and_up, 18),
        _along(body, [(0.115, 0.92, 0.34), (0.19, 0.868, 0.17), (0.27, 0.79, -0.05), (0.288, 0.752, -0.085), (0.290, 0.700, -0.030),
                      (0.290, 0.635, 0.09), (0.272, 0.475, 0.285)], out, 26),
        _around(body, (0.315, 0.897, -0.548), (0.0, 1.0, 0.0), (1.0, -0.1, 0.1)),
        _around(body, (0.272, 0.475, 0.287), (0.0, 0.6, 1.0), (1.0, 0.1, -0.1)),
    ]


def _along(body, axis, outward, count):
    """The points of a limb's axis, thrown outward to its skin."""
    away = scale(outward, 0.25)
    return _drape(body, [add(p, away) for p in spline(axis, count)], scale(outward, -1.0))


def _around(body, centre, above, outward, count=11):
    """A half ring about a limb: from above it, by its outer side, to below."""
    points = []
    for way in spline([above, add(scale(above, 0.7), outward), outward, add(scale(above, -0.7), outward)], count):
        start = add(centre, scale(way, 0.13))
        points.append(body.hit(start, sub(centre, start)))
    return points


def _drape(body, starts, direction):
    return [body.hit(p, direction) for p in starts]


def _ribbon(body, line):
    """A flat bead of light along points of the suit."""
    normals = [body.normal(p) for p in line]
    path = [add(p, scale(n, 0.001)) for p, n in zip(line, normals)]
    return tube("glow", path, [(0.0115, 0.006)] * len(path), WHOLE, 6, normals, (1, 1), crease=80.0)


def _helmet():
    """A shell drawn out to the back, and a visor that wraps around its front."""
    shell = _loft("rider", [
        (0.0, 1.198, -0.285, 0.090, 0.088),
        (0.0, 1.202, -0.330, 0.112, 0.110),
        (0.0, 1.202, -0.400, 0.127, 0.127),
        (0.0, 1.194, -0.465, 0.126, 0.127),
        (0.0, 1.178, -0.530, 0.104, 0.106),
    ], HELMET, 14, (6, 6))
    visor = _loft("glass", [
        (0.0, 1.176, -0.490, 0.108, 0.080),
        (0.0, 1.170, -0.540, 0.108, 0.088),
        (0.0, 1.160, -0.580, 0.092, 0.074),
    ], VISOR, 7, (3, 6))
    return [shell, visor]


def _loft(material, keys, box, count, ends):
    """A round form through `keys` of (x, y, z, half-width, half-height)."""
    points = spline(keys, count)
    return tube(material, [p[:3] for p in points], [p[3:] for p in points], box, 24, round_ends=ends, power=2.1)
