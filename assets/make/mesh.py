"""Parts of a model and the OBJ file they make together.

A part is a closed surface of one material. Its normals come from its faces: corners that meet at a point share a
normal, weighted by area and angle, unless their faces meet at more than the part's crease angle. Large faces so
dominate small ones, and a narrow bevel shades like a rounded edge.
"""

from math import acos, cos, radians

from vec import add, cross, dot, length, scale, sub, unit

PLACES = 4  # decimals of every number in the OBJ file


class Part:
    def __init__(self, material, crease=40.0):
        self.material = material
        self.crease = crease  # degrees
        self.points, self.uvs, self.triangles = [], [], []
        self.given = None  # normals of the vertices, where the shape knows them better than its faces do

    def vertex(self, point, uv):
        """Adds a corner and returns its index. Positions are rounded to what the file will hold."""
        self.points.append(tuple(round(c, PLACES) + 0.0 for c in point))
        self.uvs.append((round(uv[0], PLACES) + 0.0, round(uv[1], PLACES) + 0.0))
        return len(self.points) - 1

    def triangle(self, a, b, c):
        """Adds a face, unless its corners lie (almost) on a line: then it would have no normal."""
        p, q, r = self.points[a], self.points[b], self.points[c]
        if length(cross(sub(q, p), sub(r, p))) > 1e-8:
            self.triangles.append((a, b, c))

    def quad(self, a, b, c, d):
        """Adds two faces, split along the shorter diagonal."""
        p = self.points
        if length(sub(p[a], p[c])) <= length(sub(p[b], p[d])):
            self.triangle(a, b, c)
            self.triangle(a, c, d)
        else:
            self.triangle(a, b, d)
            self.triangle(b, c, d)

    def grid(self, rows, uvs):
        """Adds the surface through `rows` of points (equally many in each); returns the rows of indices."""
        index = [[self.vertex(p, t) for p, t in zip(row, uv)] for row, uv in zip(rows, uvs)]
        for lower, upper in zip(index, index[1:]):
            for i in range(len(lower) - 1):
                self.quad(lower[i], lower[i + 1], upper[i + 1], upper[i])
        return index

    def outward(self):
        """Turns the part inside out if its volume is negative; returns the part."""
        if self.volume() < 0:
            self.triangles = [(a, c, b) for a, b, c in self.triangles]
        return self

    def volume(self):
        p = self.points
        return sum(dot(p[a], cross(p[b], p[c])) for a, b, c in self.triangles) / 6.0

    def moved(self, function):
        """A copy whose points are `function(point)`."""
        copy = Part(self.material, self.crease)
        copy.points = [tuple(round(c, PLACES) + 0.0 for c in function(p)) for p in self.points]
        copy.uvs, copy.triangles = list(self.uvs), list(self.triangles)
        return copy.outward()

    def mirrored(self):
        """The part seen in the plane x = 0, with the same texture coordinates."""
        return self.moved(lambda p: (-p[0], p[1], p[2]))

    def corner_normals(self):
        """A normal for each corner of each triangle."""
        faces, around = [], {}
        for face, triangle in enumerate(self.triangles):
            a, b, c = (self.points[i] for i in triangle)
            area = cross(sub(b, a), sub(c, a))
            faces.append((unit(area), length(area)))
            for i in triangle:
                around.setdefault(self.points[i], []).append(face)
        if self.given:
            return [tuple(self._known(face, i, faces) for i in triangle) for face, triangle in enumerate(self.triangles)]
        limit = cos(radians(self.crease))
        return [tuple(self._normal(face, i, around, faces, limit) for i in triangle)
                for face, triangle in enumerate(self.triangles)]

    def _known(self, face, corner, faces):
        """The given normal, or the face's own where a fold is too tight for the mesh."""
        given, own = self.given[corner], faces[face][0]
        return given if dot(given, own) > 0.1 else own

    def _normal(self, face, corner, around, faces, limit):
        own, total = faces[face][0], (0.0, 0.0, 0.0)
        for other in around[self.points[corner]]:
            normal, area = faces[other]
            if dot(own, normal) >= limit:
                total = add(total, scale(normal, area * self._angle(other, corner)))
        return unit(total)

    def _angle(self, face, corner):
        at = self.points[corner]
        a, b = (self.points[i] for i in self.triangles[face] if self.points[i] != at)
        return acos(max(-1.0, min(1.0, dot(unit(sub(a, at)), unit(sub(b, at))))))


def write_obj(path, library, parts, comment):
    """Writes the parts, one `usemtl` a material in order of first use, with shared positions, coordinates and normals."""
    tables = {"v": {}, "vt": {}, "vn": {}}
    groups = {}
    for part in parts:
        lines = groups.setdefault(part.material, [])
        for triangle, normals in zip(part.triangles, part.corner_normals()):
            corners = []
            for i, normal in zip(triangle, normals):
                values = (("v", part.points[i]), ("vt", part.uvs[i]), ("vn", normal))
                corners.append("/".join(str(_number(tables[kind], value)) for kind, value in values))
            lines.append("f " + " ".join(corners))
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"# {comment}\nmtllib {library}\n")
        for kind, table in tables.items():
            file.writelines(f"{kind} {text}\n" for text in table)
        for material, lines in groups.items():
            file.write(f"usemtl {material}\n" + "\n".join(lines) + "\n")


def _number(table, value):
    text = " ".join(f"{c + 0.0:.{PLACES}f}".replace("-0.0000", "0.0000") for c in value)
    return table.setdefault(text, len(table) + 1)
