// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/solid/room_layers.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room with every kind of part: a column, a soffit with a hole, a beam over it, a
 * step, and a niche. */
PlanRoom
richRoom()
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5, 7);
  room.columns = {reversed(rectangle(1, 1, 2, 2))};
  room.details = {detailOf(rectangle(0, 3, 6, 5), 2.2),
                  detailOf(rectangle(4, 0, 5, 5), 2.0)};
  room.details[0].holes = {reversed(rectangle(1, 3.5, 2, 4))};
  room.floor_details = {detailOf(rectangle(3, 0, 6, 5), 0.3)};
  PlanNiche niche;
  niche.boundary = rectangle(2, 5, 3, 5.3);
  niche.bottom = slabAt(1);
  niche.top = slabAt(2);
  room.niches = {niche};
  return room;
}

enum Slab { floor_slab, ceiling_slab, soffit, beam, platform, niche_bottom, niche_top };
enum Loop { boundary, column, soffit_edge, soffit_hole, beam_edge, step_edge, niche };

/** Returns the region with winding number 1 in the given loops and 0 in the others. */
PlanRegion
within(const RoomLayers& layers, const std::vector<Loop>& loops)
{
  std::vector<int> winding(layers.loops.size(), 0);
  for (const Loop loop : loops)
    winding[loop] = 1;
  return layers.regionOf(winding);
}

TEST(RoomLayers, NameEveryFaceOfTheSolid)
{
  const PlanRoom room = richRoom();
  const RoomLayers layers(room);
  ASSERT_EQ(layers.slabs.size(), 7u);
  ASSERT_EQ(layers.loops.size(), 7u);
  const auto nameOfSlab = [&](std::size_t slab) {
    return layers.elements[layers.slabs[slab].element].name;
  };
  const auto nameOfEdge = [&](std::size_t loop, std::size_t edge) {
    return layers.elements[layers.loops[loop].first_element + edge].name;
  };
  EXPECT_EQ(nameOfSlab(floor_slab), "room_7_floor");
  EXPECT_EQ(nameOfSlab(ceiling_slab), "room_7_ceiling");
  EXPECT_EQ(nameOfSlab(soffit), "room_7_detail_1");
  EXPECT_EQ(nameOfSlab(beam), "room_7_detail_2");
  EXPECT_EQ(nameOfSlab(platform), "room_7_floor_detail_1");
  EXPECT_EQ(nameOfSlab(niche_bottom), "room_7_niche_1_bottom");
  EXPECT_EQ(nameOfSlab(niche_top), "room_7_niche_1_top");
  EXPECT_EQ(nameOfEdge(boundary, 3), "room_7_wall_4");
  EXPECT_EQ(nameOfEdge(column, 0), "room_7_column_1_face_1");
  EXPECT_EQ(nameOfEdge(soffit_edge, 1), "room_7_detail_1_edge_2");
  EXPECT_EQ(nameOfEdge(soffit_hole, 2), "room_7_detail_1_hole_1_edge_3");
  EXPECT_EQ(nameOfEdge(step_edge, 0), "room_7_floor_detail_1_edge_1");
  EXPECT_EQ(nameOfEdge(niche, 1), "room_7_niche_1_side_2");
  // 2 slabs and 4 walls, 4 faces, then slabs and edges of details and the niche
  EXPECT_EQ(layers.elements.size(), 2u + 4 + 4 + 9 + 5 + 5 + 6);
  for (const SolidElement& element : layers.elements)
    EXPECT_EQ(element.room, 7u);
}

