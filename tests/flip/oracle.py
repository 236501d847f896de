#!/usr/bin/env python3
"""Makes the pairs of pictures beside this script, with the error maps and figures of NVIDIA's own implementation of FLIP.

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 numpy
    venv/bin/python tests/flip/oracle.py            # the renders of our scene are made with ./cga

NAME.pair.gz is a line of text "KIND WIDTH HEIGHT PPD MEAN MAP_MEAN START STOP COUNT" (the last three are 0 for LDR) followed by, row by
row from the top and little-endian: the expected picture, the actual one (three bytes of sRGB a pixel for LDR, three linear 32-bit
floats for HDR), and the error map in 16 bits, 65535 being 1. MEAN is NVIDIA's own figure, which it sums up in float; MAP_MEAN is that of
its map, summed up in double. magma.txt holds the colour of each of the 256 steps of error.
"""
import gzip
import importlib.metadata
import pathlib
import subprocess
import tempfile

import flip_evaluator
import numpy

HERE = pathlib.Path(__file__).resolve().parent
VERSION = "1.7"
DEFAULT_PPD = 67.0206


def main():
    installed = importlib.metadata.version("flip-evaluator")
    assert installed == VERSION, f"flip-evaluator {VERSION} is wanted, {installed} is installed"
    total = 0
    for name, kind, expected, actual, ppd in pairs():
        total += write(name, kind, expected, actual, ppd)
    (HERE / "magma.txt").write_text("".join(f"{color}\n" for color in magma()))
    print(f"flip-evaluator {VERSION}, {total} bytes")


def evaluate(kind, expected, actual, ppd, magma=False):
    scale = 255 if kind == "LDR" else 1
    inputs = [(numpy.asarray(picture) / scale).astype(numpy.float32) for picture in (expected, actual)]
    return flip_evaluator.evaluate(*inputs, kind, inputsRGB=True, applyMagma=magma, parameters={"ppd": ppd})


def write(name, kind, expected, actual, ppd):
    expected, actual = (numpy.asarray(picture, numpy.uint8 if kind == "LDR" else "<f4") for picture in (expected, actual))
    errors, mean, used = evaluate(kind, expected, actual, ppd)
    height, width = expected.shape[:2]
    exposures = [used["startExposure"], used["stopExposure"], used["numExposures"]] if kind == "HDR" else [0, 0, 0]
    line = " ".join(map(str, [kind, width, height, ppd, mean, errors.mean(dtype=numpy.float64), *exposures]))
    quantized = numpy.rint(errors.astype(numpy.float64) * 65535).astype("<u2")
    content = line.encode() + b"\n" + expected.tobytes() + actual.tobytes() + quantized.tobytes()
    packed = gzip.compress(content, 9, mtime=0)
    (HERE / f"{name}.pair.gz").write_bytes(packed)
    print(f"{name:24} {len(packed):7} {line}")
    return len(packed)


