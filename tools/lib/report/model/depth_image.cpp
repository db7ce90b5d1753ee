// SPDX-License-Identifier: BSD-3-Clause
#include "depth_image.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr float nothing = std::numeric_limits<float>::infinity();

} // namespace

ParallelView::ParallelView(const std::vector<Eigen::Vector3d>& model,
                           double azimuth,
                           double elevation,
                           int width)
{
  const double a = azimuth * M_PI / 180;
  const double e = elevation * M_PI / 180;
  towards_ = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  right_ = {-std::sin(a), std::cos(a), 0};
  up_ = towards_.cross(right_);
  Eigen::AlignedBox2d seen;
  for (const auto& p : model)
    seen.extend(Eigen::Vector2d(p.dot(right_), p.dot(up_)));
  constexpr double margin = 0.02; // relative to the width
  const Eigen::Vector2d size = seen.sizes().cwiseMax(1e-6);
  constexpr double highest = 1.1; // relative to the width
  scale_ =
      std::min((1 - 2 * margin) / size.x(), (highest - 2 * margin) / size.y()) * width;
  height_ = static_cast<int>(std::lround(scale_ * size.y() + 2 * margin * width));
  corner_ = seen.center() + Eigen::Vector2d(-width, height_) / (2 * scale_);
}

Eigen::Vector3d
ParallelView::see(const Eigen::Vector3d& p) const
{
  return {scale_ * (p.dot(right_) - corner_.x()), scale_ * (corner_.y() - p.dot(up_)),
          -scale_ * p.dot(towards_)};
}

DepthImage::DepthImage(int width, int height)
    : fine_(fineness * width, fineness * height, colours::paper)
    , depths_(fine_.pixels.size(), nothing)
{}

void
DepthImage::put(int x, int y, double depth, Colour colour)
{
  if (x < 0 || y < 0 || x >= fine_.width || y >= fine_.height)
    return;
  float& known = depths_[indexOf(x, y)];
  if (!(depth < known))
    return;
  known = static_cast<float>(depth);
  fine_.at(x, y) = colour;
}

void
DepthImage::addPoint(const Eigen::Vector3d& place, Colour colour, int size)
{
  const int left = static_cast<int>(std::floor(place.x() - size / 2.0 + 0.5));
  const int top = static_cast<int>(std::floor(place.y() - size / 2.0 + 0.5));
  for (int y = top; y < top + size; ++y)
    for (int x = left; x < left + size; ++x)
      put(x, y, place.z(), colour);
}

void
DepthImage::addTriangle(const std::array<Eigen::Vector3d, 3>& c, Colour colour)
{
  const Eigen::Vector2d a = c[0].head<2>();
  const Eigen::Vector2d u = c[1].head<2>() - a;
  const Eigen::Vector2d v = c[2].head<2>() - a;
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  if (!(std::abs(twice_area) > 1e-12))
    return;
  const auto clamped = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  const auto [left, right] = std::minmax({c[0].x(), c[1].x(), c[2].x()});
  const auto [top, bottom] = std::minmax({c[0].y(), c[1].y(), c[2].y()});
  const int x1 = clamped(std::ceil(right), fine_.width - 1);
  const int y1 = clamped(std::ceil(bottom), fine_.height - 1);
  for (int y = clamped(std::floor(top), fine_.height - 1); y <= y1; ++y)
    for (int x = clamped(std::floor(left), fine_.width - 1); x <= x1; ++x) {
      const Eigen::Vector2d p = Eigen::Vector2d(x + 0.5, y + 0.5) - a;
      const double s = (p.x() * v.y() - p.y() * v.x()) / twice_area;
      const double t = (u.x() * p.y() - u.y() * p.x()) / twice_area;
      if (s >= 0 && t >= 0 && s + t <= 1)
        put(x, y, (1 - s - t) * c[0].z() + s * c[1].z() + t * c[2].z(), colour);
    }
}

void
DepthImage::shadeDepth()
{
  constexpr int reach = 3;         // fine pixels
  constexpr double gain = 0.02;    // per pixel of depth
  constexpr double darkest = 0.65; // maximum darkening
  const auto depthAt = [&](int x, int y) {
    return x < 0 || y < 0 || x >= fine_.width || y >= fine_.height
               ? nothing
               : depths_[indexOf(x, y)];
  };
  for (int y = 0; y < fine_.height; ++y)
    for (int x = 0; x < fine_.width; ++x) {
      const float depth = depthAt(x, y);
      if (depth == nothing)
        continue;
      double hidden = 0;
      for (const auto& [dx, dy] :
           {std::pair{reach, 0}, {-reach, 0}, {0, reach}, {0, -reach}})
        hidden += std::max(0.0F, depth - depthAt(x + dx, y + dy));
      fine_.at(x, y) = darkened(fine_.at(x, y), std::min(darkest, gain * hidden / 4));
    }
}

Image
DepthImage::image() const
{
  Image image(fine_.width / fineness, fine_.height / fineness, colours::paper);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      int red = 0;
      int green = 0;
      int blue = 0;
      for (int k = 0; k < fineness * fineness; ++k) {
        const Colour c =
            fine_.at(fineness * x + k % fineness, fineness * y + k / fineness);
        red += c.red;
        green += c.green;
        blue += c.blue;
      }
      constexpr int count = fineness * fineness;
      image.at(x, y) = {static_cast<std::uint8_t>(red / count),
                        static_cast<std::uint8_t>(green / count),
                        static_cast<std::uint8_t>(blue / count)};
    }
  return image;
}

} // namespace pcl::sedr::tools
