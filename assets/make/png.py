"""A PNG writer for grey pictures of 8 bits."""

import struct
import zlib


def write_png(path, width, height, grey):
    """Writes `grey` (one byte a pixel, row by row from the top) to `path`."""
    if len(grey) != width * height:
        raise ValueError(f"{path}: {len(grey)} bytes do not make {width}x{height} pixels")
    rows = [grey[y * width:(y + 1) * width] for y in range(height)]
    body = b"".join(_filtered(row, above) for row, above in zip(rows, [bytes(width)] + rows))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, payload in ((b"IHDR", header), (b"IDAT", zlib.compress(body, 9)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(payload)) + kind + payload)
            file.write(struct.pack(">I", zlib.crc32(kind + payload)))


def _filtered(row, above):
    """The row behind its filter byte: unfiltered (0), left (1) or up (2), whichever has the smallest residuals."""
    candidates = (
        (0, row),
        (1, bytes((a - b) & 255 for a, b in zip(row, b"\0" + row))),
        (2, bytes((a - b) & 255 for a, b in zip(row, above))),
    )
    kind, best = min(candidates, key=lambda c: sum(min(v, 256 - v) for v in c[1]))
    return bytes((kind,)) + best
