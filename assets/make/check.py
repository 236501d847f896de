"""Reads a finished OBJ file back and refuses it when it is not a set of sound closed surfaces."""

from math import isfinite

from vec import cross, dot, length, sub


class Broken(Exception):
    """The file is not what it should be; the message names the file and the fault."""


def read_obj(path):
    """(positions, coordinates, normals, {material: [triangle of (v, vt, vn) indices from 0]})"""
    tables, groups, current = {"v": [], "vt": [], "vn": []}, {}, None
    for line in open(path, encoding="ascii"):
        word, *rest = line.split()
        if word in tables:
            tables[word].append(tuple(map(float, rest)))
        elif word == "usemtl":
            require(rest[0] not in groups, path, f"material {rest[0]} is used twice")
            current = groups.setdefault(rest[0], [])
        elif word == "f":
            current.append(tuple(tuple(int(i) - 1 for i in corner.split("/")) for corner in rest))
    return tables["v"], tables["vt"], tables["vn"], groups


def require(condition, path, fault):
    if not condition:
        raise Broken(f"{path}: {fault}")


def check_model(path, triangles, low, high, closed=True):
    """Checks the count of triangles (a range), the bounding box (within low..high, and at least 90 % of it), every face, and that
    each connected part is closed and wound outward, or, if it is not to be closed, looks up."""
    points, coordinates, normals, groups = read_obj(path)
    count = sum(map(len, groups.values()))
    require(triangles[0] <= count <= triangles[1], path, f"{count} triangles, not {triangles[0]} to {triangles[1]}")
    for table in (points, coordinates, normals):
        require(all(isfinite(c) for row in table for c in row), path, "a number is not finite")
        require(len(set(table)) == len(table), path, "a vertex, coordinate or normal is stored twice")
    require(all(abs(length(n) - 1) < 2e-4 for n in normals), path, "a normal is not of length 1")
    require(all(0 <= c <= 1 for row in coordinates for c in row), path, "a texture coordinate lies outside 0..1")
    for axis in range(3):
        least, most = min(p[axis] for p in points), max(p[axis] for p in points)
        inside = low[axis] - 1e-6 <= least and most <= high[axis] + 1e-6
        require(inside and most - least >= 0.9 * (high[axis] - low[axis]), path, f"axis {axis} runs from {least} to {most}")
    for material, faces in groups.items():
        for face in faces:
            _check_face(path, material, face, points, coordinates, normals)
            require(closed or all(normals[corner[2]][1] > 0 for corner in face), path, f"{material}: a face looks down")
        if closed:
            for component in _components(faces):
                _check_closed(path, material, component, points)
    return count


def _check_face(path, material, face, points, coordinates, normals):
    tables = (points, coordinates, normals)
    require(len(face) == 3, path, f"{material}: a face has {len(face)} corners")
    valid = all(0 <= i < len(t) for corner in face for i, t in zip(corner, tables))
    require(valid, path, f"{material}: a face names a vertex that is not there")
    a, b, c = (points[corner[0]] for corner in face)
    area = cross(sub(b, a), sub(c, a))
    require(length(area) > 1e-9, path, f"{material}: a triangle at {a} has no area")
    agree = all(dot(area, normals[corner[2]]) > 0 for corner in face)
    require(agree, path, f"{material}: a normal at {a} points into the surface")


def _components(faces):
    """The faces, parted into connected surfaces."""
    parent = {}

    def root(i):
        while parent.setdefault(i, i) != i:
            parent[i] = i = parent[parent[i]]
        return i

    for face in faces:
        for corner in face[1:]:
            parent[root(corner[0])] = root(face[0][0])
    parts = {}
    for face in faces:
        parts.setdefault(root(face[0][0]), []).append([corner[0] for corner in face])
    return parts.values()


def _check_closed(path, material, faces, points):
    """Every edge is passed once in each direction, and the enclosed volume is positive: closed, and wound outward."""
    edges = set()
    for face in faces:
        for edge in zip(face, face[1:] + face[:1]):
            require(edge not in edges, path, f"{material}: an edge at {points[edge[0]]} is passed twice in one direction")
            edges.add(edge)
    for a, b in edges:
        require((b, a) in edges, path, f"{material}: the surface is open at {points[a]}")
    volume = sum(dot(points[a], cross(points[b], points[c])) for a, b, c in faces)
    require(volume > 0, path, f"{material}: a part at {points[faces[0][0]]} is inside out")
