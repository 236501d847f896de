"""The shapes a model is made of: smooth curves, lofts, tubes, rings and plates."""

from math import cos, exp, hypot, pi, sin

from mesh import Part
from vec import add, cross, mix, scale, sub, unit


def curve(knots, blur=0.0):
    """A function through (or, with a blur, near) the `knots` (t, value): monotone cubic, so it never overshoots,
    then convolved with a Gaussian of standard deviation `blur`, so that its highlights run smoothly."""
    ts, vs = [k[0] for k in knots], [k[1] for k in knots]
    slopes = _monotone_slopes(ts, vs)

    def plain(t):
        if t <= ts[0]:
            return vs[0] + slopes[0] * (t - ts[0])
        if t >= ts[-1]:
            return vs[-1] + slopes[-1] * (t - ts[-1])
        i = max(j for j in range(len(ts) - 1) if ts[j] <= t)
        h = ts[i + 1] - ts[i]
        s = (t - ts[i]) / h
        a, b = vs[i], vs[i + 1]
        return (a * (1 + 2 * s) * (1 - s) ** 2 + b * s * s * (3 - 2 * s)
                + h * s * (1 - s) * ((1 - s) * slopes[i] - s * slopes[i + 1]))

    if blur == 0:
        return plain
    taps = [(k * blur / 4, exp(-k * k / 32)) for k in range(-12, 13)]
    total = sum(w for _, w in taps)
    return lambda t: sum(w * plain(t + d) for d, w in taps) / total


def _monotone_slopes(ts, vs):
    """Fritsch and Butland's slopes: the harmonic mean of the neighbouring secants, 0 at an extremum."""
    secants = [(vs[i + 1] - vs[i]) / (ts[i + 1] - ts[i]) for i in range(len(ts) - 1)]
    inner = [0.0 if a * b <= 0 else 2 * a * b / (a + b) for a, b in zip(secants, secants[1:])]
    return [secants[0]] + inner + [secants[-1]]


def closed_loft(material, rings, uvs, caps, crease=40.0):
    """A tube through `rings` of points (each starts and ends at the same point), closed at its ends by flat caps;
    `uvs` gives a coordinate to each point, `caps` one to each end."""
    part = Part(material, crease)
    part.grid(rings, uvs)
    for ring, uv, turn in ((rings[0], caps[0], -1), (rings[-1], caps[1], 1)):
        corners = [part.vertex(p, uv) for p in ring[:-1]]
        flat = [(p[0], p[1]) for p in ring[:-1]]
        for a, b, c in ears(flat):
            part.triangle(*(corners[i] for i in ((a, b, c) if turn > 0 else (c, b, a))))
    return part.outward()


def tube(material, path, radii, box, sides=14, up=(0.0, 1.0, 0.0), round_ends=(4, 4), power=2.0, crease=50.0):
    """A limb: superellipses of half-widths `radii` (across, along `up`) about the points of `path`, with rounded ends.
    `up` is one direction, or a list with one for each point.

    `box` is its rectangle in the texture (u0, v0, u1, v1): u runs once around, from below by the left to below, so
    that its middle lies on top; v runs along the path.
    """
    centres, sizes = _rounded(path, radii, round_ends)
    inner = up if isinstance(up, list) else [up] * len(path)
    ups = inner[:1] * round_ends[0] + inner + inner[-1:] * round_ends[1]
    part = Part(material, crease)
    rings = []
    for i, (centre, (rx, ry)) in enumerate(zip(centres, sizes)):
        along = unit(sub(centres[min(i + 1, len(centres) - 1)], centres[max(i - 1, 0)]))
        side = unit(cross(along, ups[i]))
        top = cross(side, along)
        rings.append([add(centre, add(scale(side, rx * c), scale(top, ry * s))) for c, s in _superellipse(sides, power)])
    lengths = _parameters(centres)
    u0, v0, u1, v1 = box
    uvs = [[(u0 + (u1 - u0) * k / sides, v0 + (v1 - v0) * t) for k in range(sides + 1)] for t in lengths[1:-1]]
    index = part.grid(rings[1:-1], uvs)
    for pole, ring, v in ((centres[0], index[0], v0), (centres[-1], index[-1], v1)):
        for k in range(sides):
            tip = part.vertex(pole, (u0 + (u1 - u0) * (k + 0.5) / sides, v))
            part.triangle(*((ring[k + 1], ring[k], tip) if v == v0 else (ring[k], ring[k + 1], tip)))
    return part.outward()


def _superellipse(sides, power):
    """Points of |x|^p + |y|^p = 1, from below once around."""
    def bend(c):
        return abs(c) ** (2 / power) * (1 if c > 0 else -1)

    angles = [-pi / 2 + 2 * pi * k / sides for k in range(sides)]
    points = [(bend(round(cos(a), 12)), bend(round(sin(a), 12))) for a in angles]
    return points + points[:1]


