#!/usr/bin/python3
"""Lays pictures side by side (or one alone), scales them to a width and writes a PNG of few colours.

    compose.py OUTPUT.png WIDTH_PX [--crop X0,Y0,X1,Y1] PICTURE [PICTURE]

The crop is in shares of each picture's width and height. Needs python3-pil.
"""
import argparse

from PIL import Image

GAP_PX = 12
MOST_COLOURS = 255


def cropped(path, crop):
    picture = Image.open(path).convert("RGB")
    if crop:
        left, top, right, bottom = (float(share) for share in crop.split(","))
        width, height = picture.size
        picture = picture.crop((round(left * width), round(top * height), round(right * width), round(bottom * height)))
    return picture


def side_by_side(pictures, width):
    """All of one height, `width` pixels wide together."""
    shares = [picture.width / picture.height for picture in pictures]
    height = round((width - GAP_PX * (len(pictures) - 1)) / sum(shares))
    sheet = Image.new("RGB", (width, height), "white")
    left = 0
    for picture, share in zip(pictures, shares):
        scaled = picture.resize((round(share * height), height), Image.LANCZOS)
        sheet.paste(scaled, (left, 0))
        left += scaled.width + GAP_PX
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output")
    parser.add_argument("width", type=int)
    parser.add_argument("pictures", nargs="+")
    parser.add_argument("--crop")
    arguments = parser.parse_args()
    sheet = side_by_side([cropped(path, arguments.crop) for path in arguments.pictures], arguments.width)
    sheet.quantize(MOST_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(arguments.output, optimize=True)


if __name__ == "__main__":
    main()
