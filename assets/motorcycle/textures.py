"""The textures of the light cycle. Emission is grey: the scene gives it its colour."""

from math import cos, exp, hypot, pi

import atlas
from hull import BELT, FACETS, FRONT_END, LIP, REAR_END, SHOULDER, half_section
from paint import Canvas, noise, paint, save_maps, strip
from shape import curve

MARGIN = 0.02  # of a texture, around each box of the atlas


def write_textures(folder):
    _body(folder)
    _painted(folder, "rider", 256, _rider_layers())
    _painted(folder, "tyre", 512, [(atlas.WHOLE, _tyre)], height=256)
    _painted(folder, "rim", 128, [(atlas.WHOLE, _rim)])
    _painted(folder, "glass", 128, [(atlas.SCREEN, _screen), (atlas.VISOR, _visor)])
    _painted(folder, "trim", 8, [(atlas.WHOLE, lambda u, v: (0.18, 0.7, 0.06))])
    _painted(folder, "glow", 8, [(atlas.WHOLE, lambda u, v: (0.3, 0.3, 1.0))])


def _painted(folder, name, width, layers, height=None):
    """Saves the three maps of a material whose layers are (box, function of u, v -> (diffuse, specular, emissive))."""
    maps = [Canvas(width, height or width) for _ in range(3)]
    for box, function in layers:
        paint(maps, function, box, MARGIN)
    save_maps(maps, folder, name)


# ---- the hull -------------------------------------------------------------------------------------------------------

# The rider and the wheels, as spheres (x, y, z, radius): they darken the hull near them.
SHADES = [(0.0, 0.95, 0.36, 0.17), (0.0, 1.02, 0.12, 0.15), (0.0, 1.06, -0.12, 0.17), (0.0, 1.19, -0.42, 0.13)]
SHADES += [(s * x, y, z, r) for s in (-1, 1) for x, y, z, r in (
    (0.16, 0.89, 0.26, 0.11), (0.25, 0.81, 0.03, 0.1), (0.29, 0.75, -0.1, 0.08), (0.28, 0.6, 0.1, 0.07), (0.27, 0.45, 0.3, 0.06),
    (0.33, 0.89, -0.38, 0.06), (0.31, 0.9, -0.58, 0.06))]

# The sweep: from the beak along the belt, down the flank behind the fairing, up again to the tail.
SWEEP = curve(((-1.74, FACETS[BELT]), (-0.62, FACETS[BELT]), (-0.40, 0.60), (-0.12, 0.74), (0.12, 0.765), (0.36, 0.72), (0.62, 0.58),
               (0.80, FACETS[BELT]), (1.74, FACETS[BELT])), 0.04)


def _body(folder):
    maps = [Canvas(1024, 1024) for _ in range(3)]
    u0, v0, u1, v1 = atlas.HULL
    width, height = maps[0].width, maps[0].height // 2
    for x in range(width):
        along = max(0.0, min(1.0, ((x + 0.5) / width - u0) / (u1 - u0)))
        z = FRONT_END + (REAR_END - FRONT_END) * along
        column = _hull_column(z)
        marks = _marks(z, column)
        k = 0
        for y in range(height):
            t = max(0.0, min(1.0, ((y + 0.5) / maps[0].height - v0) / (v1 - v0)))
            while column[k + 1][0] < t:
                k += 1
            a, b = column[k], column[k + 1]
            f = (t - a[0]) / (b[0] - a[0])
            texel = _hull_texel(z, t, a[1] + (b[1] - a[1]) * f, a[2] + (b[2] - a[2]) * f, marks)
            for canvas, value in zip(maps, texel):
                canvas.data[y * width + x] = value
    paint(maps, _fin, atlas.FIN, MARGIN)
    paint(maps, _blade, atlas.BLADE, MARGIN)
    save_maps(maps, folder, "body")


def _hull_column(z):
    """For points down the half section at z: (texture row, length from the crest, light of an even sky)."""
    here, there = half_section(z), half_section(z + 0.01)
    out, walked = [], 0.0
    for k, (x, y, t) in enumerate(here):
        before, after = here[max(k - 1, 0)], here[min(k + 1, len(here) - 1)]
        if k:
            walked += hypot(x - before[0], y - before[1])
        ax, ay = after[0] - before[0], after[1] - before[1]
        bx, by = there[k][0] - x, there[k][1] - y
        normal = (-ay * 0.01, ax * 0.01, ay * bx - ax * by)
        size = hypot(*normal) or 1.0
        out.append((t, walked, _sky((x, y, z), tuple(c / size for c in normal))))
    return out


def _sky(point, normal):
    """How much of an even sky a point sees: by its slope, less what the rider hides."""
    seen = 1.0
    for x, y, z, r in SHADES:
        dx, dy, dz = x - point[0], y - point[1], z - point[2]
        d = hypot(dx, dy, dz)
        facing = (dx * normal[0] + dy * normal[1] + dz * normal[2]) / d
        seen *= 1 - 0.6 * max(0.0, facing) * r * r / (d * d + r * r)
    return (0.5 + 0.5 * normal[1]) * seen


def _marks(z, column):
    """Lengths from the crest of the creases and of the sweep at z."""
    def at(t):
        k = max(i for i in range(len(column) - 1) if column[i][0] <= t)
        a, b = column[k], column[k + 1]
        return a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0])
    return at(FACETS[SHOULDER]), at(FACETS[BELT]), at(FACETS[LIP] - 0.012), at(SWEEP(z))


JOINTS = (-1.5, -1.14, -0.72, -0.28, 0.2, 0.66)


