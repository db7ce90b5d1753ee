// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/room_solid.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** @brief Builds the sharp solid of a floor plan: one closed surface per room with few
 * triangles. Its corners are those of the plan. This goes beyond the paper, whose
 * Poisson surface rounds every edge.
 *
 * Input is a plan from FloorplanFitting or sedr::floorplanFromJson(). An input cloud is
 * not needed; if one is set, only its header is used. Frame: z up, metres.
 *
 * Floors, ceilings and undersides of details are planes, level or sloping, over their
 * part of the plan. Walls, columns, risers and niches are vertical. Arcs become facets
 * within the chord tolerance. Each room is closed, manifold at edges and vertices and
 * free of self-intersections, whatever the plan. Loops that miss each other by noise
 * are snapped together. Where details contradict, the later one wins. getWarnings()
 * tells what was changed.
 *
 * Triangles face out of the room, as in the truth of a simulated scene.
 * StructuralPoisson differs: its normals are those of the points. Each triangle refers
 * to its element of the plan: getMesh().elements holds indices into getElements() plus
 * 1.
 *
 * The same plan gives the same output, byte for byte. A flat takes milliseconds.
 *
 * A missing plan, a plan without rooms or a tolerance out of range give an empty mesh
 * and a reason. A room that cannot be built is left out and named by getErrorMessage();
 * the others are built. */
template <typename PointT>
class FloorplanExtrusion : public sedr::MeshReconstruction<PointT> {
public:
  using Ptr = pcl::shared_ptr<FloorplanExtrusion<PointT>>;
  using ConstPtr = pcl::shared_ptr<const FloorplanExtrusion<PointT>>;

  /** @brief Sets the plan to build. Required. */
  void setFloorplan(const std::shared_ptr<const sedr::Floorplan>& plan)
  {
    plan_ = plan;
  }

  /** @brief As above; the plan is moved or copied. */
  void setFloorplan(sedr::Floorplan plan)
  {
    plan_ = std::make_shared<const sedr::Floorplan>(std::move(plan));
  }
  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return plan_; }

  /** @brief Sets the maximum distance of facets from their arc, metres, 1e-6 to 1.
   * Default 0.00025, which is 0.15 mm on average for a round wall. */
  void setChordTolerance(double tolerance) { parameters_.chord_tolerance = tolerance; }
  double getChordTolerance() const { return parameters_.chord_tolerance; }

  /** @brief Sets whether the plan's openings are cut through the walls, with reveals.
   * Default false: walls are closed, as in the paper. A door then joins the solids of
   * two rooms to one closed manifold; an opening to the outside ends at the outer face
   * of its wall. Rooms' reports are those of their solids before that, each with its
   * part of the reveals, whose elements are named room_1_opening_3_side_2 by the number
   * of the opening in the plan. Openings that cannot be cut stay closed, with a
   * warning: in tilted walls, and where the plan has no wall beside them. */
  void setCutOpenings(bool cut) { parameters_.cut_openings = cut; }
  bool getCutOpenings() const { return parameters_.cut_openings; }

  /** @brief Returns the elements that triangles belong to, room by room in the plan's
   * order. */
  const std::vector<sedr::SolidElement>& getElements() const { return elements_; }

  /** @brief Returns the report of each room, in the plan's order. */
  const std::vector<sedr::RoomSolidReport>& getReports() const { return reports_; }

  /** @brief Returns a sentence for each contradiction of the plan that was resolved,
   * and for each pair of rooms that overlap. */
  const std::vector<sedr::PlanWarning>& getWarnings() const { return warnings_; }

  /** @brief Returns true if the last run made a closed, manifold solid of every room.
   */
  bool isClosed() const { return closed_; }

protected:
  std::string getClassName() const override { return "FloorplanExtrusion"; }

  /** @brief Builds all rooms into mesh_. */
  bool run() override;

private:
  using sedr::MeshReconstruction<PointT>::mesh_;
  using sedr::MeshReconstruction<PointT>::fail;

  std::shared_ptr<const sedr::Floorplan> plan_;
  sedr::SolidParameters parameters_;
  std::vector<sedr::SolidElement> elements_;
  std::vector<sedr::RoomSolidReport> reports_;
  std::vector<sedr::PlanWarning> warnings_;
  bool closed_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>
#endif
