// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_image.h"
#include "results/ceiling_rule.h"
#include "results/display_cloud.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The pictures of a page: one direction and one scale for all, drawn without a
 * display; of scan and model the ceilings are left out. Each is the bytes of a PNG. */
class ModelPictures {
public:
  /** @param outline points that are to be seen, metres; at least one
   * @param rule what the ceilings are */
  ModelPictures(const std::vector<Eigen::Vector3d>& outline, CeilingRule rule);

  /** @brief The scan, by height from dark to light; what lies more than 1 m outside of
   * the outline's box is left out. */
  std::string scan(const DisplayCloud& cloud) const;

  /** @brief The faces of a mesh that the viewer sees the room's side of, by label.
   * @param mesh triangles face into the rooms */
  std::string model(const TriangleMesh& mesh) const;

  /** @brief Points by their distance from the mesh (paper, Figure 11); those farther
   * than `farthest` metres are left out, ceilings are for the caller to leave out.
   * @param distances one a point, metres
   * @param spacing of the points, metres: they are drawn so large that surfaces close
   * @param range distance of the last colour, metres */
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

} // namespace tools
} // namespace sedr
} // namespace pcl
