"""What is fastened to the hull: screen, lamps, handlebars, fins and the blades that hold the hubless wheels."""

from math import cos, pi, radians, sin

from atlas import BLADE, FIN, SCREEN, WHOLE
from hull import BELT, SHOULDER, features
from shape import closed_loft, plate, spline, tube
from wheels import FRONT, REAR



def make_fittings():
    sides = _blades() + _fins() + _handlebar()
    return [_screen(), *_headlight(), _tail_light(), _clamp(REAR, -1), _clamp(FRONT, 1)] + sides + [part.mirrored() for part in sides]


def _screen():
    """A dark bubble on the front cowl, open to the rider."""
    rings, uvs = [], []
    for i in range(17):
        t = i / 16
        z = -1.12 + 0.62 * t
        x, y = features(z)[SHOULDER]
        crest = features(z)[0][1]
        wide = x * (0.35 + 0.75 * min(1.0, t * 2.2) ** 0.8) + 0.004
        base, top = y - 0.02, crest + 0.012 + 0.135 * t ** 1.3
        arc = [pi * k / 16 for k in range(17)]
        outer = [(wide * cos(a), base + (top - base) * sin(a) ** 0.8, z) for a in arc]
        inner = [((wide - 0.012) * cos(a), base - 0.01 + (top - base - 0.012) * sin(a) ** 0.8, z) for a in reversed(arc)]
        loop = outer + inner
        rings.append(loop + loop[:1])
        v = SCREEN[1] + (SCREEN[3] - SCREEN[1]) * t
        row = [(k / 16, v) for k in range(17)] + [(k / 16, v) for k in range(16, -1, -1)]
        uvs.append(row + row[:1])
    return closed_loft("glass", rings, uvs, ((0.5, SCREEN[1]), (0.5, SCREEN[3])), crease=40.0)


def _headlight():
    def bar(material, reach, radius, z):
        return tube(material, [(x * reach, 0.640, z) for x in (-1.0, -0.3, 0.3, 1.0)], [(radius, radius * 0.8)] * 4, WHOLE, 14)
    return [bar("trim", 0.085, 0.052, -1.722), bar("glow", 0.078, 0.032, -1.754)]


def _tail_light():
    """A thin bar across the end of the tail, its tips drawn forward along the belt."""
    path = spline([(-0.172, 0.986, 1.63), (-0.136, 0.968, 1.705), (-0.06, 0.962, 1.728), (0.0, 0.961, 1.732), (0.06, 0.962, 1.728),
                   (0.136, 0.968, 1.705), (0.172, 0.986, 1.63)], 19)
    sizes = [(0.014, 0.010 + 0.010 * sin(pi * k / 18)) for k in range(19)]
    return tube("glow", path, sizes, WHOLE, 10)


def _fins():
    """A winglet on the tail, swept back and up."""
    outline = [(1.18, 0.0), (1.60, 0.0), (1.74, 0.135), (1.70, 0.155), (1.50, 0.13), (1.30, 0.06)]
    outline = _counter_clockwise([(b, a) for a, b in outline])

    def place(out, z, h):
        x, y = features(min(z, 1.6))[BELT]
        return (x - 0.03 + out * 0.86 - h * 0.5, y + 0.015 + out * 0.5 + h * 0.86, z)
    return [plate("body", outline, 0.024, 0.008, place, FIN)]


def _blades():
    """What holds the hubless wheels: on each side an anchor from the hull, whose arc grips the rim."""
    return [_anchor(wheel, hull_side, room) for wheel, hull_side, room in ((REAR, -1, 0.20), (FRONT, 1, 0.21))]


def _anchor(wheel, way, root):
    """The arc lies within the rim's hole, on the side of the hull (`way` along z); the shaft leans in to x = `root`."""
    within, beyond = wheel.hole - 0.05, wheel.hole + 0.05
    outline = [_polar(within, -40 + 10 * k) for k in range(9)]
    outline += [_polar(beyond, 40 - 8 * k) for k in range(4)]
    outline += [(beyond + 0.05, 0.075), (wheel.radius, 0.085), (wheel.radius + 0.14, 0.10)]
    outline += [(a, -b) for a, b in reversed(outline[9:])]
    outer = wheel.half_width + 0.034

    def place(a, b, h):
        lean = max(0.0, min(1.0, (a - beyond) / (wheel.radius + 0.14 - beyond)))
        return (outer + (root - outer) * lean + h, wheel.radius + b, wheel.z + way * a)
    return plate("body", _counter_clockwise(outline), 0.042, 0.010, place, BLADE)


def _clamp(wheel, way):
    """A bar through the rim's hole, from anchor to anchor."""
    reach, z = wheel.half_width + 0.03, wheel.z + way * (wheel.hole - 0.012)
    return tube("trim", [(x * reach, wheel.radius, z) for x in (-1.0, -0.5, 0.5, 1.0)], [(0.022, 0.075)] * 4, WHOLE, 12)


def _polar(radius, degrees):
    return radius * cos(radians(degrees)), radius * sin(radians(degrees))


def _handlebar():
    bar = spline([(0.10, 0.96, -0.62), (0.20, 0.93, -0.64), (0.30, 0.895, -0.62), (0.355, 0.886, -0.588)], 8)
    tip = [(0.350, 0.8865, -0.590), (0.362, 0.885, -0.584), (0.374, 0.883, -0.578)]
    return [tube("trim", bar, [(0.022, 0.022)] * 8, WHOLE, 10), tube("glow", tip, [(0.021, 0.021)] * 3, WHOLE, 10, round_ends=(2, 2))]


def _counter_clockwise(points):
    area = sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(points, points[1:] + points[:1]))
    return points if area > 0 else points[::-1]
