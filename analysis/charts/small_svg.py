"""Matplotlib's SVG made fit for a page that holds many: small, ids unique.

Matplotlib writes an element and its whole style for each mark, nested in groups
that say what it was made from. What is painted, and in which order, is all that
a page needs: elements in a row that look the same share one group.
"""

from __future__ import annotations

import base64
import dataclasses
import io
import re
import zlib
from collections.abc import Iterator
from itertools import groupby
from typing import Final
from xml.etree import ElementTree
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from PIL import Image

from analysis.charts.svg_paths import Step, moved, number, short, steps

FONT_FAMILY: Final = "DejaVu Sans,Verdana,sans-serif"

_IMAGE = re.compile(r"data:image/png;base64,(.*)", re.DOTALL)
_NUMBER = re.compile(r"-?\d+\.\d+")
_FONT = re.compile(r"(?:(\w+) )?(?:(\w+) )?([\d.]+)px .*")
_UPRIGHT = re.compile(r"rotate\(-?0 [^)]*\)")
# Points, of which a tenth is finer than any screen; but a mark is small.
_PLACE_DECIMALS = 1
_MARK_DECIMALS = 2
_MARK_REACH = 24  # what has a coordinate beyond is no mark

# What a group may say for all that is in it.
_INHERITED = frozenset(
    ["fill", "fill-opacity", "fill-rule", "stroke", "stroke-width"]
    + ["stroke-opacity", "stroke-dasharray", "stroke-dashoffset"]
    + ["stroke-linejoin", "font-size", "font-weight", "font-style", "text-anchor"]
)
_DEFAULTS = {"text-anchor": "start", "stroke-dashoffset": "0"}

Attributes = dict[str, str]


@dataclasses.dataclass
class _Leaf:
    """An element that paints, or a definition."""

    tag: str
    own: Attributes
    look: Attributes
    clip: str = ""
    body: str = ""  # what stands between its tags, escaped

    def same_look(self) -> tuple[str, tuple[tuple[str, str], ...]]:
        return self.clip, tuple(sorted(self.look.items()))


def inline(svg: str, key: str) -> str:
    """The <svg> element alone, its ids made unique by `key` in a page of many."""
    root = ElementTree.fromstring(svg[svg.index("<svg") :])
    leaves = _leaves(root, "")
    marks, clips = _definitions(root)
    used = [leaf.own["href"] for leaf in leaves if leaf.tag == "use"]
    leaves = [_finished(leaf, marks, used) for leaf in leaves]
    # By then a mark is named by its shape.
    shapes = dict.fromkeys(leaf.own["href"] for leaf in leaves if leaf.tag == "use")
    own = f"{zlib.crc32(key.encode()):x}"
    names = {name: f"f{own}-{k}" for k, name in enumerate([*shapes, *clips])}
    defined = [_element("path", {"id": names[d], "d": d}) for d in shapes] + [
        _element("clipPath", {"id": names[id_]}, body) for id_, body in clips.items()
    ]
    for leaf in leaves:
        if leaf.tag == "use":
            leaf.own["href"] = "#" + names[leaf.own["href"]]
    opening = {name: root.get(name, "") for name in ("width", "height", "viewBox")}
    opening = {"xmlns": "http://www.w3.org/2000/svg"} | {
        name: value for name, value in opening.items() if value
    }
    opening |= {"font-family": FONT_FAMILY, "stroke-linejoin": "round"}
    parts = [_open("svg", opening)]
    if defined:
        parts.append("<defs>" + "".join(defined) + "</defs>")
    parts += _painted(leaves, names)
    return "\n".join([*parts, "</svg>"])


def _leaves(parent: ElementTree.Element, clip: str) -> list[_Leaf]:
    """What is painted, in order, out of its groups."""
    leaves: list[_Leaf] = []
    for child in parent:
        tag = _name(child.tag)
        if tag == "g":
            if set(child.keys()) - {"id", "clip-path"}:
                raise ValueError(f"a group with {sorted(child.keys())}")
            leaves += _leaves(child, child.get("clip-path", clip))
        elif tag == "path" and not child.get("d"):
            continue  # a line that lies outside of its axes
        elif tag not in ("defs", "metadata", "style"):
            leaves.append(_leaf(child, tag, clip))
    if parent.get("id", "").startswith("matplotlib.axis"):
        # What does not overlap there: lines, then marks, then words.
        order = ("path", "use", "text")
        leaves.sort(key=lambda leaf: order.index(leaf.tag))
    return leaves


def _leaf(element: ElementTree.Element, tag: str, clip: str) -> _Leaf:
    own = {_name(name): value for name, value in element.items()}
    own.pop("id", None)
    clip = own.pop("clip-path", clip)
    if tag == "image":
        own["href"] = _IMAGE.sub(
            lambda found: f"data:image/png;base64,{_small_png(found[1])}", own["href"]
        )
        return _Leaf(tag, own, {}, clip)
    look = _style(own.pop("style", ""))
    # Of no effect on what is drawn here but on size.
    look.pop("stroke-linecap", None)
    own |= {name: look.pop(name) for name in set(look) - _INHERITED}
    body = ""
    if tag == "text":
        body = _words(element)
        if "  " in body:
            own["xml:space"] = "preserve"
    for name in ("x", "y"):
        if name in own:
            own[name] = number(float(own[name]), _PLACE_DECIMALS)
    if "transform" in own:
        own["transform"] = _rounded_place(own["transform"])
        if _UPRIGHT.fullmatch(own["transform"]):
            del own["transform"]
    return _Leaf(tag, own, look, clip, body)


