// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <pcl/types.h>

#include <iosfwd>
#include <memory>
#include <optional>

namespace pcl {
namespace sedr {

/** @brief What can be said of a mesh by itself. */
struct MeshFigures {
  MeshTopology topology; ///< of the mesh as it is stored
  bool closed = false;   ///< see MeshTopology::isClosedManifold()
  /// The same for the mesh with equal positions made one vertex, as many programs read
  /// it.
  bool closed_when_welded = false;
  double area = 0;   ///< square metres
  double volume = 0; ///< cubic metres, negative if the normals point inwards
  Eigen::AlignedBox3d bounds;
  /// Pairs of triangles that meet, up to 1000; empty if they were not looked for.
  std::optional<std::size_t> self_intersections;
};

/** @brief What MeshEvaluation found. What the inputs did not allow is empty. */
struct MeshEvaluationResult {
  MeshFigures mesh;
  std::optional<MeshFigures> truth;
  std::optional<DistanceStatistics> cloud_to_mesh;
  std::optional<DistanceStatistics>
      mesh_to_truth; ///< precision: is what the model shows there?
  std::optional<DistanceStatistics>
      truth_to_mesh;              ///< completeness: does the model show it?
  double sample_spacing = 0;      ///< metres between samples, the wider of both meshes
  std::size_t skipped_points = 0; ///< points of the cloud that are not finite
};

/** @brief Writes the result as a JSON object: metres, square and cubic metres, shares
 * from 0 to 1.
 * @param indent spaces before every line but the first */
void
writeJson(std::ostream& stream, const MeshEvaluationResult& result, int indent = 0);

/** @brief Looks at a mesh by itself. O(n log n). */
MeshFigures measureMesh(const TriangleMesh& mesh);

} // namespace sedr

/** @brief Tells how good a model is: whether its mesh is the closed boundary of a
 * solid, and how far cloud, model and truth lie apart (section 3.2 of the paper).
 *
 * Distances are exact from a point to the nearest triangle, in metres, without a sign.
 * Of meshes, evenly spread samples are measured, so that shares of samples are shares
 * of area. The same input gives the same result for any number of threads.
 *
 * @code
 * pcl::MeshEvaluation evaluation;
 * evaluation.setInputMesh(mesh);
 * evaluation.setTruth(truth);
 * evaluation.setInputCloud(scan);
 * pcl::sedr::MeshEvaluationResult result;
 * if (!evaluation.compute(result))
 *   std::cerr << evaluation.getErrorMessage() << '\n';
 * @endcode
 *
 * An empty or malformed mesh, truth or cloud, indices out of range or a parameter out
 * of its range make compute() return false; getErrorMessage() says why. Points that are
 * not finite are skipped and counted. O((s + p) log t) for s samples, p points and t
 * triangles. */
class MeshEvaluation : public sedr::StageError {
public:
  using Ptr = std::shared_ptr<MeshEvaluation>;
  using ConstPtr = std::shared_ptr<const MeshEvaluation>;

  /** @brief The model, in metres; required. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh);

  void setInputMesh(const std::shared_ptr<const sedr::TriangleMesh>& mesh);

  /** @brief The surface that the model should have; null for none. */
  void setTruth(const pcl::PolygonMesh::ConstPtr& truth);

  void setTruth(const std::shared_ptr<const sedr::TriangleMesh>& truth);

  /** @brief A cloud to measure from the model, of any point type with x, y and z; null
   * for none. Shared, not copied. */
  template <typename PointT>
  void setInputCloud(const std::shared_ptr<pcl::PointCloud<PointT>>& cloud)
  {
    setInputCloud(std::shared_ptr<const pcl::PointCloud<PointT>>(cloud));
  }

  template <typename PointT>
  void setInputCloud(const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud)
  {
    cloud_ = cloud;
    points_ = cloud ? sedr::PointView(*cloud) : sedr::PointView();
  }

  /** @brief Leaves the cloud out again. */
  void setInputCloud(std::nullptr_t)
  {
    cloud_.reset();
    points_ = sedr::PointView();
  }

  /** @brief The points of the cloud to measure; null for all. */
  void setIndices(const pcl::IndicesConstPtr& indices) { indices_ = indices; }

  /** @brief Metres between the samples of a mesh, above zero (default 0.02). Beyond 20
   * million samples the spacing grows; the result says to what. */
  void setSampleSpacing(double spacing) { sample_spacing_ = spacing; }

  double getSampleSpacing() const { return sample_spacing_; }

  /** @brief Whether to look for triangles of the model that go through each other by
   * more than 0.01 mm (default false: it takes seconds for large meshes). */
  void setFindSelfIntersections(bool find) { find_self_intersections_ = find; }

  bool getFindSelfIntersections() const { return find_self_intersections_; }

  /** @brief Chooses the samples (default 1). */
  void setSeed(std::uint64_t seed) { seed_ = seed; }

  std::uint64_t getSeed() const { return seed_; }

  /** @brief Bins of the histograms (default 20; 0: none) and where they end, metres,
   * above zero (default 0.1). */
  void setHistogram(std::size_t bins, double range)
  {
    histogram_bins_ = bins;
    histogram_range_ = range;
  }

  std::size_t getHistogramBins() const { return histogram_bins_; }

  double getHistogramRange() const { return histogram_range_; }

  /** @brief Number of threads (default 0: all processors). */
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief Measures all that the inputs allow.
   * @return false if something is wrong with them; `result` is empty then */
  bool compute(sedr::MeshEvaluationResult& result);

private:
  /** @brief A mesh as it was given, to be converted when the run starts. */
  struct MeshInput {
    pcl::PolygonMesh::ConstPtr polygons;
    std::shared_ptr<const sedr::TriangleMesh> triangles;

    bool isSet() const { return polygons || triangles; }
  };

  bool checkParameters();

  bool prepare(const MeshInput& input,
               const char* what,
               std::shared_ptr<const sedr::TriangleMesh>& mesh);

  bool selectPoints(std::vector<Eigen::Vector3d>& points, std::size_t& skipped);

  sedr::DistanceStatistics measure(const std::vector<Eigen::Vector3d>& points,
                                   const sedr::MeshDistance& mesh) const;

  MeshInput mesh_;
  MeshInput truth_;
  std::shared_ptr<const void> cloud_;
  sedr::PointView points_;
  pcl::IndicesConstPtr indices_;
  double sample_spacing_ = 0.02;
  bool find_self_intersections_ = false;
  std::uint64_t seed_ = 1;
  std::size_t histogram_bins_ = 20;
  double histogram_range_ = 0.1;
  unsigned threads_ = 0;
};

} // namespace pcl
