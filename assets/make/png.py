"""A PNG writer: 8 bits a channel, grey or RGB, standard library only."""

import struct
import zlib


def write_png(path, width, height, channels, data):
    """Writes `data` (bytes, row by row from the top, `channels` = 1 or 3 bytes a pixel) to `path`."""
    if channels not in (1, 3) or len(data) != width * height * channels:
        raise ValueError(f"{path}: {len(data)} bytes do not make {width}x{height}x{channels}")
    stride = width * channels
    rows = [data[y * stride:(y + 1) * stride] for y in range(height)]
    body = b"".join(_filtered(row, rows[y - 1] if y else bytes(stride), channels) for y, row in enumerate(rows))
    header = struct.pack(">IIBBBBB", width, height, 8, 0 if channels == 1 else 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, payload in ((b"IHDR", header), (b"IDAT", zlib.compress(body, 9)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(payload)) + kind + payload)
            file.write(struct.pack(">I", zlib.crc32(kind + payload)))


def _filtered(row, above, channels):
    """The row behind its filter byte: unfiltered (0), left (1) or up (2), whichever has the smallest residuals."""
    left = bytes(channels) + row[:-channels]
    candidates = (
        (0, row),
        (1, bytes((a - b) & 255 for a, b in zip(row, left))),
        (2, bytes((a - b) & 255 for a, b in zip(row, above))),
    )
    kind, best = min(candidates, key=lambda c: sum(min(v, 256 - v) for v in c[1]))
    return bytes((kind,)) + best
