// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

#include "sedr_surface/src/mesh/mesh_repair.h"
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace sedr_test {

/** The solid of a room, its elements and its report. */
struct Solid {
  pcl::sedr::TriangleMesh mesh;
  std::vector<pcl::sedr::SolidElement> elements;
  pcl::sedr::RoomSolidReport report;

  explicit Solid(const pcl::sedr::PlanRoom& room,
                 const pcl::sedr::SolidParameters& parameters = {})
      : report(pcl::sedr::extrudeRoom(room, parameters, mesh, elements))
  {}

  /** Returns the names of the elements that have triangles. */
  std::set<std::string> names() const
  {
    std::set<std::string> names;
    for (const auto e : mesh.elements)
      names.insert(elements[e - 1].name);
    return names;
  }

  /** Returns the area in square metres of an element's triangles. */
  double areaOf(const std::string& name) const
  {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (elements[mesh.elements[t] - 1].name == name)
        area += mesh.scaledNormal(t).norm() / 2;
    return area;
  }

  /** Returns true if a vertex is within a micrometre of a place. */
  bool hasVertex(double x, double y, double z) const
  {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& v) {
      return (v - Eigen::Vector3d(x, y, z)).norm() < 1e-6;
    });
  }
};

/** Expects the properties of every valid solid. */
inline void
expectSound(const Solid& solid)
{
  ASSERT_EQ(solid.report.problem, "");
  EXPECT_EQ(solid.mesh.problem(), "");
  EXPECT_TRUE(solid.report.closed) << solid.report.topology.problem();
  EXPECT_EQ(solid.report.topology.vertices, solid.mesh.vertices.size());
  EXPECT_GT(solid.report.volume, 0) << "faces outwards";
  for (const auto& component : solid.report.topology.components)
    EXPECT_GT(component.signed_volume, 0);
  EXPECT_TRUE(pcl::sedr::findSelfIntersections(solid.mesh, 1e-7).empty());
  ASSERT_EQ(solid.mesh.elements.size(), solid.mesh.triangles.size());
  for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t) {
    const auto& element = solid.elements.at(solid.mesh.elements[t] - 1);
    EXPECT_EQ(static_cast<std::uint32_t>(element.label), solid.mesh.labels[t]);
    EXPECT_EQ(element.room, solid.mesh.rooms[t]);
  }
}

/** Expects a valid solid of one component. */
inline void
expectPiece(const Solid& solid, double volume, int euler = 2)
{
  expectSound(solid);
  EXPECT_EQ(solid.report.topology.components.size(), 1u);
  EXPECT_EQ(solid.report.topology.euler_characteristic, euler);
  EXPECT_NEAR(solid.report.volume, volume, 1e-5);
}

/** Returns the area of the polygon of a loop's facets, not that of the arcs. */
inline double
facetArea(const pcl::sedr::PlanLoop& loop,
          double tolerance = pcl::sedr::SolidParameters().chord_tolerance)
{
  return polygon(loop.polygon(tolerance)).area();
}

} // namespace sedr_test
