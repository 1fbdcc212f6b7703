# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reads PNG and netpbm images, and says how two of them differ."""

import struct
import zlib
from dataclasses import dataclass

_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_PNG_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


class ImageError(Exception):
    """The bytes are no image that can be read."""


@dataclass(frozen=True)
class Image:
    """Samples of 8 bits, row by row."""

    width: int
    height: int
    channels: int
    samples: bytes

    def shape(self):
        """Size and channels in words."""
        return f"{self.width}x{self.height} with {self.channels} channels"


def read_image(data):
    """The image in a file's bytes; None if they are of another format."""
    if data.startswith(_PNG_SIGNATURE):
        return _read_png(data)
    if data[:2] in (b"P5", b"P6"):
        return _read_netpbm(data)
    return None


def describe_difference(expected, actual, tolerance):
    """How two images differ by more than `tolerance` a sample; None if they
    do not."""
    if expected.shape() != actual.shape():
        return f"an image of {actual.shape()} instead of {expected.shape()}"
    worst, worst_place, count = 0, 0, 0
    for place, (a, b) in enumerate(zip(expected.samples, actual.samples)):
        distance = abs(a - b)
        if distance > tolerance:
            count += 1
            if distance > worst:
                worst, worst_place = distance, place
    if not count:
        return None
    pixel = worst_place // expected.channels
    return (
        f"{count} samples differ, by {worst} at pixel "
        f"({pixel % expected.width}, {pixel // expected.width})"
    )


def _png_chunks(data):
    place = len(_PNG_SIGNATURE)
    while place + 8 <= len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        yield kind, data[place + 8 : place + 8 + length]
        place += length + 12


def _read_png(data):
    header, packed = None, b""
    for kind, body in _png_chunks(data):
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
    if header is None:
        raise ImageError("a PNG without header")
    width, height, depth, color, _, _, interlace = header
    if depth != 8 or color not in _PNG_CHANNELS or interlace:
        raise ImageError("only PNGs of 8 bits, not interlaced, can be compared")
    channels = _PNG_CHANNELS[color]
    try:
        rows = zlib.decompress(packed)
    except zlib.error as error:
        raise ImageError(f"a damaged PNG ({error})") from error
    if len(rows) < height * (width * channels + 1):
        raise ImageError("a PNG that ends too early")
    return Image(width, height, channels, _unfilter(rows, width, height, channels))


def _unfilter(rows, width, height, channels):
    stride = width * channels
    above = bytearray(stride)
    samples = bytearray()
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(rows[start + 1 : start + 1 + stride])
        _unfilter_row(rows[start], row, above, channels)
        samples += row
        above = row
    return bytes(samples)


def _unfilter_row(kind, row, above, channels):
    if kind == 0:
        return
    for x, value in enumerate(row):
        left = row[x - channels] if x >= channels else 0
        corner = above[x - channels] if x >= channels else 0
        row[x] = (value + _predict(kind, left, above[x], corner)) & 0xFF


def _predict(kind, left, up, corner):
    if kind == 1:
        return left
    if kind == 2:
        return up
    if kind == 3:
        return (left + up) // 2
    if kind == 4:
        guess = left + up - corner
        return min((left, up, corner), key=lambda value: abs(guess - value))
    raise ImageError("a PNG with an unknown filter")


def _read_netpbm(data):
    words, place = [], 2
    while len(words) < 3:
        line_end = data.find(b"\n", place)
        if data[place : place + 1] == b"#":
            place = line_end + 1
        elif data[place : place + 1].isspace():
            place += 1
        else:
            begin = place
            while data[place : place + 1].isdigit():
                place += 1
            if place == begin:
                raise ImageError("a damaged netpbm header")
            words.append(int(data[begin:place]))
    width, height, greatest = words
    channels = 3 if data[:2] == b"P6" else 1
    samples = data[place + 1 :]
    if greatest != 255 or len(samples) < width * height * channels:
        raise ImageError("only whole netpbm images of 8 bits can be compared")
    return Image(width, height, channels, samples[: width * height * channels])
