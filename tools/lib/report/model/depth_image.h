// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A viewer infinitely far away, who sees a model at one scale in an image. */
class ParallelView {
public:
  /** @param model points that are to be seen, metres; at least one
   * @param azimuth,elevation from the model towards the viewer, degrees
   * @param width pixels; the model fills them but for a margin */
  ParallelView(const std::vector<Eigen::Vector3d>& model,
               double azimuth,
               double elevation,
               int width);

  /** @brief Pixels that the model needs from top to bottom, with the margin. */
  int height() const { return height_; }

  /** @brief x to the right and y down, pixels; z the depth away from the viewer,
   * pixels. */
  Eigen::Vector3d see(const Eigen::Vector3d& p) const;

  /** @brief Pixels a metre. */
  double scale() const { return scale_; }

  /** @brief Whether a face with that normal is turned to the viewer. */
  bool faces(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0; }

private:
  Eigen::Vector3d towards_;
  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
  Eigen::Vector2d corner_; ///< of the image at the top left, metres right and up
  double scale_ = 1;
  int height_ = 0;
};

/** @brief A picture of points and triangles in which the nearest shows: everything is
 * drawn in twice the size and shrunk. Needs no display. */
class DepthImage {
public:
  /** @brief Fine pixels for one of the image, each way: places are told in these. */
  static constexpr int fineness = 2;

  /** @param width,height of the image, pixels */
  DepthImage(int width, int height);

  /** @brief A square of `size` fine pixels around a place that a view has seen. */
  void addPoint(const Eigen::Vector3d& place, Colour colour, int size);

  void addTriangle(const std::array<Eigen::Vector3d, 3>& corners, Colour colour);

  /** @brief Darkens what lies behind something beside it, so that points without
   * shading of their own show their shape. */
  void shadeDepth();

  /** @brief The image, on white. */
  Image image() const;

private:
  void put(int x, int y, double depth, Colour colour);

  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(fine_.width) +
           static_cast<std::size_t>(x);
  }

  Image fine_;
  std::vector<float> depths_; ///< infinite where nothing is
};

} // namespace tools
} // namespace sedr
} // namespace pcl
