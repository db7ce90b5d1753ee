# SPDX-License-Identifier: BSD-3-Clause
"""Checks STEP instances against an EXPRESS schema: entities, number, order and type of attributes, sizes
of lists, members of enumerations and selects; and those rules WHERE that can be told in a line."""

import re

from step_reader import Derived, Enum, Ref, Typed

SIMPLE = {"REAL": (float,), "NUMBER": (float, int), "INTEGER": (int,), "STRING": (str,),
          "BOOLEAN": (Enum,), "LOGICAL": (Enum,), "BINARY": (str,)}


class Schema:
    def __init__(self, path):
        with open(path, encoding="latin-1") as file:
            text = re.sub(r"\(\*.*?\*\)", "", file.read(), flags=re.S)
        self.types, self.entities = {}, {}
        for name, body in re.findall(r"^TYPE (\w+) = (.*?);", text, re.S | re.M):
            self.types[name.upper()] = " ".join(body.split())
        for name, body in re.findall(r"^ENTITY (\w+)(.*?)END_ENTITY;", text, re.S | re.M):
            head = re.split(r"^\s*(?:DERIVE|INVERSE|UNIQUE|WHERE)$", body, flags=re.M)[0]
            above = re.search(r"SUBTYPE OF \((\w+)\)", head)
            derive = re.search(r"\bDERIVE\b(.*?)(?:\b(?:INVERSE|UNIQUE|WHERE)\b|$)", body, re.S)
            self.entities[name.upper()] = {
                "abstract": "ABSTRACT" in head,
                "above": above.group(1).upper() if above else None,
                "own": re.findall(r"^\s*(\w+) : (OPTIONAL )?([^;]+);", head, re.M),
                "derived": set(re.findall(r"SELF\\\w+\.(\w+)", derive.group(1))) if derive else set()}

    def ancestors(self, name):
        while name:
            yield name
            name = self.entities[name]["above"]

    def attributes(self, name):
        """(name, is optional, type, is derived) of all, those of supertypes first."""
        chain = list(self.ancestors(name))
        derived = set().union(*(self.entities[n]["derived"] for n in chain))
        return [(own, bool(optional), " ".join(kind.split()), own in derived)
                for n in reversed(chain) for own, optional, kind in self.entities[n]["own"]]

    def is_a(self, name, kind):
        return name in self.entities and kind in self.ancestors(name)


