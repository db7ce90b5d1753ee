// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sight_lines.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Points of a scan that panes of glass, mirrors or polished stone show a second
 * time, behind themselves. */
struct MirroredPoints {
  std::vector<std::uint8_t> of_thinned; ///< 1 for each that is one
  std::vector<std::uint8_t> of_rows;    ///< likewise
  std::vector<std::uint8_t> behind;     ///< 1 for each of the thinned points to which
                                        ///< all rays went through panes
  std::vector<SightLine> lines; ///< the rays that met no reflection; those through a
                                ///< pane end 0.3 m behind it
  std::vector<Eigen::Vector3f>
      untrue;              ///< places that no points were taken from, as the scan
                           ///< shows, see untruePlaces(); none of their rays count
  std::size_t rays = 0;    ///< that were followed
  std::size_t mirrors = 0; ///< how many surfaces mirror
};

/** @brief Finds what a scanner saw in mirrors, by its rays: those that go through a
 * surface, of which a good part ends where its like stands in front of that surface. A
 * place is a reflection if every ray to it went through such a surface and its image is
 * there.
 *
 * Metres, any frame. Points that are not finite, and those of rows without a known
 * position, are never reflections. O(n) for n points, and for each ray its length. The
 * same for any number of threads.
 * @param thinned one point a voxel
 * @param rows every `step`-th point of the scan, those that are not finite too
 * @param positions where the rows were taken from
 * @param threads 0: as many as there are processors */
MirroredPoints findMirroredPoints(const PointView& thinned,
                                  const PointView& rows,
                                  std::size_t step,
                                  const ScanPositions& positions,
                                  unsigned threads = 0);

} // namespace pcl::sedr
