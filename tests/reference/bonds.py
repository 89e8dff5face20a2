"""Courses of pieces, from what a case file says of a coursed wall: strings, or a bond by its name."""
import re

PIECES = {"1": 1.0, "g": 1.0, "h": 0.5, "q": 0.25}


def of_string(course, legend={}):
    """(kind, width in units) of each piece of a string such as `h1*3g1`; a kind is "g" for every gap."""
    known = {letter: (letter, part) for letter, part in PIECES.items()} | legend
    return [known[letter] for letter, count in re.findall(r"(\w)(?:\*(\d+))?", course) for _ in range(int(count or 1))]


def legend(file):
    """The pieces with letters of their own."""
    length = file["unit"]["length"]
    return {letter: ("g" if piece.get("gap") else letter, piece.get("units", piece.get("length", 0.0) / length))
            for letter, piece in file.get("pieces", {}).items()}


def of_bond(file):
    """The two courses that take turns, the lowest first. A header is half a unit, a closer a quarter."""
    bond, units, overlap = file["bond"], file["units"], file.get("overlap", 0.5)
    turns = lambda stretchers: "h".join("1" * stretchers)
    if bond == "running":
        cut = [("part", overlap)] + [("1", 1.0)] * (units - 1) + [("part", 1.0 - overlap)]
        pair = [of_string("1" * units), cut]
    elif bond == "stack":
        pair = [of_string("1" * units)] * 2
    elif bond == "header":
        pair = [of_string("h" * (2 * units)), of_string("q" + "h" * (2 * units - 1) + "q")]
    elif bond == "english":
        pair = [of_string("1" * units), of_string("hq" + "h" * (2 * units - 3) + "qh")]
    elif bond == "flemish" and units % 3 == 1 and units > 1:
        pair = [of_string(turns(2 * (units // 3) + 1)), of_string("hq" + turns(2 * (units // 3)) + "qh")]
    else:
        raise ValueError(f"no {bond} bond of {units} units is known here")
    cut_first = file.get("first", "half" if bond == "running" else "whole") in ("half", "header", "closer")
    return pair[::-1] if cut_first else pair


def rows(file):
    """Every course of a case file, from the bottom."""
    if isinstance(file["courses"], list):
        own = legend(file)
        return [of_string(course, own) for course in file["courses"]] * file.get("repeat", 1)
    pair = of_bond(file)
    return [pair[row % 2] for row in range(file["courses"])]
