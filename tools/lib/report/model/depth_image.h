// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"

#include <Eigen/Core>

#include <array>
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

/** @brief A depth-buffered image of points and triangles, drawn at twice the size and
 * reduced. Needs no display. */
class DepthImage {
public:
  /** @brief Fine pixels per pixel along each axis; positions are in fine pixels. */
  static constexpr int fineness = 2;

  /** @param width,height of the image, pixels */
  DepthImage(int width, int height);

  /** @brief Draws a square of `size` fine pixels around a projected point. */
  void addPoint(const Eigen::Vector3d& place, Colour colour, int size);

  void addTriangle(const std::array<Eigen::Vector3d, 3>& corners, Colour colour);

  /** @brief Darkens pixels behind nearby ones, which shows the shape of unshaded
   * points. */
  void shadeDepth();

  /** @brief Returns the image, on white. */
  Image image() const;

private:
  void put(int x, int y, double depth, Colour colour);

  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(fine_.width) +
           static_cast<std::size_t>(x);
  }

  Image fine_;
  std::vector<float> depths_; ///< infinite for the background
};

} // namespace pcl::sedr::tools
