// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

class TriangleTree;

/** @brief Exact distances from points to a mesh, over a tree of boxes.
 *
 * The mesh must be one (TriangleMesh::problem() empty), have triangles and outlive
 * this. Building is O(n log n), a query about O(log n); 12 bytes a triangle. Queries
 * may run in any number of threads. */
class MeshDistance {
public:
  /** @param threads for building; 0: all processors */
  explicit MeshDistance(const TriangleMesh& mesh, unsigned threads = 0);
  ~MeshDistance();
  MeshDistance(const MeshDistance&) = delete;
  MeshDistance& operator=(const MeshDistance&) = delete;

  /** @brief Distance of each point from the nearest point of a triangle, metres, never
   * negative. The points must be finite. The same for any number of threads (0 = all
   * processors). */
  std::vector<double> distances(const std::vector<Eigen::Vector3d>& points,
                                unsigned threads = 0) const;

private:
  std::unique_ptr<const TriangleTree> tree_;
};

/** @brief Points spread over a mesh, each for the same share of its area. */
struct MeshSamples {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> triangles; ///< the one that each point lies on
  double spacing = 0; ///< root of the area for which a point stands, metres
};

/** @brief Spreads points evenly over the area of a mesh.
 *
 * One point is drawn in each of n equal strips of the summed triangle areas, and inside
 * a triangle they follow a sequence that fills it evenly: no clumps, no gaps.
 *
 * @param mesh must be one; without area it gets no points
 * @param spacing metres between neighbouring points, above zero: n = area / spacing^2,
 * at least one
 * @param seed another seed, another set of points; the same seed, the same points
 * @param max_samples if n were more the spacing grows to what that many need */
MeshSamples sampleMesh(const TriangleMesh& mesh,
                       double spacing,
                       std::uint64_t seed,
                       std::size_t max_samples = 20'000'000);

/** @brief What a set of distances amounts to, metres. */
struct DistanceStatistics {
  std::size_t count = 0;
  double mean = 0;
  double rms = 0;
  double median = 0; ///< the lowest distance that at least half of them do not exceed
  double p95 = 0;    ///< the same for 95 %
  double p99 = 0;
  double max = 0;
  double within_1cm = 0; ///< share from 0 to 1 not further than 0.01 m
  double within_5cm =
      0; ///< share not further than 0.05 m; of even samples, that of the area
  double histogram_range = 0; ///< the bins divide 0 to this evenly, metres
  std::vector<std::size_t>
      histogram; ///< distances a bin; the upper end belongs to the next
  std::size_t beyond_histogram = 0; ///< distances of histogram_range or more
};

/** @brief Sums up distances; nothing in, all zero. O(n log n).
 *
 * @param distances metres, not negative
 * @param bins number of bins of the histogram; 0: no histogram
 * @param range where the histogram ends, metres, above zero */
DistanceStatistics summarizeDistances(std::vector<double> distances,
                                      std::size_t bins = 20,
                                      double range = 0.1);

} // namespace sedr
} // namespace pcl
