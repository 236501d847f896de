"""Makes motorcycle.obj, motorcycle.mtl and their textures, beside this script: `python3 make_motorcycle.py`.

Y is up, the bike looks along -Z, its wheels stand on y = 0. See ../README.md.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "make"))

from atlas import HULL  # noqa: E402
from fittings import make_fittings  # noqa: E402
from hull import make_hull  # noqa: E402
from material import write_mtl  # noqa: E402
from model import save_model  # noqa: E402
from rider import make_rider  # noqa: E402
from textures import write_textures  # noqa: E402
from wheels import FRONT, REAR, make_wheel  # noqa: E402

SHININESS = {"body": 60, "tyre": 30, "rim": 80, "glass": 120, "rider": 40, "trim": 70, "glow": 40}


def main():
    parts = [make_hull(HULL)] + make_wheel(FRONT) + make_wheel(REAR) + make_rider() + make_fittings()
    write_textures(HERE)
    write_mtl(HERE / "motorcycle.mtl", SHININESS)
    save_model(HERE / "motorcycle.obj", "motorcycle.mtl", parts, (-0.4, 0.0, -1.8), (0.4, 1.35, 1.8), (10_000, 40_000))


if __name__ == "__main__":
    main()
