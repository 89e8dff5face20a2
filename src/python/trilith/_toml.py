"""Keys and values as the text of a case file. It knows no key: which there are, the program says."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from trilith._arrays import plain

BARE = re.compile(r"[A-Za-z0-9_-]+\Z")


def document(keys: Mapping[str, Any]) -> str:
    """The text of a file: values first, then a section for every list of tables."""
    values: list[str] = []
    sections: list[str] = []
    for key, value in plain(dict(keys)).items():
        if value is None:
            continue
        if isinstance(value, list) and value and all(isinstance(one, dict) for one in value):
            for table in value:
                sections.append(f"\n[[{_key(key)}]]\n" + "".join(_lines(table)))
        else:
            values.append(f"{_key(key)} = {_spread(value)}\n")
    return "".join(values + sections)


def _lines(table: dict[str, Any]) -> list[str]:
    return [f"{_key(key)} = {_value(value)}\n" for key, value in table.items() if value is not None]


def _spread(value: Any) -> str:
    """As `_value`, with a text a line: the program shows the line that is wrong."""
    if isinstance(value, list) and value and all(isinstance(one, str) for one in value):
        return "[\n" + "".join(f"    {_text(one)},\n" for one in value) + "]"
    return _value(value)


def _key(key: str) -> str:
    return key if BARE.match(key) else _text(key)


def _text(text: str) -> str:
    # JSON's escapes are TOML's too, but for DEL, which TOML does not take as it is.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, float):
        # Python writes 1e16 as TOML does, and nan and inf so that the program can refuse them.
        return repr(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, list):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    if isinstance(value, dict):
        inside = (f"{_key(key)} = {_value(one)}" for key, one in value.items() if one is not None)
        return "{ " + ", ".join(inside) + " }"
    return _text(str(value))
