// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/impl/room_samples.h>

namespace sedr_test {

/** Points on all surfaces of a room, in the middle of squares, with exact normals. */
inline std::vector<pcl::sedr::OrientedPoint>
orientedPoints(const pcl::sedr::PlanRoom& room, double spacing)
{
  using Label = pcl::sedr::StructureLabel;
  const pcl::sedr::RoomSurfaces surfaces(room, 0.001);
  RoomPoints points(spacing);
  const RoomParts parts = points.room(room);
  std::vector<pcl::sedr::OrientedPoint> oriented;
  for (const auto& [label, part] :
       {std::pair(Label::Floor, parts.floor), std::pair(Label::Ceiling, parts.ceiling),
        std::pair(Label::Detail, parts.details), std::pair(Label::Wall, parts.walls)})
    for (const int i : part)
      if (pcl::sedr::SurfacePoint on;
          surfaces.snap(points[i].cast<double>(), label, on))
        oriented.push_back({points[i], on.normal.cast<float>()});
  return oriented;
}

/** The solid of a room, with normals into it. */
inline pcl::sedr::TriangleMesh
solidOf(const pcl::sedr::PlanRoom& room)
{
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  extrusion.setFloorplan(pcl::sedr::Floorplan{{room}});
  pcl::PolygonMesh output;
  extrusion.reconstruct(output);
  pcl::sedr::TriangleMesh mesh = extrusion.getMesh();
  mesh.flip();
  return mesh;
}

/** Turns points and their normals about z, then shifts them. */
inline std::vector<pcl::sedr::OrientedPoint>
placed(std::vector<pcl::sedr::OrientedPoint> points,
       double degrees,
       const Eigen::Vector3d& shift)
{
  const Eigen::AngleAxisd turn(degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
  for (auto& p : points) {
    p.position = (turn * p.position.cast<double>() + shift).cast<float>();
    p.normal = (turn * p.normal.cast<double>()).cast<float>();
  }
  return points;
}

/** 3 m x 2.5 m x 2.5 m. */
inline pcl::sedr::PlanRoom
smallRoom()
{
  return roomOf(rectangle(0, 0, 3, 2.5), 2.5);
}

} // namespace sedr_test
