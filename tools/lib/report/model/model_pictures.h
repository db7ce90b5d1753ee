// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/ceiling_rule.h"
#include "results/display_cloud.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief An orthographic view of a model in an image. */
class ParallelView {
public:
  /** @param model points that must be visible, metres; at least one
   * @param azimuth,elevation from the model towards the viewer, degrees
   * @param width pixels; the model fills it except for a margin */
  ParallelView(const std::vector<Eigen::Vector3d>& model,
               double azimuth,
               double elevation,
               int width);

  /** @brief Returns the image height for the model with the margin, pixels. */
  int height() const { return height_; }

  /** @brief Projects a point to x to the right and y down, pixels, and the depth away
   * from the viewer, pixels. */
  Eigen::Vector3d see(const Eigen::Vector3d& p) const;

  /** @brief Returns pixels per metre. */
  double scale() const { return scale_; }

  /** @brief Returns whether a face with this normal is turned to the viewer. */
  bool faces(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0; }

private:
  Eigen::Vector3d towards_;
  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
  Eigen::Vector2d corner_; ///< top left corner of the image, metres right and up
  double scale_ = 1;
  int height_ = 0;
};

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
  ParallelView view_;
};

} // namespace pcl::sedr::tools
