"""The hull of the light cycle: one shell from the beak over the front wheel, the tank and the tail to its tip.

Its sections stand across the length z. Half a section runs through seven feature points: crest (x = 0), shoulder, belt,
lip, and back inside by the lip's inner edge and the arch's shoulder to the arch (x = 0) over the wheel, or the keel.
"""

from math import hypot, sqrt

from shape import closed_loft, curve
from wheels import FRONT, REAR

#         z   crest  shoulder x, y  belt x, y    lip x, y
TABLE = ((-1.74, 0.665, 0.050, 0.660, 0.085, 0.635, 0.070, 0.605),
         (-1.70, 0.745, 0.065, 0.735, 0.115, 0.680, 0.095, 0.605),
         (-1.64, 0.845, 0.080, 0.830, 0.145, 0.740, 0.135, 0.640),
         (-1.55, 0.955, 0.095, 0.935, 0.180, 0.835, 0.165, 0.755),
         (-1.40, 1.060, 0.110, 1.035, 0.210, 0.925, 0.180, 0.860),
         (-1.20, 1.130, 0.125, 1.105, 0.240, 0.995, 0.190, 0.935),
         (-1.00, 1.175, 0.145, 1.140, 0.270, 1.020, 0.195, 0.950),
         (-0.80, 1.175, 0.168, 1.125, 0.305, 0.990, 0.205, 0.870),
         (-0.66, 1.145, 0.185, 1.075, 0.328, 0.925, 0.215, 0.720),
         (-0.59, 1.105, 0.190, 1.035, 0.335, 0.885, 0.220, 0.540),
         (-0.53, 1.060, 0.192, 0.990, 0.336, 0.850, 0.225, 0.330),
         (-0.46, 1.015, 0.190, 0.945, 0.330, 0.815, 0.225, 0.225),
         (-0.35, 0.945, 0.180, 0.875, 0.310, 0.750, 0.215, 0.185),
         (-0.15, 0.885, 0.150, 0.820, 0.245, 0.660, 0.200, 0.165),
         (0.10, 0.850, 0.130, 0.785, 0.210, 0.600, 0.195, 0.165),
         (0.30, 0.845, 0.140, 0.780, 0.215, 0.620, 0.205, 0.185),
         (0.42, 0.885, 0.146, 0.815, 0.230, 0.690, 0.215, 0.250),
         (0.50, 0.945, 0.152, 0.875, 0.242, 0.760, 0.222, 0.370),
         (0.57, 1.000, 0.156, 0.930, 0.252, 0.825, 0.226, 0.560),
         (0.66, 1.065, 0.158, 1.000, 0.262, 0.890, 0.230, 0.740),
         (0.78, 1.140, 0.158, 1.080, 0.272, 0.965, 0.235, 0.860),
         (0.90, 1.190, 0.154, 1.140, 0.275, 1.030, 0.235, 0.930),
         (1.10, 1.225, 0.144, 1.185, 0.265, 1.085, 0.230, 0.990),
         (1.30, 1.210, 0.130, 1.175, 0.240, 1.085, 0.218, 0.995),
         (1.50, 1.150, 0.112, 1.115, 0.205, 1.040, 0.192, 0.960),
         (1.64, 1.068, 0.096, 1.042, 0.167, 0.990, 0.160, 0.925),
         (1.72, 0.988, 0.082, 0.980, 0.132, 0.962, 0.118, 0.947))

FRONT_END, REAR_END = TABLE[0][0], TABLE[-1][0]
FACETS = (0.0, 0.26, 0.54, 0.82, 0.86, 0.94, 1.0)  # texture row (0..1 of the hull's band) of each feature point
CREST, SHOULDER, BELT, LIP = range(4)
STEPS = (4, 4, 5, 1, 1, 2)  # quads across each facet
BULGE = (0.05, 0.04, 0.06, 0.0, 0.0, 0.0)  # of each facet's width
BEVEL = 0.012

_columns = [curve([(row[0], row[k]) for row in TABLE], 0.025) for k in range(1, 8)]


def _arch(z):
    """The height of the wheel arch's roof at z, or None between and beyond the wheels."""
    for wheel in (FRONT, REAR):
        room = (wheel.radius + 0.035) ** 2 - (z - wheel.z) ** 2
        if room > 0:
            return wheel.radius + sqrt(room), wheel.half_width + 0.012
    return None


def features(z):
    """The seven feature points (x, y) of the half section at z."""
    crest, x1, y1, x2, y2, x3, y3 = (column(z) for column in _columns)
    arch = _arch(z)
    roof, wide = arch if arch and arch[0] > y3 + 0.03 else (y3 - 0.01, x3 * 0.5)
    drop = 0.1 if arch and arch[0] > y3 + 0.12 else 0.0
    return [(0.0, crest), (x1, y1), (x2, y2), (x3, y3), (x3 - 0.028, y3 + 0.004), (min(wide, x3 - 0.03), roof - drop), (0.0, roof)]


def half_section(z):
    """Points (x, y, texture row) from the crest to the arch at z, with bevelled creases."""
    corners = features(z)
    out = [(*corners[0], 0.0)]
    for k, steps in enumerate(STEPS):
        a, b = corners[k], corners[k + 1]
        width = hypot(b[0] - a[0], b[1] - a[1])
        normal = ((a[1] - b[1]) / width, (b[0] - a[0]) / width)
        first = min(BEVEL / width, 0.25) if k else 0.0
        last = 1 - min(BEVEL / width, 0.25) if k < len(STEPS) - 1 else 1.0
        for i in range(0 if k else 1, steps + 1):
            s = first + (last - first) * i / steps
            lift = BULGE[k] * width * 4 * s * (1 - s)
            x, y = a[0] + (b[0] - a[0]) * s + normal[0] * lift, a[1] + (b[1] - a[1]) * s + normal[1] * lift
            out.append((max(x, 0.0), y, FACETS[k] + (FACETS[k + 1] - FACETS[k]) * s))
    return out


def stations():
    """The places of the sections: denser where the hull drops behind the wheels and at its ends."""
    spans = ((-1.74, -1.60, 8), (-1.60, -0.70, 18), (-0.70, -0.42, 14), (-0.42, 0.38, 16), (0.38, 0.66, 14),
             (0.66, 1.56, 18), (1.56, 1.72, 6))
    places = [a + (b - a) * i / n for a, b, n in spans for i in range(n)]
    return places + [spans[-1][1]]


def make_hull(box):
    """The hull as a part of material `body`; its texture lies in `box`, u along z from the beak to the tail."""
    u0, v0, u1, v1 = box
    rings, uvs = [], []
    for z in stations():
        half = half_section(z)
        u = u0 + (u1 - u0) * (z - FRONT_END) / (REAR_END - FRONT_END)
        right = [((x, y, z), (u, v0 + (v1 - v0) * t)) for x, y, t in reversed(half)]
        left = [((-x, y, z), (u, v0 + (v1 - v0) * t)) for x, y, t in half[1:]]
        rings.append([p for p, _ in right + left])
        uvs.append([t for _, t in right + left])
    plain = v0 + 0.4 * (v1 - v0)
    return closed_loft("body", rings, uvs, ((u0, plain), (u1, plain)), crease=50.0)
