// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Minimum width of a box in fine pixels, so that single cells are visible. */
constexpr double min_fine = 2;

constexpr float background = std::numeric_limits<float>::infinity(); ///< depth

/** @brief Returns the first fine pixel whose centre is not before `x`, within 0 and
 * `limit`. */
int
firstFrom(double x, int limit)
{
  return static_cast<int>(
      std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(limit)));
}

} // namespace

void
Box::extend(const Eigen::Vector2d& p)
{
  const bool was_empty = isEmpty();
  low = was_empty ? p : Eigen::Vector2d(low.cwiseMin(p));
  high = was_empty ? p : Eigen::Vector2d(high.cwiseMax(p));
}

void
Box::extend(const Box& box)
{
  if (box.isEmpty())
    return;
  extend(box.low);
  extend(box.high);
}

Box
Box::grown(double margin) const
{
  return {low.array() - margin, high.array() + margin};
}

Canvas::Canvas(int width, int height, int fineness)
    : fineness_(fineness)
    , fine_(fineness * width, fineness * height, colours::paper)
    , clip_right_(fine_.width)
    , clip_bottom_(fine_.height)
{}

void
Canvas::setClip(const Box& box)
{
  clip_left_ = firstFrom(fineness_ * box.low.x(), fine_.width);
  clip_right_ = firstFrom(fineness_ * box.high.x(), fine_.width);
  clip_top_ = firstFrom(fineness_ * box.low.y(), fine_.height);
  clip_bottom_ = firstFrom(fineness_ * box.high.y(), fine_.height);
}

void
Canvas::fillRow(int row, double from, double to, Colour colour)
{
  if (row < clip_top_ || row >= clip_bottom_)
    return;
  const int first = std::max(firstFrom(from, fine_.width), clip_left_);
  const int last = std::min(firstFrom(to, fine_.width), clip_right_);
  for (int x = first; x < last; ++x)
    fine_.at(x, row) = colour;
}

void
Canvas::fillBox(const Box& box, Colour colour)
{
  Eigen::Vector2d low = fineness_ * box.low;
  Eigen::Vector2d high = fineness_ * box.high;
  for (int k = 0; k < 2; ++k)
    if (high[k] - low[k] < min_fine) {
      low[k] = std::floor((low[k] + high[k] - min_fine) / 2 + 0.5);
      high[k] = low[k] + min_fine;
    }
  const int last = firstFrom(high.y(), fine_.height);
  for (int row = firstFrom(low.y(), fine_.height); row < last; ++row)
    fillRow(row, low.x(), high.x(), colour);
}

void
Canvas::drawDisc(const Eigen::Vector2d& centre, double radius, Colour colour)
{
  const Eigen::Vector2d middle = fineness_ * centre;
  const double r = fineness_ * radius;
  const int last = firstFrom(middle.y() + r, fine_.height);
  for (int row = firstFrom(middle.y() - r, fine_.height); row < last; ++row) {
    const double up = row + 0.5 - middle.y();
    const double half = std::sqrt(std::max(0.0, r * r - up * up));
    fillRow(row, middle.x() - half, middle.x() + half, colour);
  }
}

void
Canvas::fillConvex(const std::vector<Eigen::Vector2d>& corners, Colour colour)
{
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const auto& c : corners) {
    top = std::min(top, c.y());
    bottom = std::max(bottom, c.y());
  }
  const int last = firstFrom(bottom, fine_.height);
  for (int row = firstFrom(top, fine_.height); row < last; ++row) {
    const double y = row + 0.5;
    double from = std::numeric_limits<double>::infinity();
    double to = -from;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& a = corners[i];
      const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
      if ((a.y() <= y) == (b.y() <= y))
        continue;
      const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
      from = std::min(from, x);
      to = std::max(to, x);
    }
    fillRow(row, from, to, colour);
  }
}

void
Canvas::drawLine(const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b,
                 double width,
                 Colour colour)
{
  drawDisc(a, width / 2, colour);
  drawDisc(b, width / 2, colour);
  const Eigen::Vector2d way = b - a;
  if (!(way.norm() > 0))
    return;
  const Eigen::Vector2d side =
      Eigen::Vector2d(-way.y(), way.x()) / way.norm() * width / 2;
  std::vector<Eigen::Vector2d> corners{a + side, b + side, b - side, a - side};
  for (auto& c : corners)
    c *= fineness_;
  fillConvex(corners, colour);
}

