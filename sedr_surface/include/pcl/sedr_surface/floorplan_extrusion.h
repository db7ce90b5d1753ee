// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of extrudeRoom(). */
struct SolidParameters {
  double chord_tolerance = 0.00025; ///< distance of facets from their arc, metres
  bool cut_openings = false;        ///< of a plan: see FloorplanExtrusion
};

/** @brief Result of extruding a room. */
struct RoomSolidReport {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t triangles = 0;
  MeshTopology topology;
  bool closed = false;     ///< closed, manifold at edges and vertices, oriented, and
                           ///< no triangle without area
  double area = 0;         ///< of the whole surface, square metres
  double floor_area = 0;   ///< at all its heights, square metres, as the next three
  double ceiling_area = 0; ///< with the undersides of details
  double wall_area = 0;    ///< of walls with their niches, and of columns
  double riser_area = 0;   ///< between two heights of floor or ceiling
  double volume = 0;       ///< cubic metres
  std::string problem;     ///< why there is no closed solid, or empty
  std::vector<PlanWarning> warnings; ///< contradictions of the plan that were resolved
};

/** @brief Builds the solid that a room's walls, floor, ceiling, columns and details
 * enclose.
 *
 * @code
 * pcl::sedr::TriangleMesh solid;
 * std::vector<pcl::sedr::SolidElement> elements;
 * const auto report = pcl::sedr::extrudeRoom(plan.rooms[0], {}, solid, elements);
 * @endcode
 *
 * Floor and ceiling are planes, walls and risers vertical, arcs facets. Every corner of
 * the plan is a vertex. Triangles face outwards, as in the simulator's truth, so that
 * the volume is positive. The surface is closed, manifold at edges and vertices and
 * does not intersect itself. To ensure this, plan and heights are snapped to a grid of
 * less than a micrometre; only crossings of edges are rounded.
 *
 * @param room any room; corners of tilted walls are where three surfaces meet;
 * contradictions in it are resolved (subdivideRoom()) and reported
 * @param parameters tolerances, in range
 * @param[out] solid triangles with label, room and element; empty if nothing could be
 * built, with the reason in RoomSolidReport::problem
 * @param[in,out] elements the room's elements are appended; a triangle's element is an
 * index into it plus 1
 *
 * Milliseconds for a room of some hundred edges. */
RoomSolidReport extrudeRoom(const PlanRoom& room,
                            const SolidParameters& parameters,
                            TriangleMesh& solid,
                            std::vector<SolidElement>& elements);

} // namespace pcl::sedr

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