def pairs():
    """Name, kind, expected and actual picture, pixels per degree."""
    ldr = lambda picture: numpy.rint(numpy.clip(picture, 0, 1) * 255).astype(numpy.uint8)
    noise = numpy.random.default_rng(20200713)

    yield "ldr-1x1", "LDR", [[[200, 40, 90]]], [[[190, 60, 80]]], DEFAULT_PPD
    yield "ldr-3x2", "LDR", ldr(noise.random((2, 3, 3))), ldr(noise.random((2, 3, 3))), DEFAULT_PPD
    flat = numpy.ones((24, 32, 3))
    yield "ldr-black-white", "LDR", ldr(0 * flat), ldr(flat), DEFAULT_PPD
    yield "ldr-green-blue", "LDR", ldr(flat * [0, 1, 0]), ldr(flat * [0, 0, 1]), DEFAULT_PPD
    noisy = ldr(noise.random((40, 50, 3)))
    yield "ldr-identical", "LDR", noisy, noisy, DEFAULT_PPD
    yield "ldr-noise", "LDR", noisy, ldr(noisy / 255 + noise.normal(0, 0.1, noisy.shape)), DEFAULT_PPD
    waves = rings(97, 61, 0)
    yield "ldr-shifted-rings", "LDR", ldr(waves), ldr(rings(97, 61, 1)), DEFAULT_PPD
    yield "ldr-one-level", "LDR", ldr(waves), ldr(waves + 1 / 255), DEFAULT_PPD
    yield "ldr-narrow", "LDR", ldr(rings(7, 90, 0)), ldr(rings(7, 90, 2)), DEFAULT_PPD
    yield "ldr-flat", "LDR", ldr(rings(90, 5, 0)), ldr(rings(90, 5, 2)), 40.0
    checks = (numpy.indices((64, 64)).sum(0) % 2)[..., None] * numpy.ones(3)
    yield "ldr-checks-20", "LDR", ldr(checks), ldr(1 - checks), 20.0
    spot = numpy.full((60, 80, 3), 0.5)
    spot[30, 40] = 1, 0, 0
    yield "ldr-one-pixel-120", "LDR", ldr(spot * 0 + 0.5), ldr(spot), 120.0

    with tempfile.TemporaryDirectory() as folder:
        render = Renderer(folder)
        final = render.png("160x90", "--step", "4.7")
        yield "ldr-phong", "LDR", final, render.png("160x90", "--step", "4.7", "--specular", "phong"), DEFAULT_PPD
        yield "ldr-next-moment-30", "LDR", final, render.png("160x90", "--step", "4.7", "--t", "5.4"), 30.0
        yield "ldr-gamma", "LDR", render.png("200x112", "--step", "4.3"), render.png("200x112", "--step", "4.3", "--gamma", "1.1"), 100.0
        lit = render.exr("96x54", "--step", "4.3")
        yield "hdr-attenuation", "HDR", lit, render.exr("96x54", "--step", "4.3.4"), DEFAULT_PPD
        yield "hdr-black-scene", "HDR", render.exr("64x36", "--step", "4.1"), render.exr("64x36", "--step", "4.2"), 30.0
        yield "hdr-bright-scene", "HDR", half(lit * 500 + 1), half(lit * 490 + 1.1), DEFAULT_PPD

    yield "hdr-1x1", "HDR", [[[3.0, 0.5, 0.25]]], [[[2.5, 0.75, 0.25]]], DEFAULT_PPD
    yield "hdr-5x3", "HDR", half(10 ** noise.uniform(-2, 3, (3, 5, 3))), half(10 ** noise.uniform(-2, 3, (3, 5, 3))), DEFAULT_PPD
    ramp = 10 ** numpy.linspace(-3, 3, 72)[None, :, None] * (0.2 + rings(72, 40, 0))
    yield "hdr-ramp", "HDR", half(ramp), half(ramp * 1.1), DEFAULT_PPD
    yield "hdr-ramp-20", "HDR", half(ramp), half(ramp + 0.05), 20.0
    yield "hdr-identical", "HDR", half(ramp), half(ramp), DEFAULT_PPD
    sky = 0.3 + rings(48, 40, 0)
    sun = sky.copy()
    sun[10:13, 20:23] = 1e4
    yield "hdr-sun-moved", "HDR", half(sun), half(numpy.roll(sun, 3, axis=1)), DEFAULT_PPD
    yield "hdr-one-brightness", "HDR", flat[:8, :9] * 0.5, flat[:8, :9] * 0.6, DEFAULT_PPD
    yield "hdr-huge", "HDR", sky.astype("f4") * 1e14, (sky * 1.05).astype("f4") * 1e14, DEFAULT_PPD
    night = sky.copy()
    night[:25] = 0
    yield "hdr-mostly-black", "HDR", half(night), half(night + 1e-3), DEFAULT_PPD
    yield "hdr-negative", "HDR", half(sky), half(sky - 0.5), DEFAULT_PPD


def half(picture):
    """Rounded as OpenEXR stores it: half the bytes to pack."""
    return numpy.asarray(picture).astype(numpy.float16).astype(numpy.float32)


def rings(width, height, shift):
    """Coloured rings that get finer outwards, 0..1."""
    y, x = numpy.mgrid[0:height, 0:width]
    distance = numpy.hypot(x - width / 2 - shift, y - height / 2)
    return 0.5 + 0.5 * numpy.cos(distance[..., None] ** 1.5 * numpy.array([0.1, 0.15, 0.2]))


class Renderer:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def png(self, size, *options):
        return numpy.rint(self._render("out", "png", size, options) * 255).astype(numpy.uint8)

    def exr(self, size, *options):
        return half(self._render("float", "exr", size, options))

    def _render(self, option, kind, size, options):
        file = self.folder / f"picture.{kind}"
        subprocess.run([HERE.parents[1] / "cga", "render", "--size", size, f"--{option}", file, *options], check=True)
        return flip_evaluator.load(str(file))


def magma():
    """The colour that the reference draws each step of error in, found by trying colours until every step was seen."""
    seen = {}
    for share in numpy.linspace(0, 1, 20001):
        expected, actual = [[[0, 255 * share, 0]]], [[[0, 0, 255 * share]]]
        error = evaluate("LDR", expected, actual, DEFAULT_PPD)[0].item()
        step = int(numpy.float32(error) * numpy.float32(255) + numpy.float32(0.5))
        if step not in seen:
            drawn = evaluate("LDR", expected, actual, DEFAULT_PPD, magma=True)[0].ravel()
            seen[step] = "".join(f"{int(255 * channel + 0.5):02x}" for channel in drawn.tolist())
    assert sorted(seen) == list(range(256)), f"not seen: {sorted(set(range(256)) - set(seen))}"
    return [seen[step] for step in range(256)]


if __name__ == "__main__":
    main()
