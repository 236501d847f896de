#!/usr/bin/env python3
"""Times our FLIP and NVIDIA's on the same pictures in memory, in turns, each with all processors that it is given.

    taskset -c 0,1 venv/bin/python tests/flip/bench.py [ROUNDS [WIDTHxHEIGHT]]      # venv: see oracle.py

Prints the median of ROUNDS (default 9) after two rounds of warm-up: milliseconds that passed, milliseconds of processor time, the mean.
"""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import flip_evaluator
import numpy

from oracle import HERE, Renderer

WARM_UP = 2


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    size = sys.argv[2] if len(sys.argv) > 2 else "1920x1080"
    with tempfile.TemporaryDirectory() as folder:
        render = Renderer(folder)
        expected = render.exr(size, "--step", "4.3")
        actual = render.exr(size, "--step", "4.3.4")
        ours = Ours(folder, expected, actual)
        for kind in ("LDR", "HDR"):
            runs = [(nvidia(kind, expected, actual), ours.run(kind)) for _ in range(WARM_UP + rounds)][WARM_UP:]
            for name, results in zip(("flip-evaluator", "ours"), zip(*runs)):
                passed, processor, mean = (statistics.median(column) for column in zip(*results))
                print(f"{kind} {size} {name:15} {passed:8.0f} ms {processor:8.0f} ms of processor time, mean {mean:.7f}")


def nvidia(kind, expected, actual):
    if kind == "LDR":
        expected, actual = (numpy.rint(numpy.clip(picture, 0, 1) * 255).astype("f4") / 255 for picture in (expected, actual))
    start, processor = time.perf_counter(), time.process_time()
    mean = flip_evaluator.evaluate(expected, actual, kind, applyMagma=False, parameters={"ppd": 67.0206})[1]
    return 1e3 * (time.perf_counter() - start), 1e3 * (time.process_time() - processor), mean


class Ours:
    def __init__(self, folder, expected, actual):
        project = HERE.parents[1]
        build = project / "target"
        subprocess.run(["mvn", "-B", "-q", "test-compile"], cwd=project, check=True)
        stdlib = max(pathlib.Path.home().glob(".m2/repository/org/jetbrains/kotlin/kotlin-stdlib/*/kotlin-stdlib-*.jar"))
        height, width = expected.shape[:2]
        files = [pathlib.Path(folder) / f"{name}.raw" for name in ("expected", "actual")]
        for file, picture in zip(files, (expected, actual)):
            file.write_bytes(numpy.dstack([picture, numpy.ones((height, width))]).astype("<f4").tobytes())
        classpath = f"{build}/classes:{build}/test-classes:{stdlib}"
        command = ["java", "-cp", classpath, "cga.imaging.flip.FlipBench", width, height, *files]
        self.process = subprocess.Popen([str(word) for word in command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def run(self, kind):
        print(kind, file=self.process.stdin, flush=True)
        return [float(word) for word in self.process.stdout.readline().split()]


if __name__ == "__main__":
    main()
