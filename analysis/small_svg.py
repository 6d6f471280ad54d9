"""Matplotlib's SVG made fit for a page that holds many: small, ids unique."""

from __future__ import annotations

import base64
import io
import re
import zlib

import numpy as np
from PIL import Image

_IMAGE = re.compile(r'data:image/png;base64,([^"]*)')
# Coordinates in points: a hundredth is finer than any screen. The outlines of
# letters have units of their own and no decimals to lose.
_PATH = re.compile(r' d="[^"]*"')
_PLACE = re.compile(r' (x|y|transform)="[^"]*"')
# Nothing refers to them, and equal pictures have equal ones.
_IMAGE_ID = re.compile(r' id="image[0-9a-f]*"')
_INDENT = re.compile(r"\n\s+")
_LONG = re.compile(r"(\d\.\d\d)\d+")


def inline(svg: str, key: str) -> str:
    """The <svg> element alone, its ids made unique by `key` in a page of many."""
    body = _INDENT.sub("\n", svg[svg.index("<svg") :])
    body = _IMAGE_ID.sub("", body)
    body = body.replace("DejaVuSans-", "d").replace("xlink:href", "href")
    body = body.replace("; stroke-linecap: square", "")
    body = _PATH.sub(lambda found: _LONG.sub(r"\1", _one_line(found[0])), body)
    body = _PLACE.sub(lambda found: _rounded_place(found[0]), body)
    own = f"{zlib.crc32(key.encode()):x}"
    for mark in ('id="', 'href="#', "url(#"):
        body = body.replace(mark, f"{mark}f{own}-")
    return _IMAGE.sub(
        lambda found: f"data:image/png;base64,{_small_png(found[1])}", body
    )


def _one_line(path: str) -> str:
    return path.replace(" \n", " ").replace("\n", " ")


def _rounded_place(attribute: str) -> str:
    """Only whole pictures are placed by a matrix; scales keep their digits."""
    if "scale" in attribute or "matrix" in attribute:
        return attribute
    return _LONG.sub(r"\1", attribute)


def _small_png(text: str) -> str:
    """The same pixels: with a palette if they have few colours, and without
    the transparency that no picture here has.
    """
    picture = Image.open(io.BytesIO(base64.b64decode(text)))
    small = picture.convert("RGB")
    if picture.mode == "RGBA" and picture.getextrema()[3][0] < 255:
        small = picture
    elif small.getcolors(256) is not None:
        small = _with_palette(small)
    packed = io.BytesIO()
    small.save(packed, format="png", optimize=True)
    return base64.b64encode(packed.getvalue()).decode()


def _with_palette(picture: Image.Image) -> Image.Image:
    pixels = np.asarray(picture).astype(np.uint32)
    packed = (pixels[..., 0] << 16) | (pixels[..., 1] << 8) | pixels[..., 2]
    colours, places = np.unique(packed, return_inverse=True)
    indexed = Image.fromarray(places.reshape(packed.shape).astype(np.uint8))
    indexed.putpalette(b"".join(int(c).to_bytes(3, "big") for c in colours))
    return indexed
