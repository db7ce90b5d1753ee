// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "joint_scan.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Reads a scan and returns the median colours of groups of its points, per
 * channel; those of groups without colours are not seen. At most 15 points of a group
 * are kept, spread over all of them.
 * @param group_of of a place in the frame of the rows; thread-safe
 * @param groups their number; higher ones are left out
 * @param threads 0: all processors */
std::vector<SeenColour>
medianColours(const JointScan& scan,
              const std::function<std::size_t(const Eigen::Vector3f&)>& group_of,
              std::size_t groups,
              unsigned threads);

/** @brief The colours of surfaces: of floors, walls, ..., by places on them. */
class SurfaceColours {
public:
  SurfaceColours() = default;

  /** @brief A surface: its room and its label. */
  using Surface = std::pair<std::uint32_t, std::uint32_t>;

  /** @param surfaces of the points; only those of the structure are used
   * @param colours of the points; only those that were seen are used
   * @param voxel_size of the points, metres */
  SurfaceColours(const pcl::PointCloud<pcl::PointXYZ>& points,
                 const std::vector<Surface>& surfaces,
                 const std::vector<SeenColour>& colours,
                 double voxel_size);

  /** @brief Returns whether nothing has a colour. */
  bool empty() const { return of_surface_.empty(); }

  /** @brief Returns the colour of the nearest point of the surface. It is seen if the
   * point is within a voxel and 2.5 cm; else it is filled in. Thread-safe. */
  SeenColour at(const Eigen::Vector3f& place, const Surface& surface) const;

  /** @brief Returns the colours of the vertices of a mesh with labels, empty if nothing
   * has a colour.
   * @param threads 0: all processors */
  std::vector<SeenColour> ofVertices(const TriangleMesh& mesh, unsigned threads) const;

  /** @brief Returns the colours of points, empty if nothing has a colour. */
  std::vector<SeenColour> ofPoints(const pcl::PointCloud<pcl::PointStructure>& points,
                                   unsigned threads) const;

  /** @brief Returns the median colours of the elements of a solid, empty if nothing has
   * a colour. They are seen if half of the element is. */
  std::vector<SeenColour> ofElements(const TriangleMesh& mesh,
                                     const std::vector<SolidElement>& elements) const;

private:
  struct Painted {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    std::vector<SeenColour> colours;
  };

  std::map<Surface, Painted> of_surface_;
  double near_ = 0; ///< metres
};

} // namespace pcl::sedr::tools
