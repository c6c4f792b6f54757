#!/usr/bin/env python3
"""Makes the three textures of this folder, 24-bit BMP files that repeat in both directions: ./make_textures.py [FOLDER]."""
import math
import pathlib
import struct
import sys

SIDE = 256


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth_step(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def thread_shade(x, y, period):
    """Brightness of a plain weave, threads over and under in turns, each rounded across its width."""
    column, row = x // period, y // period
    across = (x % period + 0.5) / period if (column + row) % 2 else (y % period + 0.5) / period
    return 0.88 + 0.12 * math.sin(math.pi * across)


def weave(x, y):
    """A checked cloth: two colours of thread each way, so four blocks of three colours, with thin lines between."""
    cream, blue, rust = (238, 231, 216), (58, 92, 124), (186, 92, 62)

    def dyed(position):
        at = position % 128
        return 1.0 if at < 64 else 0.0

    def lined(position):
        return 1.0 if position % 128 in range(92, 98) else 0.0

    period = 4
    warp_on_top = (x // period + y // period) % 2
    position = x if warp_on_top else y
    colour = mix(cream, blue, 0.92 * dyed(position))
    colour = mix(colour, rust, 0.9 * lined(position))
    # Threads are finer than a texel shows from afar, so most of the mixing is done here.
    both = mix(mix(cream, blue, 0.46 * (dyed(x) + dyed(y))), rust, 0.45 * max(lined(x), lined(y)))
    return mix(both, colour, 0.35), thread_shade(x, y, period)


def stripe(x, y):
    """Broad stripes along y, each with a thin companion, on a twill."""
    ground, broad, thin = (233, 226, 210), (176, 74, 62), (66, 84, 96)
    at = x % 128
    colour = mix(ground, broad, smooth_step(19.0, 21.0, at) - smooth_step(67.0, 69.0, at))
    for start in (77, 6):
        colour = mix(colour, thin, smooth_step(start - 0.5, start + 0.5, at) - smooth_step(start + 4.5, start + 5.5, at))
    twill = ((x + y) % 8) / 8.0
    return colour, 0.93 + 0.07 * math.sin(2.0 * math.pi * twill)


def printed(x, y):
    """Waves of the sea (seigaiha): rings that overlap like scales, printed in indigo."""
    paper, ink = (236, 234, 226), (38, 66, 110)
    radius, rise = 64.0, 32.0
    for row in range(-2, SIDE // int(rise) + 4):
        # Scales lower in the picture lie over those above; y grows upwards.
        centre_y = row * rise - radius
        offset = 0.0 if row % 2 == 0 else radius
        nearest = round((x + 0.5 - offset) / (2.0 * radius)) * 2.0 * radius + offset
        distance = math.hypot(x + 0.5 - nearest, y + 0.5 - centre_y)
        if distance <= radius and y + 0.5 >= centre_y:
            bands = 0.0
            for outer, inner in ((64.0, 58.0), (50.0, 40.0), (32.0, 24.0), (15.0, 0.0)):
                bands = max(bands, smooth_step(inner - 0.8, inner + 0.8, distance) * smooth_step(outer + 0.8, outer - 0.8, distance)
                            if inner > 0.0 else smooth_step(outer + 0.8, outer - 0.8, distance))
            return mix(paper, ink, bands), thread_shade(x, y, 2)
    return ink, 1.0


def write_bmp(path, pattern):
    pixels = bytearray()
    for y in range(SIDE):
        for x in range(SIDE):
            colour, shade = pattern(x, y)
            r, g, b = (round(min(max(c * shade, 0.0), 255.0)) for c in colour)
            pixels += bytes((b, g, r))
    header = struct.pack("<2sIHHI", b"BM", 54 + len(pixels), 0, 0, 54)
    header += struct.pack("<IiiHHIIiiII", 40, SIDE, SIDE, 1, 24, 0, len(pixels), 2835, 2835, 0, 0)
    path.write_bytes(header + pixels)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    for name, pattern in (("weave", weave), ("stripe", stripe), ("print", printed)):
        write_bmp(folder / f"{name}.bmp", pattern)


if __name__ == "__main__":
    main()
