// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_room.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

namespace programs {

/** Two box rooms with 0.2 m of wall between them, and all results of a run, known in
 * closed form. */
struct SampleResult {
  BoxRoom first;
  BoxRoom second;
  RoomScan scan;
  pcl::sedr::Floorplan plan;
  pcl::sedr::TriangleMesh solid; ///< normals out of the rooms
  std::vector<pcl::sedr::SolidElement> elements;
  pcl::sedr::TriangleMesh mesh; ///< the same, normals into the rooms

  SampleResult()
  {
    second.x = first.x + first.width + 0.2;
    second.width = 3.5;
    second.id = 2;
    for (const auto& room : {first, second}) {
      scan.addRoom(room);
      plan.rooms.push_back(planOf(room));
    }
    pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
    extrusion.setFloorplan(plan);
    pcl::PolygonMesh unused;
    extrusion.reconstruct(unused);
    solid = extrusion.getMesh();
    elements = extrusion.getElements();
    mesh = solid;
    mesh.elements.clear();
    mesh.flip();
  }

  /** Writes the files of a run to `folder`, and the scan beside it. */
  void writeTo(const std::filesystem::path& folder) const
  {
    std::filesystem::create_directories(folder);
    writeFile(folder / "../scan.pcd", scan.pcd(false));
    writeFile(folder / "structure.pcd", scan.withoutLabel(Label::Other).pcd(true));
    writeFile(folder / "floorplan.json", pcl::sedr::floorplanToJson(plan));
    writeFile(folder / "mesh.ply", pcl::sedr::meshToPly(mesh));
    writeFile(folder / "solid.ply",
              pcl::sedr::meshToPly(solid, pcl::sedr::elementComments(solid, elements)));
    writeFile(
        folder / "report.json",
        R"({"format": "sedr-report", "version": 1, "input": {"path": "scan.pcd",
 "points": )" +
            std::to_string(scan.points.size()) +
            R"(, "unit": 1}, "parameters": {"voxel_size": 0.1}, "stages": [], "rooms": [],
 "warnings": []})");
  }
};

} // namespace programs
