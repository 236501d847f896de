"""Smooth bodies from distance fields: limbs that blend, their surface as a mesh, and lines drawn upon it."""

from itertools import product
from math import floor, sqrt

from mesh import Part
from vec import add, length, scale, sub, unit


class Blend:
    """A body, the same on both sides of x = 0, of cones with round ends: (x, y, z, radius) to (x, y, z, radius).

    Its distance is the polynomial smooth minimum of the cones' distances: within `reach` of each other they flow together.
    """

    def __init__(self, cones, reach):
        self.reach = reach
        self.cones = []
        for (ax, ay, az, ar), (bx, by, bz, br) in cones:
            dx, dy, dz = bx - ax, by - ay, bz - az
            self.cones.append((ax, ay, az, ar, dx, dy, dz, br - ar, 1.0 / (dx * dx + dy * dy + dz * dz)))

    def __call__(self, point):
        x, y, z = abs(point[0]), point[1], point[2]
        reach, least = self.reach, 1e9
        for ax, ay, az, ar, dx, dy, dz, dr, scaled in self.cones:
            px, py, pz = x - ax, y - ay, z - az
            t = (px * dx + py * dy + pz * dz) * scaled
            t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
            px, py, pz = px - dx * t, py - dy * t, pz - dz * t
            d = sqrt(px * px + py * py + pz * pz) - ar - dr * t
            gap = reach - abs(d - least)
            least = min(d, least)
            if gap > 0.0:
                least -= gap * gap / (4.0 * reach)
        return least

    def normal(self, point, step=0.002):
        axes = ((step, 0.0, 0.0), (0.0, step, 0.0), (0.0, 0.0, step))
        return unit(tuple(self(add(point, a)) - self(sub(point, a)) for a in axes))

    def hit(self, start, direction):
        """Where a ray first meets the surface."""
        at, way = start, unit(direction)
        for _ in range(80):
            d = self(at)
            if d < 1e-5:
                return at
            at = add(at, scale(way, d * 0.9))
        raise ValueError(f"the ray from {start} along {direction} misses the body")


def surface(field, low, high, cell):
    """The field's zero surface by surface nets: (points, quads of indices), wound outward.

    One vertex in each cell that the surface crosses, one quad across each edge of the lattice that it crosses. Blocks of cells
    that lie further from the surface than they are wide are skipped: a distance field says so at their middle.
    """
    size = [floor((h - l) / cell) + 1 for l, h in zip(low, high)]
    values = _sample(field, low, size, cell)
    points, index, quads = [], {}, []
    corners = list(product((0, 1), repeat=3))
    for base in product(*(range(n) for n in size)):
        around = [values.get((base[0] + c[0], base[1] + c[1], base[2] + c[2])) for c in corners]
        if None in around or min(around) > 0 or max(around) <= 0:
            continue
        index[base] = len(points)
        points.append(_settle(field, _crossing(base, corners, around, low, cell)))
    for base in index:
        inside = values[base] <= 0
        for axis in range(3):
            ahead = tuple(b + (k == axis) for k, b in enumerate(base))
            if (values[ahead] <= 0) == inside:
                continue
            one, two = (axis + 1) % 3, (axis + 2) % 3
            back = [tuple(b - (k == one and p) - (k == two and q) for k, b in enumerate(base)) for p, q in ((0, 0), (1, 0), (1, 1), (0, 1))]
            quads.append(tuple(index[b] for b in (back if inside else back[::-1])))
    return points, quads


def _sample(field, low, size, cell, block=4):
    """The field at the lattice's points near the surface."""
    values = {}
    reach = cell * block * 0.87 + cell * 1.8
    for corner in product(*(range(0, n + 1, block) for n in size)):
        if abs(field(tuple(l + (c + block / 2) * cell for l, c in zip(low, corner)))) > reach:
            continue
        for offset in product(range(block), repeat=3):
            at = tuple(c + o for c, o in zip(corner, offset))
            values[at] = field(tuple(l + a * cell for l, a in zip(low, at)))
    return values


def _crossing(base, corners, around, low, cell):
    """The mean of the places where the cell's edges cross the surface."""
    total, count = (0.0, 0.0, 0.0), 0
    for i, a in enumerate(corners):
        for j in (i + 1, i + 2, i + 4):
            if j < 8 and corners[j][{1: 2, 2: 1, 4: 0}[j - i]] > a[{1: 2, 2: 1, 4: 0}[j - i]] and (around[i] <= 0) != (around[j] <= 0):
                t = around[i] / (around[i] - around[j])
                total = add(total, add(a, scale(sub(corners[j], a), t)))
                count += 1
    return tuple(l + (b + t / count) * cell for l, b, t in zip(low, base, total))


def _settle(field, point):
    """The point, moved onto the surface."""
    for _ in range(2):
        point = sub(point, scale(field.normal(point), field(point)))
    return point


def skin(field, material, low, high, cell, coordinate):
    """The surface as a part with the field's own normals; `coordinate(point, normal)` gives each vertex its place in the texture."""
    points, quads = surface(field, low, high, cell)
    part = Part(material)
    normals = [field.normal(p) for p in points]
    for point, normal in zip(points, normals):
        part.vertex(point, coordinate(point, normal))
    part.given = normals
    for quad in quads:
        part.quad(*quad)
    return part


def nearest(point, places):
    """The distance from a point to the nearest of the places."""
    return min(length(sub(point, p)) for p in places)