def _hull_texel(z, t, s, sky, marks):
    """(diffuse, specular, emissive) of a point of the hull, a length s below the crest."""
    if t > FACETS[LIP] + 0.02:
        return 0.08, 0.2, 0.0
    shoulder, belt, lip, sweep = marks
    inlay = z > 0.66 and s < shoulder - 0.022
    low = s > sweep or inlay  # of dark carbon
    panel = noise(sum(z > j for j in JOINTS), 2 if low else 1 if t > FACETS[SHOULDER] else 0, 7)
    diffuse = (0.20 if low else 0.40) + 0.06 * panel
    specular = (0.75 if low else 0.5) + 0.2 * panel
    emissive = (0.03 + (0.28 if inlay else 0.18) * sky) if low else (0.06 + 0.38 * sky)
    beside = min(abs(z - j + 0.12 * (s - belt)) for j in JOINTS)
    left = 1 - 0.75 * strip(beside, 0.006)
    diffuse, specular, emissive = diffuse * left, specular * left, emissive * left + 0.05 * strip(beside - 0.013, 0.004)
    for edge in (shoulder, belt):
        emissive += 0.08 * exp(-((s - edge) / 0.012) ** 2)
    shade = 0.35 + 0.65 * min(1.0, 2 * sky)
    return diffuse * shade, specular, min(1.0, max(emissive, _hull_light(z, s, marks)))


def _hull_light(z, s, marks):
    """The glowing strips of the hull."""
    shoulder, belt, lip, sweep = marks
    light = strip(s - sweep, 0.017, 0.045, 0.42)
    light = max(light, 0.8 * strip(s - lip, 0.010, 0.03, 0.3))
    if z < -0.62 or z > 0.58:
        light = max(light, 0.95 * strip(s - shoulder, 0.012, 0.035, 0.35))
    for tip in (0.88, 1.06, 1.24, 1.42):
        if s < 0.105:
            light = max(light, strip((z - tip - 0.9 * s) * 0.74, 0.017, 0.03, 0.35) * min(1.0, (0.105 - s) * 60))
    for k in range(3):
        if belt + 0.04 < s < lip - 0.04:
            light = max(light, 0.9 * strip(z + 0.86 - 0.075 * k - 0.5 * (s - belt), 0.013, 0.02, 0.3))
    return light


def _fin(u, v):
    return 0.35, 0.7, max(0.24, strip(v, 0.30, 0.25, 0.5))


def _blade(u, v):
    return 0.30, 0.7, max(0.10, 0.8 * strip(v - 0.62, 0.16, 0.15, 0.4))


# ---- the wheels -----------------------------------------------------------------------------------------------------


def _tyre(u, v):
    """v: the side 0 to 0.28, the shoulder to 0.38, the tread to 0.5, and back again."""
    side = min(v, 1 - v)
    if side > 0.37:
        across = (0.5 - side) / 0.13
        groove = strip((u * 36 + 0.9 * across) % 1.0 - 0.5, 0.12)
        centre = strip(across, 0.16, 0.10, 0.3)
        edge = strip(across - 0.92, 0.10, 0.15, 0.4)
        return 0.10 - 0.07 * groove, 0.45 - 0.35 * groove, max(0.05 + 0.30 * groove, 0.9 * centre, edge)
    tick = (u * 24) % 1.0
    light = 0.55 if 0.17 < side < 0.20 and tick < 0.7 else 0.0
    return 0.08, 0.45, max(0.04, light, strip(side - 0.36, 0.012, 0.03, 0.4))


def _rim(u, v):
    """v: the lit side 0 to 0.25, its corner to 0.35, the groove within to 0.5, and back again."""
    side = min(v, 1 - v)
    if side < 0.28:
        return 0.3, 0.6, 1.0
    return 0.15, 0.8, 0.75 if side > 0.42 else 0.22


# ---- the rider ------------------------------------------------------------------------------------------------------


def _rider_layers():
    return [(atlas.SUIT, _leather(0.24, 0.5, 0.05, 0.21)), (atlas.BOOT, _leather(0.10, 0.7, 0.02, 0.08)), (atlas.HELMET, _helmet)]


def _leather(diffuse, specular, base, sky):
    """u: the distance from a line of light, whose glow fades; v: from looking down to looking up."""
    def texel(u, v):
        return diffuse * (0.4 + 0.6 * v), specular, base + sky * v ** 1.5 + 0.5 * exp(-u / 0.35) * (1 - u)
    return texel


def _above(u):
    """How far the helmet looks up at u: 0 below, 1 on top."""
    return 0.5 - 0.5 * cos(2 * pi * u)


def _helmet(u, v):
    """A crest line over the top, and a line along each side that runs into the crest at the nape."""
    x = abs(u - 0.5)
    light = strip(x, 0.024, 0.04, 0.4) if 0.16 < v < 0.80 else 0.0
    if 0.16 < v < 0.72:
        light = max(light, 0.9 * strip(x - 0.24 * min(1.0, (v - 0.16) / 0.22) ** 0.6, 0.016, 0.03, 0.35))
    if v < 0.14:
        return 0.12, 0.4, max(0.02 + 0.07 * _above(u), light)
    return 0.34, 0.85, max(0.05 + 0.24 * _above(u), light)


# ---- the glass ------------------------------------------------------------------------------------------------------


def _screen(u, v):
    """Dark, with a bright rim and two streaks, as if it mirrored a strip of sky."""
    rim = max(strip(v - 1.0, 0.06, 0.06, 0.4), strip(min(u, 1 - u), 0.05, 0.06, 0.3))
    slant = abs(u - 0.5) - 0.10 * v
    streak = 0.13 * strip(slant - 0.14, 0.035) + 0.07 * strip(slant - 0.22, 0.015)
    return 0.05, 0.95, max(0.03 + 0.09 * v + streak, rim)


def _visor(u, v):
    return 0.03, 0.95, 0.03 + 0.05 * _above(u)