def _words(text: ElementTree.Element) -> str:
    """The text of the element, with its parts where it has some."""
    words = escape(text.text or "") if not len(text) else ""
    for part in text:
        style = part.get("style", "")
        own = {name: value for name, value in part.items() if name in ("x", "y")}
        own |= {"style": style} if style else {}
        words += _open("tspan", own) + escape(part.text or "") + "</tspan>"
    return words


def _style(text: str) -> Attributes:
    """The declarations, `font` taken apart, without those that say nothing."""
    look: Attributes = {}
    for declaration in filter(None, (part.strip() for part in text.split(";"))):
        name, value = (part.strip() for part in declaration.split(":", 1))
        if name == "font":
            look |= _font(value)
        elif _DEFAULTS.get(name) != value:
            look[name] = value
    return look


def _font(value: str) -> Attributes:
    found = _FONT.fullmatch(value)
    if found is None:
        raise ValueError(f"a font {value!r}")
    look = {"font-size": found[3]}
    for word in filter(None, found.groups()[:2]):
        look["font-weight" if word.isdigit() else "font-style"] = word
    return look


def _definitions(root: ElementTree.Element) -> tuple[dict[str, _Leaf], Attributes]:
    """The marks by their ids, and the inside of the clip paths."""
    marks, clips = {}, {}
    for defs in (e for e in root.iter() if _name(e.tag) == "defs"):
        for child in defs:
            if _name(child.tag) == "path":
                marks[child.get("id", "")] = _leaf(child, "path", "")
            elif _name(child.tag) == "clipPath":
                clips[child.get("id", "")] = "".join(map(_clip_shape, child))
    return marks, clips


def _clip_shape(shape: ElementTree.Element) -> str:
    return _element(_name(shape.tag), {_name(n): v for n, v in shape.items()})


def _short(path: list[Step]) -> str:
    large = any(abs(value) > _MARK_REACH for _, values in path for value in values)
    return short(path, _PLACE_DECIMALS if large else _MARK_DECIMALS)


def _finished(leaf: _Leaf, marks: dict[str, _Leaf], used: list[str]) -> _Leaf:
    """Its path in short, its mark named by its shape; a mark that is drawn once
    is drawn in its place.
    """
    if leaf.tag == "path":
        leaf.own["d"] = _short(steps(leaf.own["d"]))
    if leaf.tag != "use":
        return leaf
    mark = marks[leaf.own["href"][1:]]
    look = leaf.look | mark.look
    shape = steps(mark.own.get("d", ""))
    if used.count(leaf.own["href"]) > 1:
        own = leaf.own | {"href": _short(shape)}
        return dataclasses.replace(leaf, own=own, look=look)
    at = (float(leaf.own["x"]), float(leaf.own["y"]))
    own = {n: v for n, v in leaf.own.items() if n not in ("href", "x", "y")}
    return _Leaf("path", {"d": _short(moved(shape, *at))} | own, look, leaf.clip)


def _painted(leaves: list[_Leaf], names: dict[str, str]) -> Iterator[str]:
    for clip, clipped in groupby(leaves, key=lambda leaf: leaf.clip):
        inside = []
        for _, alike in groupby(clipped, key=_Leaf.same_look):
            inside.append(_joined_lines(list(alike)))
        around = {}
        if clip:
            around["clip-path"] = f"url(#{names[clip[len('url(#') : -1]]})"
        if len(inside) == 1 and len(inside[0]) > 1 and around:
            yield _group(around | inside[0][0].look, inside[0])
            continue
        texts = []
        for group in inside:
            if len(group) > 1 and group[0].look:
                texts.append(_group(group[0].look, group))
            else:
                texts += [
                    _element(leaf.tag, leaf.own | leaf.look, leaf.body)
                    for leaf in group
                ]
        joined = "\n".join(texts)
        yield f"{_open('g', around)}{joined}</g>" if around else joined


def _group(attributes: Attributes, leaves: list[_Leaf]) -> str:
    inside = "".join(_element(leaf.tag, leaf.own, leaf.body) for leaf in leaves)
    return f"{_open('g', attributes)}{inside}</g>"


def _joined_lines(leaves: list[_Leaf]) -> list[_Leaf]:
    """Opaque lines that look the same are one path."""
    look = leaves[0].look
    plain = look.get("fill") == "none" and not (
        {"stroke-opacity", "stroke-dasharray"} & set(look)
    )
    if not plain or any(set(leaf.own) != {"d"} for leaf in leaves):
        return leaves
    return [
        dataclasses.replace(leaves[0], own={"d": "".join(x.own["d"] for x in leaves)})
    ]


def _element(tag: str, attributes: Attributes, body: str = "") -> str:
    if body:
        return f"{_open(tag, attributes)}{body}</{tag}>"
    return _open(tag, attributes)[:-1] + "/>"


def _open(tag: str, attributes: Attributes) -> str:
    written = "".join(f" {name}={quoteattr(v)}" for name, v in attributes.items())
    return f"<{tag}{written}>"


def _name(qualified: str) -> str:
    return qualified.rpartition("}")[2]


def _rounded_place(transform: str) -> str:
    """Only whole pictures are placed by a matrix; scales keep their digits."""
    if "scale" in transform or "matrix" in transform:
        return transform
    return _NUMBER.sub(
        lambda found: number(float(found[0]), _PLACE_DECIMALS), transform
    )


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
