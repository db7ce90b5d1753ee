// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/mesh_topology.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

class RoomWorkers;
struct RoomSamples;

/** @brief How the equation of a room was solved. */
struct ScreenedPoissonReport {
  double cell = 0;       ///< metres; larger than asked for where nodes ran out
  std::size_t nodes = 0; ///< of the finest grid
  int levels = 0;        ///< grids, each with cells twice those of the one before
  int iterations = 0;    ///< of conjugate gradients on the finest grid
  double residual = 0;   ///< there, over the right side
  bool converged = false;
  double iso_value = 0; ///< mean at the points; -1/2 is behind, 1/2 before them
  int widened = 0;      ///< times that the finest grid was widened
  std::size_t turned_signs =
      0; ///< nodes that changed sign to keep the surface whole and manifold
  std::size_t collapsed_edges = 0; ///< to take out folds and slivers
};

/** @brief How the surface of a room is made; see StructuralPoisson. */
struct RoomPoissonParameters {
  int depth = 9;                ///< a maximum: the finest cells are no smaller than the
                                ///< room over two to its power
  float point_weight = 10;      ///< alpha of equation 4
  double cell_ratio = 0.8;      ///< finest cell / spacing of the points
  std::size_t min_points = 100; ///< a room of fewer is not tried
  double support_distance =
      0.3;              ///< metres; further from all points, a surface is a guess
  unsigned threads = 1; ///< 0: all processors
};

/** @brief What became of a room. */
struct RoomPoissonReport {
  std::uint32_t room = 0;
  std::size_t points = 0;          ///< used
  std::size_t skipped_points = 0;  ///< not finite, or without a normal
  std::size_t scaled_normals = 0;  ///< of another length than 1, made unit length
  double spacing = 0;              ///< of the points, metres
  int depth = 0;                   ///< two to its power cells are as long as the room
  double cell = 0;                 ///< edge of the finest cells, metres
  ScreenedPoissonReport screened;  ///< the solution
  std::size_t parted_vertices = 0; ///< moved from where another vertex is
  std::size_t removed_components = 0; ///< smaller than the largest
  std::size_t removed_triangles = 0;  ///< with these components
  MeshTopology topology;              ///< of the result
  bool closed = false;                ///< closed, manifold, oriented, one component
  double area = 0;                    ///< square metres
  double volume = 0;                  ///< cubic metres, above zero
  double unsupported_share = 0;       ///< share of the area far from all points
  std::string
      problem; ///< why there is no surface or what keeps it from being closed, or empty
  std::string warning; ///< what to know of a surface that is closed, or empty
};

/** @brief The surface of a room, with room and label of every triangle, and what became
 * of it. */
struct RoomSurface {
  TriangleMesh mesh; ///< empty without a surface
  RoomPoissonReport report;
};

} // namespace sedr

/** @brief Screened Poisson reconstruction of rooms: one closed, manifold surface a
 * room (section 2.4 of the paper).
 *
 * Input are points of the structure with normals into the room, evenly spread and
 * without large holes, as StructureRefinement and VerticalHoleRepair leave them;
 * metres. The rooms are told apart by setRoomLabels(), else by the field `room` of the
 * points, else all is one room. Points of room 0 are left out if there is any other
 * room.
 *
 * Each room is solved by itself, near the origin, so that large coordinates cost no
 * digits, with cells of a fixed share of the points' spacing. Of the surface the
 * largest component stays. What became of each room stands in getReports(); a room that
 * failed is missing from the output, one that is not closed, of which over 5 % of the
 * surface are far from all points, or of which a third or more was left out with other
 * components, is in it, and all of them are named by getErrorMessage().
 *
 * The equation is solved on cells along the surface: edges stay sharp, the surface is
 * closed by construction.
 *
 * Normals of the output point to the side of those of the input: into the room. Of
 * points with a `label`, each triangle of getMesh() gets that of the nearest.
 *
 * The same input gives the same output, byte for byte, for any setNumberOfThreads().
 *
 * @code
 * pcl::StructuralPoisson<pcl::PointStructure> poisson;
 * poisson.setInputCloud(refined);
 * pcl::PolygonMesh mesh;
 * poisson.reconstruct(mesh);
 * if (!poisson.getErrorMessage().empty())
 *   std::cerr << poisson.getErrorMessage() << '\n';
 * @endcode
 *
 * A null or empty cloud, indices out of range, too few points, points without normals
 * or a parameter out of its range leave an empty mesh and a reason. Points that are not
 * finite or have no normal are skipped and counted, normals of another length are
 * scaled. About 0.4 s of one processor for a room of 6 m x 5 m x 3 m with points 5 cm
 * apart. */