def _rounded(path, radii, steps):
    """The path and radii with quarter ellipses added in front and behind, down to a pole (radius ~0)."""
    def cap(end, before, radius, count):
        out = unit(sub(end, before))
        reach = min(radius)
        turns = [pi / 2 * (k + 1) / count for k in range(count)]
        return [(add(end, scale(out, reach * sin(a))), (radius[0] * cos(a), radius[1] * cos(a))) for a in turns]

    body = list(zip(path, radii))
    front = cap(path[0], path[1], radii[0], steps[0])[::-1]
    back = cap(path[-1], path[-2], radii[-1], steps[1])
    whole = front + body + back
    return [c for c, _ in whole], [r for _, r in whole]


def _parameters(points):
    """0..1 along the points, by length."""
    sums = [0.0]
    for a, b in zip(points, points[1:]):
        sums.append(sums[-1] + hypot(*sub(b, a)))
    return [s / sums[-1] for s in sums]


def spline(points, count):
    """`count` points on a Catmull-Rom spline through `points` (tuples of any length)."""
    whole = [mix(points[0], points[1], -1.0)] + list(points) + [mix(points[-1], points[-2], -1.0)]
    out = []
    for k in range(count):
        t = k * (len(points) - 1) / (count - 1)
        i = min(int(t), len(points) - 2)
        s = t - i
        a, b, c, d = whole[i:i + 4]
        out.append(tuple(
            0.5 * (2 * q + (r - p) * s + (2 * p - 5 * q + 4 * r - w) * s * s + (3 * q - p - 3 * r + w) * s ** 3)
            for p, q, r, w in zip(a, b, c, d)))
    return out


def ring(material, profile, axis, box, segments, crease=40.0):
    """A closed `profile` of (x, radius, v), turned about the line through `axis` (y, z) along x; u of `box` runs once around."""
    part = Part(material, crease)
    loop = profile + profile[:1]
    u0, v0, u1, v1 = box
    rows, uvs = [], []
    for k in range(segments + 1):
        a = 2 * pi * (k % segments) / segments
        rows.append([(x, axis[0] + r * cos(a), axis[1] + r * sin(a)) for x, r, _ in loop])
        uvs.append([(u0 + (u1 - u0) * k / segments, v0 + (v1 - v0) * v) for _, _, v in loop])
    part.grid(rows, uvs)
    return part.outward()


def ears(polygon):
    """Triangles (of indices) that fill a simple polygon of (x, y) points, wound counter-clockwise."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    area = sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(polygon, polygon[1:] + polygon[:1]))
    left = list(range(len(polygon)))
    if area < 0:
        left.reverse()
    triangles = []
    while len(left) > 2:
        best = None
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = polygon[i], polygon[j], polygon[m]
            size = turn(a, b, c)
            if size <= 0:
                continue
            blocked = any(turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0
                          for p in (polygon[n] for n in left if n not in (i, j, m)))
            quality = size / (hypot(a[0] - c[0], a[1] - c[1]) ** 2 + 1e-12)
            if not blocked and (best is None or quality > best[0]):
                best = (quality, k, (i, j, m))
        if best is None:
            raise ValueError("the polygon crosses itself")
        triangles.append(best[2])
        left.pop(best[1])
    return triangles if area > 0 else [(a, b, c) for a, b, c in triangles]


def plate(material, outline, thickness, bevel, place, box, crease=35.0):
    """A plate with bevelled edges: `outline` of (a, b), counter-clockwise, spread by `place(a, b, h)` into space, where h runs
    from -thickness/2 to thickness/2. v of `box` is 0 at the rim and 1 within; u runs around."""
    part = Part(material, crease)
    half = thickness / 2
    inner = inset(outline, bevel)
    deep = inset(outline, bevel * 3)
    u0, v0, u1, v1 = box
    levels = [(deep, -half, 1.0), (inner, -half, 0.35), (outline, -half + bevel, 0.0), (outline, half - bevel, 0.0),
              (inner, half, 0.35), (deep, half, 1.0)]
    n = len(outline)
    rows = [[place(*shape[i % n], h) for i in range(n + 1)] for shape, h, _ in levels]
    uvs = [[(u0 + (u1 - u0) * i / n, v0 + (v1 - v0) * v) for i in range(n + 1)] for _, _, v in levels]
    index = part.grid(rows, uvs)
    fill = ears(deep)
    for a, b, c in fill:
        part.triangle(index[0][c], index[0][b], index[0][a])
        part.triangle(index[-1][a], index[-1][b], index[-1][c])
    return part.outward()


def inset(outline, distance):
    """A counter-clockwise outline, moved inward by `distance`."""
    out = []
    for i, p in enumerate(outline):
        before, after = outline[i - 1], outline[(i + 1) % len(outline)]
        a, b = _inward(before, p), _inward(p, after)
        x, y = a[0] + b[0], a[1] + b[1]
        fit = 2 * distance / max(x * x + y * y, 0.8)
        out.append((p[0] + x * fit, p[1] + y * fit))
    return out


def _inward(a, b):
    d = hypot(b[0] - a[0], b[1] - a[1])
    return ((a[1] - b[1]) / d, (b[0] - a[0]) / d)
