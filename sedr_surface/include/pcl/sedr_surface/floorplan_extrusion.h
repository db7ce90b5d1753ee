// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/room_solid.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** @brief The sharp solid of a floor plan: one closed surface a room, its corners those
 * of the plan, made of few triangles. Beyond the paper, whose Poisson surface rounds
 * every edge.
 *
 * Input is a plan, as FloorplanFitting or sedr::floorplanFromJson() give it; an input
 * cloud is not needed, and of one that is set only the header is taken. Frame: z up,
 * metres.
 *
 * Floors, ceilings and the undersides of details are planes, leaning ones too, each at
 * its height over its part of the plan; walls, columns, risers and niches stand
 * upright; arcs are facets within the chord tolerance. Each room is closed, manifold at
 * edges and vertices and does not meet itself, whatever the plan: loops that miss each
 * other by what noise leaves are fitted together, and of contradictions the later
 * detail wins. What was done about those is told by
 * getWarnings().
 *
 * Triangles face outwards: out of the room, as the truth of a simulated scene does, and
 * other than StructuralPoisson, whose normals are the points'. Every triangle knows its
 * element of the plan: getMesh().elements holds indices into getElements() plus 1.
 *
 * The same plan gives the same output, byte for byte. Milliseconds for a flat.
 *
 * @code
 * pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
 * extrusion.setFloorplan(plan);
 * pcl::PolygonMesh mesh;
 * extrusion.reconstruct(mesh);
 * if (!extrusion.isClosed())
 *   std::cerr << extrusion.getErrorMessage() << '\n';
 * @endcode
 *
 * No plan, one without rooms, or a tolerance out of its range leave an empty mesh and a
 * reason. A room that cannot be built is left out and named by getErrorMessage(); the
 * others are there. */
template <typename PointT>
class FloorplanExtrusion : public sedr::MeshReconstruction<PointT> {
public:
  using Ptr = pcl::shared_ptr<FloorplanExtrusion<PointT>>;
  using ConstPtr = pcl::shared_ptr<const FloorplanExtrusion<PointT>>;

  /** @brief The plan to build. Needed. */
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

  /** @brief The walls of the plan that lean; none by default. */
  void setTilts(const sedr::WallTilts& tilts) { tilts_ = tilts; }

  const sedr::WallTilts& getTilts() const { return tilts_; }

  /** @brief How far facets may be off their arc, metres, 1e-6 to 1 (default 0.0005: of
   * a round wall that is 0.3 mm on average). */
  void setChordTolerance(double tolerance) { parameters_.chord_tolerance = tolerance; }

  double getChordTolerance() const { return parameters_.chord_tolerance; }

  /** @brief How near to each other edges and corners of different loops are the same,
   * metres, 0 to 0.5 (default 0: twice the residual of the elements, from 2 mm to 5
   * cm).
   */
  void setSnapTolerance(double tolerance) { parameters_.snap_tolerance = tolerance; }

  double getSnapTolerance() const { return parameters_.snap_tolerance; }

  /** @brief What the triangles are parts of, room by room in the order of the plan. */
  const std::vector<sedr::SolidElement>& getElements() const { return elements_; }

  /** @brief What became of each room of the plan, in its order. */
  const std::vector<sedr::RoomSolidReport>& getReports() const { return reports_; }

  /** @brief What was done to contradictions of the plan, and which rooms run into each
   * other, a sentence each. */
  const std::vector<std::string>& getWarnings() const { return warnings_; }

  /** @brief True if the last run made a closed, manifold solid of every room. */
  bool isClosed() const { return closed_; }

protected:
  std::string getClassName() const override { return "FloorplanExtrusion"; }

  /** @brief Builds all rooms into mesh_. */
  bool run() override;

private:
  using sedr::MeshReconstruction<PointT>::mesh_;
  using sedr::MeshReconstruction<PointT>::fail;

  std::shared_ptr<const sedr::Floorplan> plan_;
  sedr::WallTilts tilts_;
  sedr::SolidParameters parameters_;
  std::vector<sedr::SolidElement> elements_;
  std::vector<sedr::RoomSolidReport> reports_;
  std::vector<std::string> warnings_;
  bool closed_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>
#endif
