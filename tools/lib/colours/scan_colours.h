// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "joint_scan.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A surface: its room and its label. */
using Surface = std::pair<std::uint32_t, std::uint32_t>;

/** @brief Places on surfaces. */
struct SurfacePlaces {
  pcl::PointCloud<pcl::PointXYZ> points; ///< metres, in the frame of the results
  std::vector<Surface> surfaces;         ///< one a point

  void add(const Eigen::Vector3f& place, const Surface& surface);
  void add(const SurfacePlaces& others);
};

/** @brief Returns the places of points. */
SurfacePlaces placesOf(const pcl::PointCloud<pcl::PointStructure>& points);

/** @brief Returns the vertices of a mesh with labels. */
SurfacePlaces verticesOf(const TriangleMesh& mesh);

/** @brief Reads a scan and returns, for each place, the median colour, per channel, of
 * the points within 3 cm: of at most 15 of them, spread over all. Where there are none,
 * it is not seen. The memory does not depend on the size of the scan.
 * @param frame of the places, in that of the rows
 * @param threads 0: all processors */
std::vector<SeenColour> medianColours(const JointScan& scan,
                                      const SurfacePlaces& places,
                                      const BuildingFrame& frame,
                                      unsigned threads);

/** @brief The colours of surfaces: of floors, walls, ..., by places on them. */
class SurfaceColours {
public:
  SurfaceColours() = default;

  /** @param places only those of the structure are used
   * @param colours of the places; only those that were seen are used
   * @param near how far from a place its colour is seen, metres */
  SurfaceColours(const SurfacePlaces& places,
                 const std::vector<SeenColour>& colours,
                 double near);

  /** @brief Returns whether nothing has a colour. */
  bool empty() const { return of_surface_.empty(); }

  /** @brief Returns the colours of places, empty if nothing has a colour: that of the
   * nearest place of the surface. It is seen if that one is near, else filled in.
   * @param threads 0: all processors */
  std::vector<SeenColour> of(const SurfacePlaces& places, unsigned threads) const;

  /** @brief Returns the median colours of the elements of a solid, of places 10 cm
   * apart; empty if nothing has a colour. They are seen if half of the element is.
   * @param elements their number */
  std::vector<SeenColour>
  ofElements(const TriangleMesh& mesh, std::size_t elements, unsigned threads) const;

private:
  struct Painted {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    std::vector<SeenColour> colours;
  };

  SeenColour at(const pcl::PointXYZ& place, const Surface& surface) const;

  std::map<Surface, Painted> of_surface_;
  double near_ = 0; ///< metres
};

/** @brief Returns the colours that a scan gives the surfaces of a model: see
 * medianColours(), of the points of the structure, the vertices of the mesh, and places
 * on the solid.
 * @param threads 0: all processors */
SurfaceColours coloursOf(const JointScan& scan,
                         const StructureModel& model,
                         const TriangleMesh& mesh,
                         const TriangleMesh& solid,
                         unsigned threads);

} // namespace pcl::sedr::tools
