// SPDX-License-Identifier: BSD-3-Clause
#include "model_pictures.h"

#include "canvas.h"
#include "results/distance_colour.h"
#include "results/shown_mesh.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::tools {

namespace {

// Direction of the viewer, degrees, and width of pictures, pixels.
constexpr double azimuth = -55;
constexpr double elevation = 48;
constexpr int picture_width = 960;
constexpr int fineness = 2;
constexpr double point_size = 1.5; // pixels

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

ModelPictures::ModelPictures(const std::vector<Eigen::Vector3d>& outline,
                             CeilingRule rule)
    : rule_(std::move(rule))
    , view_(outline, azimuth, elevation, picture_width)
{
  for (const auto& p : outline)
    box_.extend(p);
}

std::string
ModelPictures::scan(const DisplayCloud& cloud) const
{
  constexpr double around = 1; // metres
  const Eigen::AlignedBox3d shown(box_.min().array() - around,
                                  box_.max().array() + around);
  const auto is_ceiling = rule_.ofCloud(cloud);
  Canvas image(picture_width, view_.height(), fineness);
  const double height = std::max(1e-6, box_.sizes().z());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    if (is_ceiling[i] || !shown.contains(p))
      continue;
    const double share = std::clamp((p.z() - box_.min().z()) / height, 0.0, 1.0);
    image.fillSquare(view_.see(p), point_size,
                     mixed(Colour{84, 96, 116}, Colour{216, 214, 206}, share));
  }
  image.shadeDepth();
  return pngOf(image.image());
}

std::string
ModelPictures::model(const TriangleMesh& mesh) const
{
  const auto is_ceiling = rule_.ofMesh(mesh);
  Canvas image(picture_width, view_.height(), fineness);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t).normalized();
    if (is_ceiling[t] || !view_.faces(normal))
      continue;
    const auto label = mesh.labels.empty()
                           ? StructureLabel::Wall
                           : static_cast<StructureLabel>(mesh.labels[t]);
    image.fillTriangle({view_.see(mesh.corner(t, 0)), view_.see(mesh.corner(t, 1)),
                        view_.see(mesh.corner(t, 2))},
                       litColour(colourOf(label), normal));
  }
  image.shadeDepth();
  return pngOf(image.image());
}

std::string
ModelPictures::distances(const DisplayCloud& cloud,
                         const std::vector<double>& distances,
                         double spacing,
                         double range,
                         double farthest) const
{
  Canvas image(picture_width, view_.height(), fineness);
  constexpr double overlap = 1.2;
  constexpr double largest = 12; // pixels
  const double size =
      std::clamp(overlap * spacing * view_.scale(), point_size, largest);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (distances[i] <= farthest)
      image.fillSquare(view_.see(cloud.points[i].cast<double>()), size,
                       distanceColour(distances[i], range));
  image.shadeDepth();
  return pngOf(image.image());
}

} // namespace pcl::sedr::tools
