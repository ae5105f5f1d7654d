# SPDX-License-Identifier: BSD-3-Clause
"""As much of PNG as it takes to lay the program's pictures side by side: 8 bits, RGB or RGBA, not interlaced."""
import struct
import zlib
from pathlib import Path

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _chunks(data):
    at = len(SIGNATURE)
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def _paeth(a, b, c):
    nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))
    return nearest[2]


def _unfilter(kind, line, above, step):
    """In place; `step` bytes a pixel."""
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        add = (0, left, above[i], (left + above[i]) // 2, _paeth(left, above[i], corner))[kind]
        line[i] = (line[i] + add) & 255


def read(file):
    """(width, rows): each row the bytes R, G, B of its pixels. Raises ValueError for what is no such picture."""
    data = Path(file).read_bytes()
    if not data.startswith(SIGNATURE):
        raise ValueError(f"{file}: is no PNG picture")
    chunks = list(_chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", chunks[0][1])
    if depth != 8 or colour not in (2, 6) or interlaced:
        raise ValueError(f"{file}: is not of 8 bits RGB or RGBA")
    step = 3 if colour == 2 else 4
    raw = zlib.decompress(b"".join(content for kind, content in chunks if kind == b"IDAT"))
    rows, above = [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        line = bytearray(raw[start + 1:start + 1 + width * step])
        if raw[start]:
            _unfilter(raw[start], line, above, step)
        rows.append(bytes(line) if step == 3 else b"".join(bytes(line[i:i + 3]) for i in range(0, len(line), 4)))
        above = line
    return width, rows


def write(file, width, rows):
    """Rows of RGB bytes, each filtered against the one above, which packs pictures of flat colours well."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    packed, above = bytearray(), bytes(3 * width)
    for row in rows:
        packed.append(2)
        packed += bytes((a - b) & 255 for a, b in zip(row, above))
        above = row
    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    Path(file).write_bytes(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(packed), 9))
                           + chunk(b"IEND", b""))


# 32 steps of each colour instead of 256: a third of the size, and hardly to be seen.
COARSE = bytes((value & 0xF8) | value >> 5 for value in range(256))


def side_by_side(files, out):
    """One picture of several of the same height, from left to right, in coarser colours."""
    pictures = [read(file) for file in files]
    if len({len(rows) for _, rows in pictures}) != 1:
        raise ValueError(f"{files[0]} and the others are not of one height")
    rows = [b"".join(parts).translate(COARSE) for parts in zip(*(rows for _, rows in pictures))]
    write(out, sum(width for width, _ in pictures), rows)
