// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "text.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A rectangle, in pixels or in metres. */
struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1); ///< below low: empty

  bool isEmpty() const { return !((high - low).array() >= 0).all(); }

  Eigen::Vector2d size() const { return high - low; }

  bool contains(const Eigen::Vector2d& p) const
  {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }

  void extend(const Eigen::Vector2d& p);

  void extend(const Box& box);

  /** @brief Returns the box grown by `margin` on every side. */
  Box grown(double margin) const;
};

/** @brief An antialiased raster for shapes. Coordinates are pixels, x to the right, y
 * down from the top left corner. Shapes are clipped to the clip box. */
class Canvas {
public:
  /** @param width,height pixels
   * @param fineness fine pixels per pixel along each axis */
  Canvas(int width, int height, int fineness = 3);

  /** @brief Restricts what is drawn from now on to `box`. */
  void setClip(const Box& box);

  /** @brief Fills a box; boxes thinner than a pixel stay visible. */
  void fillBox(const Box& box, Colour colour);

  void drawDisc(const Eigen::Vector2d& centre, double radius, Colour colour);

  /** @brief Draws a line with round ends. */
  void drawLine(const Eigen::Vector2d& a,
                const Eigen::Vector2d& b,
                double width,
                Colour colour);

  /** @brief Fills a triangle where it is nearer to the viewer than earlier ones.
   * Corners are x, y and depth; smaller is nearer. */
  void fillTriangle(const std::array<Eigen::Vector3d, 3>& corners, Colour colour);

  /** @brief Fills a square around a place, x, y and depth, where it is nearer to the
   * viewer than earlier triangles and squares. */
  void fillSquare(const Eigen::Vector3d& place, double size, Colour colour);

  /** @brief Darkens triangles and squares behind nearby ones, which shows the shape of
   * unshaded points. */
  void shadeDepth();

  /** @brief Adds a text above all shapes, including later ones. */
  void addText(const Text& text) { texts_.push_back(text); }

  /** @brief Returns the image. */
  Image image() const;

private:
  /** @brief Fills the fine pixels of a row with centres between two x. */
  void fillRow(int row, double from, double to, Colour colour);

  void fillConvex(const std::vector<Eigen::Vector2d>& corners, Colour colour);

  /** @brief Returns the depth of a fine pixel, infinite for the background. */
  float& depthAt(int x, int y);

  void put(int x, int y, double depth, Colour colour);

  int fineness_;
  Image fine_;                ///< supersampled image
  std::vector<float> depths_; ///< of the fine pixels; empty before the first depth
  int clip_left_ = 0;
  int clip_right_ = 0; ///< one past
  int clip_top_ = 0;
  int clip_bottom_ = 0; ///< one past
  std::vector<Text> texts_;
};

} // namespace pcl::sedr::tools
