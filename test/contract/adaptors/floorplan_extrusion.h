// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/sample_structure.h"

#include <pcl/PolygonMesh.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

namespace contract {

/** The plan is that of the sample room, or null for fewer than 100 points. The size is
 * the number of triangles.
 *
 * Not applicable: it uses no points, since it takes a plan, and no threads.
 */
class FloorplanExtrusionAdaptor : public AdaptorDefaults {
public:
  static constexpr bool uses_indices = false;
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 6;

  void setInput(const Cloud::ConstPtr& cloud)
  {
    const pcl::IndicesPtr indices = between(*cloud, -10.f, 10.f);
    extrusion_.setInputCloud(cloud);
    extrusion_.setFloorplan(
        indices->size() < 100 ? nullptr : SampleStructure(*cloud, *indices).plan);
  }

  void setIndices(const pcl::IndicesPtr&) {}

  void setThreads(unsigned) {}

  void mend()
  {
    extrusion_.setChordTolerance(0.0005);
    extrusion_.setSnapTolerance(0);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double bad[] = {-1, 5, nan};
    if (which < 3)
      extrusion_.setChordTolerance(bad[which]);
    else
      extrusion_.setSnapTolerance(bad[which - 3]);
  }

  Outcome run()
  {
    pcl::PolygonMesh mesh;
    mesh.polygons.resize(3);
    extrusion_.reconstruct(mesh);
    Outcome outcome;
    outcome.size = mesh.polygons.size();
    outcome.error = extrusion_.getErrorMessage();
    append(outcome.geometry, mesh.cloud.data);
    for (const auto& polygon : mesh.polygons)
      append(outcome.geometry, polygon.vertices);
    append(outcome.geometry, extrusion_.getMesh().elements);
    outcome.all = outcome.geometry;
    return outcome;
  }

private:
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion_;
};

} // namespace contract