template <typename PointNT>
class StructuralPoisson : public sedr::MeshReconstruction<PointNT> {
public:
  using Ptr = pcl::shared_ptr<StructuralPoisson<PointNT>>;
  using ConstPtr = pcl::shared_ptr<const StructuralPoisson<PointNT>>;
  using PointCloud = pcl::PointCloud<PointNT>;

  /** @brief The same as reconstruct() for getMesh() alone: without PCL's form of the
   * mesh, which is several times as large.
   * @return false if there is no surface */
  bool makeMesh() { return run(); }

  /** @brief The room of every point of the input cloud; empty (default): the points'
   * own field `room`. */
  void setRoomLabels(const std::vector<std::uint32_t>& rooms) { room_labels_ = rooms; }

  const std::vector<std::uint32_t>& getRoomLabels() const { return room_labels_; }

  /** @brief A plan to take the samples from, instead of the points of a cloud, which is
   * not needed then: evenly from every room's solid, more of them along edges and
   * corners, which round off less. Null (default): the points. */
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

  /** @brief Metres between samples of a plan away from its edges, above 0 (default
   * 0.05). */
  void setPlanSpacing(double spacing) { plan_spacing_ = spacing; }

  double getPlanSpacing() const { return plan_spacing_; }

  /** @brief Largest depth, 3 to 14 (default 9, as in the paper): the finest cells are
   * no smaller than 1.1 times the room's extent over two to its power. Less is used
   * where the points bear no more; a room too large for it gets coarser cells. */
  void setDepth(int depth) { parameters_.depth = depth; }

  int getDepth() const { return parameters_.depth; }

  /** @brief Weight of the points against the smoothness of the surface, alpha of
   * equation 4, 0 or more (default 10; pcl::Poisson has 4). Exact points bear more
   * weight: edges round off less. */
  void setPointWeight(float point_weight) { parameters_.point_weight = point_weight; }

  float getPointWeight() const { return parameters_.point_weight; }

  /** @brief Finest cell over the spacing of the points, 0.1 to 10 (default 0.8).
   * Smaller: smaller details, more triangles and time. */
  void setCellRatio(double cell_ratio) { parameters_.cell_ratio = cell_ratio; }

  double getCellRatio() const { return parameters_.cell_ratio; }

  /** @brief Rooms of fewer points are not tried, at least 10 (default 100). */
  void setMinimumPoints(std::size_t min_points) { parameters_.min_points = min_points; }

  std::size_t getMinimumPoints() const { return parameters_.min_points; }

  /** @brief Surface further than this from all points, metres above 0 (default 0.3),
   * counts as a guess: RoomPoissonReport::unsupported_share. At least four times the
   * points' spacing. */
  void setSupportDistance(double distance) { parameters_.support_distance = distance; }

  double getSupportDistance() const { return parameters_.support_distance; }

  /** @brief Number of threads (default 1; 0: all processors). */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }

  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Who makes the surfaces of the rooms; null (default): this object, one after
   * the other. The result is the same. A room of which nothing comes back has no
   * surface, and its report says why. */
  void setRoomWorkers(const std::shared_ptr<sedr::RoomWorkers>& workers)
  {
    workers_ = workers;
  }

  std::shared_ptr<sedr::RoomWorkers> getRoomWorkers() const { return workers_; }

  /** @brief What became of each room, in the order of their numbers. */
  const std::vector<sedr::RoomPoissonReport>& getReports() const { return reports_; }

  /** @brief The room of every triangle of the last output. */
  const std::vector<std::uint32_t>& getTriangleRooms() const { return mesh_.rooms; }

  /** @brief True if the last run made a surface of every room and each is closed,
   * manifold and one component. */
  bool isClosed() const { return closed_; }

protected:
  using pcl::PCLBase<PointNT>::input_;
  using pcl::PCLBase<PointNT>::indices_;
  using pcl::PCLBase<PointNT>::initCompute;
  using pcl::PCLBase<PointNT>::deinitCompute;

  std::string getClassName() const override { return "StructuralPoisson"; }

  using sedr::MeshReconstruction<PointNT>::mesh_;
  using sedr::MeshReconstruction<PointNT>::fail;
  using sedr::MeshReconstruction<PointNT>::performReconstruction;

  /** @brief Reconstructs into mesh_. */
  bool run() override;

  /** @brief Gives the points their label too. */
  void performReconstruction(PointCloud& points,
                             std::vector<pcl::Vertices>& polygons) override;

private:
  /** @brief Takes the samples of all rooms from the points.
   * @return why there is no surface, a sentence; empty otherwise */
  std::string runOnPoints();

  sedr::RoomPoissonParameters parameters_;
  std::vector<std::uint32_t> room_labels_;
  std::shared_ptr<const sedr::Floorplan> plan_;
  double plan_spacing_ = 0.05;
  std::shared_ptr<sedr::RoomWorkers> workers_;
  std::vector<sedr::RoomPoissonReport> reports_;
  bool closed_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/structural_poisson.hpp>
#endif