float&
Canvas::depthAt(int x, int y)
{
  if (depths_.empty())
    depths_.assign(fine_.pixels.size(), background);
  return depths_[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine_.width) +
                 static_cast<std::size_t>(x)];
}

void
Canvas::put(int x, int y, double depth, Colour colour)
{
  float& nearest = depthAt(x, y);
  if (static_cast<float>(depth) >= nearest)
    return;
  nearest = static_cast<float>(depth);
  fine_.at(x, y) = colour;
}

void
Canvas::fillTriangle(const std::array<Eigen::Vector3d, 3>& corners, Colour colour)
{
  Box box;
  std::array<Eigen::Vector2d, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = fineness_ * corners[k].head<2>();
    box.extend(p[k]);
  }
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double whole = cross(p[1] - p[0], p[2] - p[0]);
  if (whole == 0)
    return;
  // Neighbours share the fine pixels along their common edge, to avoid gaps.
  constexpr double rim = -1e-9;
  const int left = std::max(clip_left_, firstFrom(box.low.x(), fine_.width));
  const int right = std::min(clip_right_, firstFrom(box.high.x(), fine_.width));
  const int top = std::max(clip_top_, firstFrom(box.low.y(), fine_.height));
  const int bottom = std::min(clip_bottom_, firstFrom(box.high.y(), fine_.height));
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const Eigen::Vector2d q(x + 0.5, y + 0.5);
      const double b = cross(q - p[0], p[2] - p[0]) / whole;
      const double c = cross(p[1] - p[0], q - p[0]) / whole;
      if (b < rim || c < rim || b + c > 1 - rim)
        continue;
      put(x, y, (1 - b - c) * corners[0].z() + b * corners[1].z() + c * corners[2].z(),
          colour);
    }
}

void
Canvas::fillSquare(const Eigen::Vector3d& place, double size, Colour colour)
{
  const auto side = static_cast<int>(std::lround(fineness_ * size));
  const auto low = [&](double at) {
    return static_cast<int>(std::floor(fineness_ * at - side / 2.0 + 0.5));
  };
  const int left = low(place.x());
  const int top = low(place.y());
  for (int y = std::max(top, clip_top_); y < std::min(top + side, clip_bottom_); ++y)
    for (int x = std::max(left, clip_left_); x < std::min(left + side, clip_right_);
         ++x)
      put(x, y, place.z(), colour);
}

void
Canvas::shadeDepth()
{
  constexpr int reach = 3;         // fine pixels
  constexpr double gain = 0.04;    // per pixel of depth
  constexpr double darkest = 0.65; // maximum darkening
  for (int y = 0; y < fine_.height; ++y)
    for (int x = 0; x < fine_.width; ++x) {
      const float depth = depthAt(x, y);
      if (depth == background)
        continue;
      double hidden = 0;
      for (const auto& [u, v] :
           {std::pair{x + reach, y}, {x - reach, y}, {x, y + reach}, {x, y - reach}})
        if (u >= 0 && v >= 0 && u < fine_.width && v < fine_.height)
          hidden += std::max(0.0F, depth - depthAt(u, v));
      fine_.at(x, y) = darkened(fine_.at(x, y), std::min(darkest, gain * hidden / 4));
    }
}

Image
Canvas::image() const
{
  Image result(fine_.width / fineness_, fine_.height / fineness_, colours::paper);
  const int count = fineness_ * fineness_;
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      int sum[3] = {0, 0, 0};
      for (int dy = 0; dy < fineness_; ++dy)
        for (int dx = 0; dx < fineness_; ++dx) {
          const Colour c = fine_.at(fineness_ * x + dx, fineness_ * y + dy);
          sum[0] += c.red;
          sum[1] += c.green;
          sum[2] += c.blue;
        }
      const auto mean = [count](int s) {
        return static_cast<std::uint8_t>((s + count / 2) / count);
      };
      result.at(x, y) = {mean(sum[0]), mean(sum[1]), mean(sum[2])};
    }
  for (const auto& text : texts_)
    drawText(text, result);
  return result;
}

} // namespace pcl::sedr::tools
