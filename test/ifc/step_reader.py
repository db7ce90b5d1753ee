# SPDX-License-Identifier: BSD-3-Clause
"""Reads a STEP file (ISO 10303-21) into its instances."""

import re

TOKEN = re.compile(r"""\s*(?:(?P<text>'(?:[^']|'')*')|(?P<ref>\#\d+)|(?P<enum>\.[A-Z0-9_]+\.)
    |(?P<number>[-+]?\d+(?:\.\d*)?(?:E[-+]?\d+)?)|(?P<word>[A-Z][A-Z0-9_]*)|(?P<sign>[(),;=$*]))""", re.X)


class Ref(int):
    """An instance by its number."""


class Enum(str):
    """.AREA."""


class Typed:
    """IFCLENGTHMEASURE(0.2)"""

    def __init__(self, kind, value):
        self.kind, self.value = kind, value


class Derived:
    """*"""


def tokens(text):
    at = 0
    while at < len(text):
        if not text[at:].strip():
            return
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError("no STEP at %r" % text[at:at + 40])
        at = match.end()
        yield match.lastgroup, match.group(match.lastgroup)


def value_of(stream, kind, word):
    if kind == "text":
        return word[1:-1].replace("''", "'")
    if kind == "ref":
        return Ref(word[1:])
    if kind == "enum":
        return Enum(word[1:-1])
    if kind == "number":
        return float(word) if "." in word else int(word)
    if kind == "word":
        assert next(stream) == ("sign", "(")
        values = list_of(stream)
        assert len(values) == 1
        return Typed(word, values[0])
    if word == "(":
        return list_of(stream)
    if word == "$":
        return None
    assert word == "*", word
    return Derived()


def list_of(stream):
    values = []
    for kind, word in stream:
        if (kind, word) == ("sign", ")"):
            return values
        if (kind, word) != ("sign", ","):
            values.append(value_of(stream, kind, word))
    raise ValueError("a list does not end")


def read(path):
    """{number: (TYPE, [attributes])} of a file."""
    with open(path, encoding="ascii") as file:
        text = file.read()
    assert text.startswith("ISO-10303-21;") and text.rstrip().endswith("END-ISO-10303-21;")
    data = text[text.index("\nDATA;") + 6:text.rindex("ENDSEC;")]
    instances = {}
    for line in data.strip().splitlines():  # SEDR writes an instance a line
        stream = tokens(line)
        kind, number = next(stream)
        assert kind == "ref" and next(stream) == ("sign", "=")
        kind, name = next(stream)
        assert next(stream) == ("sign", "(")
        assert int(number[1:]) not in instances
        instances[int(number[1:])] = (name, list_of(stream))
        assert next(stream) == ("sign", ";")
    return instances


def sets(instances, kind):
    """{object: {name: value}} of all sets of that kind: IFCELEMENTQUANTITY or IFCPROPERTYSET."""
    found = {}
    for name, v in instances.values():
        if name == "IFCRELDEFINESBYPROPERTIES" and instances[v[5]][0] == kind:
            members = instances[v[5]][1]
            for member in (instances[m][1] for m in members[5 if kind == "IFCELEMENTQUANTITY" else 4]):
                value = member[3] if kind == "IFCELEMENTQUANTITY" else member[2].value
                for thing in v[4]:
                    found.setdefault(thing, {})[member[0]] = value
    return found
