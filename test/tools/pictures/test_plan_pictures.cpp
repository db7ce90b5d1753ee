// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_picture.h"
#include "pictures.h"
#include "plan_loops.h"
#include "plan_picture.h"
#include "refinement_picture.h"
#include "repair_picture.h"
#include "unrolled_walls.h"

#include <pcl/sedr_filters/impl/refinement.h>

namespace {

using namespace programs;
using namespace pcl::sedr;
using Eigen::Vector2d;

/** 4 m x 3 m x 2.5 m. */
PlanRoom
boxRoom()
{
  PlanRoom room;
  room.id = 1;
  room.boundary = sedr_test::rectangle(0, 0, 4, 3);
  room.ceiling.plane[3] = -2.5;
  return room;
}

TEST(PlanPicture, TellsBoundaryPointsOnAWallFromOthers)
{
  FittedBoundary boundary;
  for (const double support : {1.0, 0.0})
    boundary.samples.push_back(
        {Vector2d(1 + support, 1), Vector2d(1 + support, 1), Vector2d(1, 0), support});
  const Picture picture = drawPlan({{boxRoom()}}, {boundary});
  EXPECT_EQ(colourAt(picture, 0, {2, 1}), colours::wall);
  EXPECT_EQ(colourAt(picture, 0, {1, 1}), colours::recovered);
  EXPECT_EQ(colourAt(picture, 1, {2, 0}), colours::ink) << "a segment";
  EXPECT_EQ(colourAt(picture, 1, {3, 1}), colours::paper);
}

TEST(RefinementPicture, ShowsPointsWhereTheyWereAndWhereTheyWent)
{
  RefinedWalls walls;
  walls.moved = {{{1, 0.1}, {1, 0}, StructureLabel::Wall},
                 {{2, 0.6}, {2, 0.5}, StructureLabel::Column}};
  walls.removed = {{3, 0.3}};
  const Picture picture = drawRefinement(walls, {{boxRoom()}});
  EXPECT_EQ(colourAt(picture, 0, {1, 0.1}), colours::wall);
  EXPECT_EQ(colourAt(picture, 0, {3, 0.3}), colours::removed);
  EXPECT_EQ(colourAt(picture, 1, {1, 0.1}), colours::paper);
  EXPECT_EQ(colourAt(picture, 1, {1, 0}), colours::wall);
  EXPECT_EQ(colourAt(picture, 1, {2, 0.5}), colours::column);
  EXPECT_EQ(colourAt(picture, 1, {3, 0.3}), colours::paper);
}

TEST(RepairPicture, ShowsADoorWhereItIsInTheWallSeenFromInside)
{
  // Points on all surfaces except a door in the wall at y = 0, from x = 1 to 2.
  const Floorplan plan{{boxRoom()}};
  std::vector<SurfacePoint> seen;
  for (const auto& whole : repairHoles({}, plan, 0.05)) {
    const Eigen::Vector3d& p = whole.point.position;
    if (p.y() != 0 || p.x() < 1 || p.x() > 2 || p.z() > 2)
      seen.push_back(whole.point);
  }
  RepairedSurfaces surfaces;
  for (const auto& point : repairHoles(seen, plan, 0.05, &surfaces.strips))
    surfaces.is_seen.push_back(point.source >= 0);
  const auto strips = nameStrips(surfaces.strips);
  ASSERT_EQ(strips.size(), 4u);
  EXPECT_EQ(strips[3].name, "1.1") << "who turns to the right sees it last";
  const StripBoxes boxes = boxesOf(strips[3], surfaces.is_seen, {10, 20});
  Box door;
  for (const Box& box : boxes.filled)
    door.extend(box);
  // Seen from inside, the wall at y = 0 starts on the left at x = 4.
  EXPECT_NEAR(door.low.x(), 12, 1e-9);
  EXPECT_NEAR(door.high.x(), 13, 1e-9);
  EXPECT_NEAR(door.low.y(), 20, 1e-9);
  EXPECT_NEAR(door.high.y(), 22, 1e-9);

  const Picture picture = drawRepair(surfaces, plan);
  const StripLines lines = breakIntoLines(strips, 1, 1);
  EXPECT_EQ(lines.origins.size(), 4u);
  EXPECT_EQ(colourAt(picture, 0, {3, 0}), colours::wall) << "the plan";
  EXPECT_EQ(colourAt(picture, 0, {1.5, 0}),
            mixed(colours::wall, colours::recovered, 0.8));
}

TEST(RepairPicture, BreaksWallsIntoLinesThatDoNotOverlap)
{
  PlanRoom hall = boxRoom();
  hall.boundary = sedr_test::rectangle(0, 0, 30, 20);
  std::vector<RepairedStrip> repaired;
  repairHoles({}, {{boxRoom(), hall}}, 0.5, &repaired);
  const auto strips = nameStrips(repaired);
  ASSERT_EQ(strips.size(), 8u);
  for (const double height : {0.2, 1.0, 5.0}) {
    const StripLines lines = breakIntoLines(strips, 1, height);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < strips.size(); ++i) {
      boxes.push_back(
          {lines.origins[i], lines.origins[i] + Vector2d(strips[i].length, 2.5)});
      EXPECT_TRUE(lines.view.contains(boxes[i].low));
      EXPECT_TRUE(lines.view.contains(boxes[i].high));
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE((boxes[i].low.array() < boxes[j].high.array()).all() &&
                     (boxes[j].low.array() < boxes[i].high.array()).all());
    }
  }
}

TEST(MeshPicture, ShowsTheSidesThatFaceTheViewer)
{
  // An upward floor and a downward ceiling.
  TriangleMesh mesh;
  for (const double z : {0.0, 2.5})
    for (const auto& p :
         {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 4), Vector2d(0, 4)})
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  const auto floor = static_cast<std::uint32_t>(StructureLabel::Floor);
  const auto ceiling = static_cast<std::uint32_t>(StructureLabel::Ceiling);
  mesh.labels = {floor, floor, ceiling, ceiling};
  const Picture picture = drawMesh(mesh);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const Box view = panelOf(picture, panel).view();
    const Colour middle = colourAt(picture, panel, (view.low + view.high) / 2);
    EXPECT_EQ(middle.blue > middle.red, panel == 0)
        << "the floor is seen from above, the ceiling from below";
  }
}

} // namespace
