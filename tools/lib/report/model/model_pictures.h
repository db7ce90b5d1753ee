// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_image.h"
#include "results/ceiling_rule.h"
#include "results/display_cloud.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Pictures of a page, all with the same direction and scale, drawn without a
 * display. Ceilings of scan and model are omitted. Each is returned as the bytes of a
 * PNG. */
class ModelPictures {
public:
  /** @param outline points that must be visible, metres; at least one
   * @param rule defines the ceilings */
  ModelPictures(const std::vector<Eigen::Vector3d>& outline, CeilingRule rule);

  /** @brief Draws the scan, by height from dark to light, without points more than 1 m
   * outside the outline's box. */
  std::string scan(const DisplayCloud& cloud) const;

  /** @brief Draws the faces of a mesh whose room side is visible, coloured by label.
   * @param mesh triangles face into the rooms */
  std::string model(const TriangleMesh& mesh) const;

  /** @brief Draws points by distance from the mesh (paper, Figure 11), without those
   * farther than `farthest` metres. The caller removes ceilings.
   * @param distances one per point, metres
   * @param spacing of the points, metres; determines their size, so that surfaces close
   * @param range distance with the last colour, metres */
  std::string distances(const DisplayCloud& cloud,
                        const std::vector<double>& distances,
                        double spacing,
                        double range,
                        double farthest) const;

private:
  Eigen::AlignedBox3d box_;
  CeilingRule rule_;
  ParallelView view_; ///< in fine pixels
};

} // namespace pcl::sedr::tools
