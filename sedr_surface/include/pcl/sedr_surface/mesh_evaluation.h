// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_surface/triangle_mesh.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <vector>

namespace pcl::sedr {

class TriangleTree;

/** @brief Exact distances from points to a mesh, by a tree of boxes.
 *
 * The mesh must be valid (TriangleMesh::problem() empty), have triangles and outlive
 * this object. Construction is O(n log n), a query about O(log n); 60 bytes per
 * triangle. Any number of threads may query. */
class MeshDistance {
public:
  explicit MeshDistance(const TriangleMesh& mesh);
  ~MeshDistance();
  MeshDistance(const MeshDistance&) = delete;
  MeshDistance& operator=(const MeshDistance&) = delete;

  /** @brief Returns the distance of each point from the nearest triangle, metres, never
   * negative. The points must be finite. The result does not depend on the number of
   * threads (0 = all processors). */
  std::vector<double> distances(const std::vector<Eigen::Vector3d>& points,
                                unsigned threads = 0) const;

private:
  std::unique_ptr<const TriangleTree> tree_;
};

/** @brief Points on a mesh, each standing for the same share of its area. */
struct MeshSamples {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> triangles; ///< the triangle that each point lies on
  double spacing = 0;                   ///< root of the area per point, metres
};

/** @brief Spreads points evenly over the area of a mesh.
 *
 * One point is drawn from each of n equal strips of the summed triangle areas. Inside a
 * triangle the points follow a low-discrepancy sequence, without clumps or gaps.
 *
 * @param mesh must be valid; a mesh without area gets no points
 * @param spacing metres between one point and the next, above zero: n = area /
 * spacing^2, at least one
 * @param seed selects the set of points
 * @param max_samples limit of n; the spacing grows where it would be exceeded */
MeshSamples sampleMesh(const TriangleMesh& mesh,
                       double spacing,
                       std::uint64_t seed,
                       std::size_t max_samples = 20'000'000);

/** @brief Statistics of a set of distances, metres. */
struct DistanceStatistics {
  std::size_t count = 0;
  double mean = 0;
  double rms = 0;
  double median = 0; ///< the lowest distance that at least half of them do not exceed
  double p95 = 0;    ///< the same for 95 %
  double p99 = 0;
  double max = 0;
  double within_1cm = 0;      ///< share from 0 to 1 with at most 0.01 m
  double within_5cm = 0;      ///< share with at most 0.05 m; of area for even samples
  double histogram_range = 0; ///< upper end of the evenly divided bins, metres
  std::vector<std::size_t> histogram; ///< distances per bin; upper end excluded
  std::size_t beyond_histogram = 0;   ///< distances of histogram_range or more
};

/** @brief Computes statistics of distances; all zero for an empty input. O(n log n).
 *
 * @param distances metres, not negative
 * @param bins number of bins of the histogram; 0: no histogram
 * @param range upper end of the histogram, metres, above zero */
DistanceStatistics summarizeDistances(std::vector<double> distances,
                                      std::size_t bins = 20,
                                      double range = 0.1);

/** @brief Properties of a single mesh. */
struct MeshFigures {
  MeshTopology topology; ///< of the mesh as it is stored
  bool closed = false;   ///< see MeshTopology::isClosedManifold()
  /// Closed after vertices at equal positions are merged, as many programs do on
  /// reading.
  bool closed_when_welded = false;
  double area = 0;   ///< square metres
  double volume = 0; ///< cubic metres, negative if the normals point inwards
  Eigen::AlignedBox3d bounds;
  /// Pairs of triangles that intersect, up to 1000; empty if not searched for.
  std::optional<std::size_t> self_intersections;
};

/** @brief Results of MeshEvaluation. Members that the inputs do not allow are empty. */
struct MeshEvaluationResult {
  MeshFigures mesh;
  std::optional<MeshFigures> truth;
  std::optional<DistanceStatistics> cloud_to_mesh;
  std::optional<DistanceStatistics>
      mesh_to_truth; ///< precision: is what the model shows real?
  std::optional<DistanceStatistics>
      truth_to_mesh;              ///< completeness: does the model show what is real?
  double sample_spacing = 0;      ///< metres between samples, the larger of both meshes
  std::size_t skipped_points = 0; ///< non-finite points of the cloud
};

/** @brief Writes the result as a JSON object: metres, square and cubic metres, shares
 * from 0 to 1. */
void writeJson(std::ostream& stream, const MeshEvaluationResult& result);

/** @brief Computes the properties of a mesh. O(n log n). */
MeshFigures measureMesh(const TriangleMesh& mesh);

} // namespace pcl::sedr

