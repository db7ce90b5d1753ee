// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/poisson_level.h"
#include "../solver/surface_samples.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A tangent plane of the surface. */
struct SurfacePlane {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

/** @brief The samples in and around one block of the finest grid, for queries of
 * tangent planes. Lengths in cells, from the block's first node. */
class SurfacePlanes {
public:
  /** @brief Samples further than `radius`, at most 8 cells, do not contribute to a
   * plane. */
  explicit SurfacePlanes(float radius)
      : radius_(std::min(radius, 8.f))
  {}

  /** @brief Loads the samples around block `b`. */
  void load(const BandGrid& grid, std::size_t b, const SortedSamples& samples)
  {
    around_.clear();
    samples.gather(grid.at(b), radius_, around_);
    places_.resize(static_cast<Eigen::Index>(around_.size()), 3);
    for (std::size_t i = 0; i < around_.size(); ++i)
      places_.row(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::RowVector3f>(around_[i].place);
  }

  /** @brief Fits a plane to samples around `place` on the side of `slope` whose normals
   * agree with that of the nearest one. Near an edge, the plane is that of one of its
   * sides. Follows curved surfaces.
   * @return false if there are no samples */
  bool
  find(const Eigen::Vector3f& place, const Eigen::Vector3f& slope, SurfacePlane& plane)
  {
    constexpr float agree = 0.9f;      // cosine of 25 degrees
    constexpr float min_share = 0.15f; // of the weight; below it, an outlier
    distance2_ = (places_.col(0) - place[0]).square() +
                 (places_.col(1) - place[1]).square() +
                 (places_.col(2) - place[2]).square();
    near_.clear();
    float all = 0;
    const float radius2 = radius_ * radius_;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const float distance2 = distance2_[static_cast<Eigen::Index>(i)];
      if (distance2 >= radius2 || normalOf(i).dot(slope) <= 0)
        continue;
      const float closeness = 1 - distance2 / radius2;
      near_.push_back({i, distance2, closeness * closeness});
      all += closeness * closeness;
    }
    std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) {
      return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : a.index < b.index;
    });
    for (const Near& seed : near_) {
      const Eigen::Vector3f direction = normalOf(seed.index);
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      float weight = 0;
      for (const Near& other : near_)
        if (normalOf(other.index).dot(direction) > agree) {
          sum += other.weight * normalOf(other.index);
          weight += other.weight;
        }
      if (weight < min_share * all)
        continue;
      plane.normal = sum.normalized();
      // The mean of own and mean normal is exact on planes and on round surfaces.
      float height = 0;
      for (const Near& other : near_) {
        const Eigen::Vector3f normal = normalOf(other.index);
        if (normal.dot(direction) <= agree)
          continue;
        const Eigen::Vector3f from =
            place - Eigen::Map<const Eigen::Vector3f>(around_[other.index].place);
        height += other.weight * 0.5f * (normal + plane.normal).dot(from);
      }
      plane.point = place - height / weight * plane.normal;
      return true;
    }
    return false;
  }

private:
  struct Near {
    std::size_t index;
    float distance2;
    float weight;
  };

  Eigen::Map<const Eigen::Vector3f> normalOf(std::size_t i) const
  {
    return Eigen::Map<const Eigen::Vector3f>(around_[i].normal);
  }

  float radius_;
  std::vector<BlockSample> around_; ///< with unit normals
  Eigen::ArrayX3f places_;          ///< of these samples, by axis
  Eigen::ArrayXf distance2_;
  std::vector<Near> near_;
};

/** @brief Makes the nodes above zero well composed: where such nodes (or the others)
 * touch only along an edge or at a corner of a cell, one of them changes sign. The
 * faces between nodes of different sign then form a closed manifold surface, and each
 * cell holds at most one piece of it.
 *
 * Nodes with values nearest to zero change first. If that does not converge, nodes
 * above zero change, which terminates. O(blocks) per round. */
void
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads);

/** @brief Properties of a surface vertex besides its position. */
struct SurfaceVertex {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< mean of the faces that meet
  Eigen::Vector3f line = Eigen::Vector3f::Zero();   ///< direction of its edge
  std::uint8_t sharpness = 0; ///< 0 on a face, 1 at an edge, 2 at a corner
};

/** @brief Removes folds (triangles that face against the normals of their vertices) and
 * slivers from a closed manifold surface by edge collapses, in which the sharper vertex
 * stays in place. The surface stays closed and manifold.
 *
 * @param vertices properties of each vertex of the mesh
 * @param min_height slivers are triangles of less height
 * @param longest maximum length of edges to collapse
 *
 * O(n), in a fixed order. */
void mendSurface(TriangleMesh& mesh,
                 std::vector<SurfaceVertex>& vertices,
                 double min_height,
                 double longest);

/** @brief Extracts the surface between nodes with values above zero and the others by
 * dual contouring. Each cell that the surface crosses has a vertex, each crossed grid
 * edge two triangles. The surface is closed and manifold if the values are well
 * composed (makeWellComposed()) and it stays away from the rim of the blocks.
 *
 * Crossings of edges are projected onto the planes of nearby samples, and each vertex
 * is placed where the planes of its cell meet. Edges and corners stay sharp, flat faces
 * flat.
 *
 * @param values at the nodes of `grid`
 * @param samples in blocks of the same grid
 * @param radius range of samples that contribute to a plane, cells
 * @param mesh vertices in cells, normals towards values above zero; independent of the
 * number of threads
 * @param vertices properties of each vertex */
void extractDualSurface(const BandGrid& grid,
                        const std::vector<float>& values,
                        const SortedSamples& samples,
                        float radius,
                        unsigned threads,
                        TriangleMesh& mesh,
                        std::vector<SurfaceVertex>& vertices);

} // namespace pcl::sedr
