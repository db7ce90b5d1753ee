// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
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

} // namespace pcl::sedr
