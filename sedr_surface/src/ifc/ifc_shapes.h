// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_walls.h"
#include "step_file.h"

#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief Geometry of an IFC file: places, profiles and bodies. */
class IfcShapes {
public:
  IfcShapes(StepFile& step, IfcArcs arcs)
      : step_(step)
      , arcs_(arcs)
  {}

  StepRef point(const Eigen::Vector3d& p);
  StepRef point(const Eigen::Vector2d& p);
  StepRef direction(const Eigen::Vector3d& way);

  /** @brief IfcAxis2Placement3D. */
  StepRef axes(const Eigen::Vector3d& origin,
               const Eigen::Vector3d& z = Eigen::Vector3d::UnitZ(),
               const Eigen::Vector3d& x = Eigen::Vector3d::UnitX());

  /** @brief IfcLocalPlacement with z up, counted from `parent`. */
  StepRef placement(StepRef parent,
                    const Eigen::Vector3d& origin,
                    const Eigen::Vector2d& x = Eigen::Vector2d::UnitX());

  /** @brief A closed loop as a curve: a polyline, or one with arcs. */
  StepRef closedCurve(const PlanLoop& loop);

  /** @brief What is within a loop and outside of holes, swept upwards. */
  StepRef extrusion(const PlanLoop& boundary,
                    const std::vector<PlanLoop>& holes,
                    double bottom,
                    double height);

  /** @brief A swept body without what of it is above a plane.
   * @param on a place of the plane
   * @param up its unit normal, upwards */
  StepRef clipped(StepRef body, const Eigen::Vector3d& on, const Eigen::Vector3d& up);

  /** @brief A closed mesh as IfcTriangulatedFaceSet. */
  StepRef faceSet(const TriangleMesh& mesh);

  /** @brief Gives a body the colour of a kind: "space", "wall", "slab", ... */
  void colour(StepRef body, const std::string& kind);

  /** @brief IfcProductDefinitionShape of shapes such as body() and line(). */
  StepRef product(const std::vector<StepRef>& shapes);

  /** @param type "SweptSolid", "Clipping" or "Tessellation" */
  StepRef
  body(StepRef context, const std::string& type, const std::vector<StepRef>& items);

  /** @brief The axis of a wall, from one place of its plan to another. */
  StepRef line(StepRef context, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

private:
  StepRef polyline(const std::vector<Eigen::Vector2d>& corners, bool is_closed);
  StepRef indexedCurve(const PlanLoop& loop);
  StepRef styleOf(const std::string& kind);

  StepFile& step_;
  IfcArcs arcs_;
  std::map<std::string, StepRef> styles_;
};

/** @brief A loop in the frame of a wall. */
PlanLoop inFrame(PlanLoop loop, const WallFrame& frame);

/** @brief A loop of straight segments. */
PlanLoop loopOf(const std::vector<Eigen::Vector2d>& corners);

} // namespace ifc
} // namespace sedr
} // namespace pcl
