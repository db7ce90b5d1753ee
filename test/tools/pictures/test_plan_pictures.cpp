// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_picture.h"
#include "pictures.h"
#include "plan_loops.h"
#include "plan_picture.h"
#include "refinement_picture.h"
#include "repair_picture.h"

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
  const Picture picture = drawRepair(surfaces, plan);
  EXPECT_EQ(colourAt(picture, 0, {3, 0}), colours::wall) << "the plan";
  EXPECT_EQ(colourAt(picture, 0, {1.5, 0}),
            mixed(colours::wall, colours::recovered, 0.8));
  // The wall at y = 0 is the last one, as who turns to the right sees it last, and
  // starts on the left at x = 4.
  const Panel& walls = panelOf(picture, 1);
  const double right = walls.view().max().x() - 0.15;
  const double low = walls.view().min().y() + 0.35;
  EXPECT_EQ(colourAt(walls, {right - 1.5, low + 1}), colours::recovered) << "the door";
  EXPECT_EQ(colourAt(walls, {right - 1.5, low + 2.2}), colours::wall) << "above it";
  EXPECT_EQ(colourAt(walls, {right - 3, low + 1}), colours::wall);
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
    const Colour middle = colourAt(picture, panel, view.center());
    EXPECT_EQ(middle.blue > middle.red, panel == 0)
        << "the floor is seen from above, the ceiling from below";
  }
}

} // namespace