namespace pcl {
/** @brief Measures the quality of a model: whether its mesh is the closed boundary of a
 * solid, and the distances between cloud, model and truth (section 3.2 of the paper).
 *
 * Distances are exact from a point to the nearest triangle, metres, unsigned. Meshes
 * are measured at evenly spread samples, so that shares of samples are shares of area.
 * The same input gives the same result for any number of threads.
 *
 * compute() returns false for an empty or malformed mesh, truth or cloud, for indices
 * or parameters out of range; getErrorMessage() says why. Non-finite points are skipped
 * and counted. O((s + p) log t) for s samples, p points and t triangles. */
class MeshEvaluation : public sedr::StageError {
public:
  using Ptr = std::shared_ptr<MeshEvaluation>;
  using ConstPtr = std::shared_ptr<const MeshEvaluation>;

  /** @brief Sets the model, in metres; required. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh) { mesh_ = mesh; }

  void setInputMesh(const std::shared_ptr<const sedr::TriangleMesh>& mesh)
  {
    mesh_ = mesh;
  }

  /** @brief Sets the true surface; null for none. */
  void setTruth(const pcl::PolygonMesh::ConstPtr& truth) { truth_ = truth; }

  void setTruth(const std::shared_ptr<const sedr::TriangleMesh>& truth)
  {
    truth_ = truth;
  }

  /** @brief Sets a cloud to measure against the model, of any point type with x, y and
   * z; null for none. Shared, not copied. */
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

  /** @brief Removes the cloud. */
  void setInputCloud(std::nullptr_t)
  {
    cloud_.reset();
    points_ = sedr::PointView();
  }

  /** @brief Sets which points of the cloud are measured; null for all. */
  void setIndices(const pcl::IndicesConstPtr& indices) { indices_ = indices; }

  /** @brief Sets the distance between the samples of a mesh, metres, above zero
   * (default 0.02). Beyond 20 million samples it grows; the result holds the value
   * used. */
  void setSampleSpacing(double spacing) { sample_spacing_ = spacing; }
  double getSampleSpacing() const { return sample_spacing_; }

  /** @brief Sets whether to search for triangles of the model that intersect by more
   * than 0.01 mm (default false: it takes seconds for large meshes). */
  void setFindSelfIntersections(bool find) { find_self_intersections_ = find; }
  bool getFindSelfIntersections() const { return find_self_intersections_; }

  /** @brief Sets the seed of the samples (default 1). */
  void setSeed(std::uint64_t seed) { seed_ = seed; }
  std::uint64_t getSeed() const { return seed_; }

  /** @brief Sets the number of threads (default 0: all processors). */
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }
  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief Computes every result that the inputs allow.
   * @return false if an input is invalid; `result` is then empty */
  bool compute(sedr::MeshEvaluationResult& result);

private:
  /** @brief A mesh, and why it is none. */
  struct MeshInput {
    MeshInput() = default;
    MeshInput(const pcl::PolygonMesh::ConstPtr& polygons);
    MeshInput(const std::shared_ptr<const sedr::TriangleMesh>& triangles);

    std::shared_ptr<const sedr::TriangleMesh> mesh;
    std::string problem;
  };

  bool checkParameters();

  bool checkMesh(const MeshInput& input, const char* what);

  bool selectPoints(std::vector<Eigen::Vector3d>& points, std::size_t& skipped);

  MeshInput mesh_;
  MeshInput truth_;
  std::shared_ptr<const void> cloud_;
  sedr::PointView points_;
  pcl::IndicesConstPtr indices_;
  double sample_spacing_ = 0.02;
  bool find_self_intersections_ = false;
  std::uint64_t seed_ = 1;
  unsigned threads_ = 0;
};

} // namespace pcl
