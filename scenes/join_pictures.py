#!/usr/bin/env python3
#===- join_pictures.py - One picture of many ------------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Joins pictures of one shape, three in a row, each with its file's name.

Usage: join_pictures.py JOINED.png WIDTH PICTURE.png...

WIDTH: of each picture in the result, in pixels.
"""

import os
import sys

from PIL import Image, ImageDraw, ImageFont, ImageOps

PER_ROW = 3
LABEL_HEIGHT = 16
# Of each component: noise makes large files.
BITS = 6


def tile(path, width):
    with Image.open(path) as picture:
        height = picture.height * width // picture.width
        result = picture.convert("RGB").resize(
            (width, height), Image.Resampling.LANCZOS)
    draw = ImageDraw.Draw(result)
    draw.rectangle([0, height - LABEL_HEIGHT, width, height], fill="black")
    name = os.path.splitext(os.path.basename(path))[0].replace("_", " ")
    draw.text((4, height - LABEL_HEIGHT + 2), name, fill="white",
              font=ImageFont.load_default())
    return result


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    target, width, paths = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    tiles = [tile(path, width) for path in paths]
    rows = -(-len(tiles) // PER_ROW)
    height = max(picture.height for picture in tiles)
    joined = Image.new("RGB", (PER_ROW * width, rows * height))
    for number, picture in enumerate(tiles):
        joined.paste(picture, (number % PER_ROW * width,
                               number // PER_ROW * height))
    ImageOps.posterize(joined, BITS).save(target, optimize=True)


main()