TEST(RoomLayers, LabelsAndRolesOfFaces)
{
  const PlanRoom room = richRoom();
  const RoomLayers layers(room);
  const auto labelOfEdge = [&](Loop loop) {
    return layers.elements[layers.loops[loop].first_element].label;
  };
  EXPECT_EQ(layers.elements[0].label, StructureLabel::Floor);
  EXPECT_EQ(layers.elements[1].label, StructureLabel::Ceiling);
  EXPECT_EQ(labelOfEdge(boundary), StructureLabel::Wall);
  EXPECT_EQ(labelOfEdge(column), StructureLabel::Column);
  for (const Loop loop : {soffit_edge, soffit_hole, beam_edge, step_edge, niche})
    EXPECT_EQ(labelOfEdge(loop), StructureLabel::Detail);
  const LoopRole roles[] = {LoopRole::Wall,         LoopRole::ColumnFace,
                            LoopRole::CeilingRiser, LoopRole::CeilingRiser,
                            LoopRole::CeilingRiser, LoopRole::FloorRiser,
                            LoopRole::NicheSide};
  for (std::size_t loop = 0; loop < layers.loops.size(); ++loop) {
    const std::size_t first = layers.loops[loop].first_element;
    EXPECT_EQ(layers.roleOf(first), roles[loop]) << loop;
    EXPECT_EQ(layers.roleOf(first + 3), roles[loop]) << loop;
  }
  EXPECT_EQ(layers.roleOf(layers.slabs[soffit].element), LoopRole::Wall);
}

TEST(RoomLayers, WhatBoundsAPlaceBelowAndAbove)
{
  const PlanRoom room = richRoom();
  const RoomLayers layers(room);
  EXPECT_FALSE(within(layers, {}).isRoom());
  EXPECT_EQ(within(layers, {boundary}), (PlanRegion{floor_slab, ceiling_slab}));
  EXPECT_EQ(within(layers, {boundary, soffit_edge}), (PlanRegion{floor_slab, soffit}));
  EXPECT_EQ(within(layers, {boundary, soffit_edge, soffit_hole}),
            (PlanRegion{floor_slab, ceiling_slab}))
      << "a hole";
  EXPECT_EQ(within(layers, {boundary, soffit_edge, beam_edge}),
            (PlanRegion{floor_slab, beam}))
      << "the last counts";
  EXPECT_EQ(within(layers, {boundary, soffit_edge, step_edge}),
            (PlanRegion{platform, soffit}));
}

TEST(RoomLayers, ColumnsAreCutOutOfAllAndNichesLieBesideTheBoundary)
{
  const PlanRoom room = richRoom();
  const RoomLayers layers(room);
  EXPECT_FALSE(within(layers, {boundary, column}).isRoom());
  EXPECT_FALSE(within(layers, {column, niche}).isRoom());
  const PlanRegion in_niche = within(layers, {niche});
  EXPECT_EQ(in_niche, (PlanRegion{niche_bottom, niche_top}));
  EXPECT_TRUE(layers.isNiche(in_niche));
  EXPECT_EQ(within(layers, {boundary, niche}), (PlanRegion{floor_slab, ceiling_slab}));
  EXPECT_FALSE(layers.isNiche(within(layers, {boundary, step_edge})));
  EXPECT_FALSE(layers.isNiche({}));
  EXPECT_FALSE(within(layers, {soffit_edge}).isRoom()) << "outside of the walls";
}

TEST(RoomLayers, OfSeveralNichesTheFirstCounts)
{
  PlanRoom room = richRoom();
  room.niches.push_back(room.niches[0]);
  const RoomLayers layers(room);
  std::vector<int> winding(layers.loops.size(), 0);
  winding[niche] = winding[niche + 1] = 1;
  EXPECT_EQ(layers.regionOf(winding), (PlanRegion{niche_bottom, niche_top}));
}

TEST(RoomLayers, WhatMayBeInsteadOfARegionLosesItsFloorFirstThenItsCeiling)
{
  const PlanRoom room = richRoom();
  const RoomLayers layers(room);
  const std::vector<PlanRegion> instead = layers.plainRegions({platform, soffit});
  ASSERT_EQ(instead.size(), 4u);
  EXPECT_EQ(instead[0], (PlanRegion{floor_slab, soffit}));
  EXPECT_EQ(instead[1], (PlanRegion{platform, ceiling_slab}));
  EXPECT_EQ(instead[2], (PlanRegion{floor_slab, ceiling_slab}));
  EXPECT_FALSE(instead[3].isRoom());
  const std::vector<PlanRegion> closed = layers.plainRegions({niche_bottom, niche_top});
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_FALSE(closed[0].isRoom());
}

} // namespace