class Check:
    """What is wrong in instances, sentences."""

    def __init__(self, schema, instances):
        self.schema, self.instances, self.problems = schema, instances, []
        for number, (name, values) in instances.items():
            self.instance("#%d=%s" % (number, name), name, values)
        self.rules()

    def tell(self, where, what):
        self.problems.append("%s: %s" % (where, what))

    def instance(self, where, name, values):
        entity = self.schema.entities.get(name)
        if entity is None or entity["abstract"]:
            return self.tell(where, "is no entity that can be written")
        attributes = self.schema.attributes(name)
        if len(attributes) != len(values):
            return self.tell(where, "has %d attributes instead of %d" % (len(values), len(attributes)))
        for (own, optional, kind, derived), value in zip(attributes, values):
            if derived or isinstance(value, Derived):
                if not (derived and isinstance(value, Derived)):
                    self.tell(where + "." + own, "is derived or not, but written otherwise")
            elif value is None:
                if not optional:
                    self.tell(where + "." + own, "is missing")
            elif not self.fits(value, kind):
                self.tell(where + "." + own, "%r is no %s" % (value, kind))

    def fits(self, value, kind):
        bounds = re.match(r"(LIST|SET|ARRAY|BAG)(?: \[(\w+):([\w?]+)\])? OF (?:UNIQUE )?(.*)", kind)
        if bounds:
            if not isinstance(value, list):
                return False
            low, high = int(bounds.group(2) or 0), bounds.group(3) or "?"
            if len(value) < low or (high != "?" and len(value) > int(high)):
                return False
            if bounds.group(1) == "SET" and len({repr(v) for v in value}) != len(value):
                return False
            return all(self.fits(v, bounds.group(4)) for v in value)
        base = re.match(r"(\w+)(?:\s*\((\d+)\)(?: FIXED)?)?$", kind)
        if base and base.group(1) in SIMPLE:
            right = isinstance(value, SIMPLE[base.group(1)]) and \
                not (base.group(1) == "STRING" and isinstance(value, Enum))
            if base.group(1) in ("BOOLEAN", "LOGICAL"):
                right = right and value in ("T", "F", "U")[:2 if base.group(1) == "BOOLEAN" else 3]
            return right and not (base.group(2) and isinstance(value, str) and len(value) > int(base.group(2)))
        name = kind.upper()
        if name in self.schema.entities:
            return isinstance(value, Ref) and value in self.instances and \
                self.schema.is_a(self.instances[value][0], name)
        body = self.schema.types[name]
        members = re.match(r"(ENUMERATION OF|SELECT)\s*\((.*)\)", body)
        if not members:
            return self.fits(value, body.split(" WHERE ")[0]) and self.holds(name, value)
        names = [m.strip().upper() for m in members.group(2).split(",")]
        if members.group(1) == "SELECT":
            return any(self.fits_member(value, member) for member in names)
        return isinstance(value, Enum) and value in names

    def fits_member(self, value, member):
        if member in self.schema.types and self.schema.types[member].startswith("SELECT"):
            return self.fits(value, member)
        if member in self.schema.entities:
            return self.fits(value, member)
        return isinstance(value, Typed) and value.kind == member and self.fits(value.value, member)

    @staticmethod
    def holds(name, value):
        """The rules of simple types."""
        if name.startswith("IFCPOSITIVE"):
            return value > 0
        if name == "IFCNORMALISEDRATIOMEASURE":
            return 0 <= value <= 1
        return True

    def of(self, kind):
        return [(n, name, dict(zip([a[0] for a in self.schema.attributes(name)], values)))
                for n, (name, values) in self.instances.items() if self.schema.is_a(name, kind)]

    def rules(self):
        """Rules WHERE and UNIQUE, and what the layout of a model asks for."""
        guids = [values["GlobalId"] for _, _, values in self.of("IFCROOT")]
        for guid in {g for g in guids if guids.count(g) > 1} if len(set(guids)) < len(guids) else ():
            self.tell(guid, "is the GlobalId of two objects")
        letters = re.compile(r"[0-3][0-9A-Za-z_$]{21}$")
        for guid in guids:
            if not letters.match(guid):
                self.tell(guid, "is no GlobalId")
        if len(self.of("IFCPROJECT")) != 1:
            self.tell("IFCPROJECT", "must be there once")
        whole, contained, voids = {}, {}, {}
        for n, _, values in self.of("IFCRELAGGREGATES"):
            for part in values["RelatedObjects"]:
                if whole.setdefault(part, n) != n:
                    self.tell("#%d" % part, "is part of two")
        for n, _, values in self.of("IFCRELCONTAINEDINSPATIALSTRUCTURE"):
            for part in values["RelatedElements"]:
                if self.schema.is_a(self.instances[part][0], "IFCSPATIALSTRUCTUREELEMENT"):
                    self.tell("#%d" % part, "is a space, to be aggregated, not contained")
                if contained.setdefault(part, n) != n:
                    self.tell("#%d" % part, "is contained twice")
        for n, _, values in self.of("IFCRELVOIDSELEMENT"):
            voids[values["RelatedOpeningElement"]] = values["RelatingBuildingElement"]
        for n, name, values in self.of("IFCSPATIALSTRUCTUREELEMENT"):
            if n not in whole:
                self.tell("#%d=%s" % (n, name), "is part of nothing")
        for n, name, values in self.of("IFCELEMENT"):
            if name == "IFCOPENINGELEMENT":
                if n not in voids or n in contained:
                    self.tell("#%d=%s" % (n, name), "must be hosted by an element, not contained")
            elif (n in whole) == (n in contained):
                self.tell("#%d=%s" % (n, name), "is in a storey or part of an element, one of both")
        for n, name, values in self.of("IFCPRODUCT"):
            if values["Representation"] is not None and values["ObjectPlacement"] is None:
                self.tell("#%d=%s" % (n, name), "has a shape but no placement")
        for n, name, values in self.of("IFCPHYSICALSIMPLEQUANTITY"):
            if self.instances[n][1][3] < 0:
                self.tell("#%d=%s" % (n, name), "is negative")
        for n, name, values in self.of("IFCDIRECTION"):
            if not any(values["DirectionRatios"]):
                self.tell("#%d" % n, "has no direction")
        for n, _, values in self.of("IFCPROPERTYSET") + self.of("IFCELEMENTQUANTITY"):
            key = "HasProperties" if "HasProperties" in values else "Quantities"
            names = [self.instances[p][1][0] for p in values[key]]
            if len(names) != len(set(names)):
                self.tell("#%d" % n, "has two values of one name")
        items = {"SweptSolid": "IFCSWEPTAREASOLID", "Tessellation": "IFCTESSELLATEDFACESET", "Curve2D": "IFCCURVE"}
        for n, name, values in self.of("IFCSHAPEREPRESENTATION"):
            if not all(self.schema.is_a(self.instances[i][0], items[values["RepresentationType"]])
                       for i in values["Items"]):
                self.tell("#%d" % n, "has other items than its type says")
        for n, name, values in self.of("IFCTRIANGULATEDFACESET"):
            count = len(self.instances[values["Coordinates"]][1][0])
            if any(i > count for triangle in values["CoordIndex"] for i in triangle):
                self.tell("#%d" % n, "has indices beyond its points")
        for n, _, values in self.of("IFCINDEXEDPOLYCURVE"):
            ends = [s.value for s in values["Segments"] or []]
            if any(a[-1] != b[0] for a, b in zip(ends, ends[1:])) or (ends and ends[-1][-1] != ends[0][0]):
                self.tell("#%d" % n, "is not closed")
