// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/walls/plan_walls.h"
#include "step_file.h"

#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <map>
#include <string>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief A body, and the type of the shapes that it is an item of. */
struct IfcBody {
  StepRef item{};
  const char* type = "SweptSolid"; ///< or "Tessellation"
};

/** @brief Writes geometry to an IFC file: placements, profiles and bodies. */
class IfcShapes {
public:
  IfcShapes(StepFile& step, IfcArcs arcs)
      : step_(step)
      , arcs_(arcs)
  {}

  /** @param p in space or in plan */
  StepRef point(const Eigen::VectorXd& p);
  StepRef direction(const Eigen::Vector3d& way);

  /** @brief Adds an IfcAxis2Placement3D. */
  StepRef axes(const Eigen::Vector3d& origin,
               const Eigen::Vector3d& z = Eigen::Vector3d::UnitZ(),
               const Eigen::Vector3d& x = Eigen::Vector3d::UnitX());

  /** @brief Adds an IfcLocalPlacement with z up, relative to `parent`. */
  StepRef placement(StepRef parent,
                    const Eigen::Vector3d& origin,
                    const Eigen::Vector2d& x = Eigen::Vector2d::UnitX());

  /** @brief Adds a closed loop as a curve: a polyline, or one with arcs. */
  StepRef closedCurve(const PlanLoop& loop);

  /** @brief Adds the area inside a loop and outside its holes, swept upwards.
   * @param run of a tilted wall: metres along y for each metre up; the loops are where
   * z is 0 */
  IfcBody extrusion(const PlanLoop& boundary,
                    const std::vector<PlanLoop>& holes,
                    double bottom,
                    double height,
                    double run = 0);

  /** @brief Adds a closed mesh as IfcTriangulatedFaceSet. */
  IfcBody faceSet(const TriangleMesh& mesh);

  /** @brief Gives a body the colour of a kind: "space", "wall", "slab", ... */
  void colour(StepRef body, const std::string& kind);

  /** @brief Adds an IfcProductDefinitionShape of shapes such as body() and line(). */
  StepRef product(const std::vector<StepRef>& shapes);

  /** @param type see IfcBody */
  StepRef
  body(StepRef context, const std::string& type, const std::vector<StepRef>& items);

  /** @brief Adds the axis of a wall between two places in plan. */
  StepRef line(StepRef context, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

private:
  StepRef polyline(const std::vector<Eigen::Vector2d>& corners, bool is_closed);
  StepRef indexedCurve(const PlanLoop& loop);
  StepRef styleOf(const std::string& kind);

  StepFile& step_;
  IfcArcs arcs_;
  std::map<std::string, StepRef> styles_;
};

/** @brief Returns a loop in the frame of a wall. */
PlanLoop inFrame(PlanLoop loop, const WallFrame& frame);

} // namespace pcl::sedr::ifc
