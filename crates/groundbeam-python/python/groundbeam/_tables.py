"""Writes tables as the text of a model file. The solver reads every model in this form."""

from __future__ import annotations

import json
from typing import Mapping, Sequence, SupportsFloat, Union

Value = Union[str, bool, SupportsFloat, Sequence["Value"], Mapping[str, "Value"]]
"""Value of a key: a number in SI units, text with a unit, a list, or a table."""

Tables = Mapping[str, Value]


def write(tables: Tables) -> str:
    """Writes the tables as TOML: first the keys at the top, then table after table."""
    top = [(key, value) for key, value in tables.items() if not _is_heading(value)]
    text = "".join(_line(key, value) for key, value in top)
    for key, value in tables.items():
        if isinstance(value, Mapping):
            text += _table(key, value, f"[{_key(key)}]")
        elif _is_heading(value) and isinstance(value, Sequence):
            for each in value:
                if isinstance(each, Mapping):
                    text += _table(key, each, f"[[{_key(key)}]]")
    return text.lstrip("\n")


def _table(name: str, table: Tables, heading: str) -> str:
    """The text of a table: its heading, its keys, and then its lists of tables, with a heading for each table."""
    below = {key: value for key, value in table.items() if _is_several(value)}
    text = f"\n{heading}\n"
    text += "".join(_line(key, value) for key, value in table.items() if key not in below)
    for key, several in below.items():
        assert isinstance(several, Sequence)
        for each in several:
            assert isinstance(each, Mapping)
            text += _table(key, each, f"[[{_key(name)}.{_key(key)}]]")
    return text


def _is_heading(value: Value) -> bool:
    return isinstance(value, Mapping) or _is_several(value)


def _is_several(value: Value) -> bool:
    """Whether a value is a list of tables."""
    if isinstance(value, (str, bytes)) or not isinstance(value, Sequence) or not value:
        return False
    return all(isinstance(each, Mapping) for each in value)


def _line(key: str, value: Value) -> str:
    return f"{_key(key)} = {_value(value)}\n"


def _key(key: str) -> str:
    bare = key.isascii() and key.replace("-", "").replace("_", "").isalnum()
    return key if bare else _text(key)


def _value(value: Value) -> str:
    if hasattr(value, "tolist"):
        # The value is a NumPy array or a NumPy scalar.
        value = value.tolist()
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        pairs = ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items())
        return f"{{ {pairs} }}"
    if isinstance(value, Sequence):
        return f"[{', '.join(_value(each) for each in value)}]"
    # `repr` writes the fewest digits that are read back as the same bits.
    return repr(float(value))


def _text(text: str) -> str:
    """A TOML string. TOML escapes the same characters as JSON, and the delete character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
