#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every attribute of the IFC files that SEDR writes, against the EXPRESS schema IFC4 ADD2 TC1, which is
looked for in $SEDR_DATA/formats.

    test_ifc_schema.py pcl_floorplan_ifc
"""

import os
import sys
import tempfile
import unittest

import step_reader
from express_schema import Check, Schema
from ifc_samples import house, house_with_doors, opening, write
from plan_samples import rectangle, room, slab

TOOL = sys.argv[1]
SCHEMA = os.path.join(os.environ.get("SEDR_DATA", ""), "formats", "IFC4_ADD2_TC1.exp")
if not os.path.exists(SCHEMA):
    print("skipped: SEDR_DATA names no folder with formats/IFC4_ADD2_TC1.exp")
    sys.exit(77)


class IfcSchema(unittest.TestCase):
    schema = Schema(SCHEMA)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def problems(self, instances):
        return Check(self.schema, instances).problems

    def valid(self, plan, *options):
        """The instances of a plan's file, in which nothing is wrong."""
        instances = step_reader.read(write(TOOL, plan, self.folder, *options))
        self.assertEqual(self.problems(instances), [])
        return instances

    def test_all_kinds_of_elements(self):
        for options in ((), ("--ifc-arcs", "faceted"), ("--crs", "EPSG:25832")):
            kinds = {name for name, _ in self.valid(house(), *options).values()}
            for kind in ("SPACE", "WALL", "WALLTYPE", "SLAB", "COLUMN", "BEAM", "OPENINGELEMENT", "MAPCONVERSION",
                         "RELSPACEBOUNDARY1STLEVEL", "TRIANGULATEDFACESET", "EXTRUDEDAREASOLID"):
                self.assertIn("IFC" + kind, kinds)
            self.assertEqual("IFCINDEXEDPOLYCURVE" in kinds, "faceted" not in options)

    def test_doors_open_towards_their_y_axis(self):
        """The wall's hall is below y = 4.05, its cell above. From the side that the leaf turns away from, the
        hinge at x = 2.9 is on the left looking down, on the right looking up."""
        for hinge, swing, operation in (("start", 1, "LEFT"), ("start", 2, "RIGHT"), ("end", 1, "RIGHT"),
                                        ("end", 2, "LEFT"), ("both", 2, None), ("unknown", 0, None)):
            instances = self.valid(house_with_doors(hinge, swing))
            kinds = [name for name, _ in instances.values()]
            self.assertEqual([kinds.count("IFC" + kind) for kind in ("DOOR", "WINDOW", "DOORTYPE", "WINDOWTYPE")], [1, 2, 1, 2])
            door = next(v for name, v in instances.values() if name == "IFCDOOR")
            expected = "SINGLE_SWING_" + operation if operation else \
                {"both": "DOUBLE_DOOR_SINGLE_SWING", "unknown": "NOTDEFINED"}[hinge]
            self.assertIn(expected, str(door[11]))
            turn, place = 1 + 0j, door[5]
            while isinstance(place, int):
                parent, frame = instances[place][1]
                way = instances[frame][1][2]
                turn *= complex(*instances[way][1][0][:2]) if isinstance(way, int) else 1
                place = parent
            if swing:
                self.assertAlmostEqual(turn.real, -1 if swing == 1 else 1)  # the y axis is x, turned left

    def test_a_blind_before_a_window_is_no_recess(self):
        plan = house_with_doors()
        plan["rooms"][0]["niches"] = [{"bottom": slab(1), "top": slab(2.12), "boundary": rectangle(2, -0.11, 2.99, 0)},
                                      {"bottom": slab(1), "top": slab(2.3), "boundary": rectangle(0.5, -0.11, 1.5, 0)}]
        names = [v[2] for name, v in self.valid(plan).values() if name == "IFCOPENINGELEMENT" and v[2].startswith("room_1")]
        self.assertEqual(names, ["room_1_niche_2"])

    def test_a_door_where_two_rooms_meet_without_a_wall(self):
        plan = {"format": "sedr-floorplan", "version": 1, "unit": "m",
                "rooms": [room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5)),
                          room(2, rectangle(4, 0, 8, 3), slab(0), slab(2.5))],
                "openings": [opening("door", [1, 2], [4, 1], [4, 1.9])]}
        self.assertEqual([v[2] for name, v in self.valid(plan).values() if name == "IFCVIRTUALELEMENT"], ["opening_D1"])

    def test_one_room_without_an_origin(self):
        plan = {"format": "sedr-floorplan", "version": 1, "unit": "m",
                "rooms": [room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5))]}
        self.assertNotIn("IFCMAPCONVERSION", {name for name, _ in self.valid(plan).values()})

    def test_the_check_itself(self):
        """Each fault is found."""
        path = write(TOOL, house(), self.folder)
        with open(path) as file:
            text = file.read()
        faults = (("IFCWALL('", "IFCWALLS('"), (".STANDARD.", ".USUAL."), ("(.AREA.,$,", "(.AREA.,"),
                  ("IFCLENGTHMEASURE(", "IFCLENGTH("), (",.INTERNAL.,$)", ",.INSIDE.,$)"), ("=IFCWALL('", "=IFCWALL('0"),
                  ("IFCSIUNIT(*,", "IFCSIUNIT($,"), ("IFCPOLYLINE((", "IFCPOLYLINE(#1,("),
                  ("IFCQUANTITYLENGTH('Width',$,$,", "IFCQUANTITYLENGTH('Width',$,$,-"),
                  ("IFCRELVOIDSELEMENT(", "IFCRELFILLSELEMENT("), ("IFCRELAGGREGATES(", "IFCRELNESTS("),
                  ("IFCDIRECTION((0.,0.,1.))", "IFCDIRECTION((0.,0.,0.))"), ("IFCLINEINDEX((1,2))", "IFCLINEINDEX((1,3))"),
                  ("'Body','Tessellation'", "'Body','SweptSolid'"))
        for right, wrong in faults:
            self.assertIn(right, text)
            broken = os.path.join(self.folder, "broken.ifc")
            with open(broken, "w") as file:
                file.write(text.replace(right, wrong, 1))
            try:
                self.assertNotEqual(self.problems(step_reader.read(broken)), [], wrong)
            except ValueError:
                pass  # no STEP at all

    def test_the_same_bytes_each_run(self):
        with open(write(TOOL, house(), self.folder, name="a"), "rb") as first, \
                open(write(TOOL, house(), self.folder, name="b"), "rb") as second:
            self.assertEqual(first.read(), second.read())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
