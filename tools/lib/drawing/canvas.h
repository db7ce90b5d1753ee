// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "text.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

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

  /** @brief The box with `margin` more on every side. */
  Box grown(double margin) const;
};

/** @brief A sheet to draw shapes on, smooth at their edges; coordinates in pixels, x to
 * the right, y down from the top left corner. Shapes are cut off at the clip box. */
class Canvas {
public:
  Canvas(int width, int height);

  /** @brief What is drawn from now on shows within `box` only. */
  void setClip(const Box& box);

  /** @brief Fills a box; one that is thinner than a pixel still shows. */
  void fillBox(const Box& box, Colour colour);

  void drawDisc(const Eigen::Vector2d& centre, double radius, Colour colour);

  /** @brief A line with round ends. */
  void drawLine(const Eigen::Vector2d& a,
                const Eigen::Vector2d& b,
                double width,
                Colour colour);

  /** @brief Fills a triangle where it is nearer to the viewer than the triangles before
   * it; corners are x, y and depth, less is nearer. */
  void fillTriangle(const std::array<Eigen::Vector3d, 3>& corners, Colour colour);

  /** @brief Lays a text over all shapes, those drawn later too. */
  void addText(const Text& text) { texts_.push_back(text); }

  /** @brief What was drawn. */
  Image image() const;

private:
  /** @brief Fills the fine pixels of a row whose middles lie between two x. */
  void fillRow(int row, double from, double to, Colour colour);

  void fillConvex(const std::vector<Eigen::Vector2d>& corners, Colour colour);

  Image fine_;                ///< several pixels each way for one of the image
  std::vector<float> depths_; ///< of the fine pixels; empty before the first triangle
  int clip_left_ = 0;
  int clip_right_ = 0; ///< one past
  int clip_top_ = 0;
  int clip_bottom_ = 0; ///< one past
  std::vector<Text> texts_;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
