// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/room_jobs.h>
#include <pcl/sedr_surface/room_poisson.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace pcl {

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
 * The equation is solved by sedr::screenedPoisson(), on cells along the surface: edges
 * stay sharp, the surface is closed by construction. With setSolver(Solver::Pcl) it is
 * solved by pcl::Poisson: sheets that touch are cut apart, small holes filled, slivers
 * collapsed, and if the surface still is no closed manifold the room is solved again
 * with slightly other cells, up to seven times. Runs of that in several threads of a
 * process wait for one another, and what printf prints is held back, to catch its
 * complaints.
 *
 * Normals of the output point to the side of those of the input: into the room. Of
 * points with a `label`, each triangle of getMesh() gets that of the nearest.
 *
 * The same input gives the same output, byte for byte, for any setNumberOfThreads().
 * pcl::Poisson itself repeats its result with one thread only and gets one, unless
 * setSolverThreads() asks for more.
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
 * apart, 2.5 s with pcl::Poisson. */
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
   * corners (samplePlan()), which round off less. Null (default): the points. */
  void setFloorplan(const std::shared_ptr<const sedr::Floorplan>& plan)
  {
    plan_ = plan;
  }

  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return plan_; }

  /** @brief Metres between samples of a plan away from its edges, above 0 (default
   * 0.05). */
  void setPlanSpacing(double spacing) { plan_spacing_ = spacing; }

  double getPlanSpacing() const { return plan_spacing_; }

  using Solver = sedr::PoissonSolver;

  /** @brief What solves the equation (default Solver::Sedr). */
  void setSolver(Solver solver) { parameters_.method = solver; }

  Solver getSolver() const { return parameters_.method; }

  /** @brief Largest depth of the octree, 3 to 14 (default 9, as in the paper): the
   * finest cells are no smaller than the extent over two to its power. Less is used
   * where the points bear no more; a room too large for it gets coarser cells. */
  void setDepth(int depth) { parameters_.solver.depth = depth; }

  int getDepth() const { return parameters_.solver.depth; }

  /** @brief Depth to which the octree of pcl::Poisson is filled everywhere, 0 to the
   * depth (default 5). */
  void setMinDepth(int min_depth) { parameters_.solver.min_depth = min_depth; }

  int getMinDepth() const { return parameters_.solver.min_depth; }

  /** @brief Weight of the points against the smoothness of the surface, alpha of
   * equation 4, 0 or more (default 10; pcl::Poisson has 4). Exact points bear more
   * weight: edges round off less. */
  void setPointWeight(float point_weight)
  {
    parameters_.solver.point_weight = point_weight;
  }

  float getPointWeight() const { return parameters_.solver.point_weight; }

  /** @brief Least edge of the octree's cube over the extent of the points, above 1
   * (default 1.1). */
  void setScale(float scale) { parameters_.solver.scale = scale; }

  float getScale() const { return parameters_.solver.scale; }

  /** @brief Points that an octree node of pcl::Poisson should hold, above 0 (default 1;
   * 15 to 20 for noisy points). */
  void setSamplesPerNode(float samples_per_node)
  {
    parameters_.solver.samples_per_node = samples_per_node;
  }

  float getSamplesPerNode() const { return parameters_.solver.samples_per_node; }

  /** @brief Finest cell of the octree over the spacing of the points, 0.1 to 10
   * (default 0.8). Smaller: smaller details, more triangles and time; below 0.6 the
   * surface of pcl::Poisson tends to tear. */
  void setCellRatio(double cell_ratio) { parameters_.cell_ratio = cell_ratio; }

  double getCellRatio() const { return parameters_.cell_ratio; }

  /** @brief Rooms of fewer points are not tried, at least 10 (default 100). */
  void setMinimumPoints(std::size_t min_points) { parameters_.min_points = min_points; }

  std::size_t getMinimumPoints() const { return parameters_.min_points; }

  /** @brief Holes of more edges are left open and reported (default 64). */
  void setMaxHoleEdges(std::size_t max_hole_edges)
  {
    parameters_.max_hole_edges = max_hole_edges;
  }

  std::size_t getMaxHoleEdges() const { return parameters_.max_hole_edges; }

  /** @brief Surface further than this from all points, metres above 0 (default 0.3),
   * counts as a guess: RoomPoissonReport::unsupported_share. At least four times the
   * points' spacing. */
  void setSupportDistance(double distance) { parameters_.support_distance = distance; }

  double getSupportDistance() const { return parameters_.support_distance; }

  /** @brief Threads for what is repeatable (default 1; 0: all processors). */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }

  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Threads of pcl::Poisson, at least 1 (default 1). With more it takes less
   * time, and its result differs in the last digits from run to run. */
  void setSolverThreads(int threads) { parameters_.solver.threads = threads; }

  int getSolverThreads() const { return parameters_.solver.threads; }

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
  bool checkParameters();

  std::uint32_t roomOf(pcl::index_t index) const;

  /** @brief Takes the samples of all rooms from the points. */
  bool runOnPoints();

  /** @brief Takes them from the plan. */
  bool runOnPlan();

  void gather(std::map<std::uint32_t, sedr::RoomSamples>& rooms) const;

  /** @brief Makes the surfaces of rooms; `samples(i)` is asked for once each, `sizes`
   * say how much work each is. */
  void addRooms(const std::vector<std::size_t>& sizes,
                const std::function<sedr::RoomSamples(std::size_t)>& samples,
                const sedr::RoomPoissonParameters& parameters);

  void summarize();

  sedr::RoomPoissonParameters parameters_;
  std::vector<std::uint32_t> room_labels_;
  std::shared_ptr<const sedr::Floorplan> plan_;
  double plan_spacing_ = 0.05;
  std::shared_ptr<sedr::RoomWorkers> workers_;
  std::vector<sedr::RoomPoissonReport> reports_;
  bool closed_ = false;
};

extern template class StructuralPoisson<pcl::PointNormal>;
extern template class StructuralPoisson<pcl::PointXYZRGBNormal>;
extern template class StructuralPoisson<pcl::PointStructure>;

} // namespace pcl
