// SPDX-License-Identifier: BSD-3-Clause
#include "model_pictures.h"

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
constexpr int point_size = 3; // fine pixels

} // namespace

ModelPictures::ModelPictures(const std::vector<Eigen::Vector3d>& outline,
                             CeilingRule rule)
    : rule_(std::move(rule))
    , view_(outline, azimuth, elevation, DepthImage::fineness * picture_width)
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
  DepthImage image(picture_width, view_.height() / DepthImage::fineness);
  const double height = std::max(1e-6, box_.sizes().z());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    if (is_ceiling[i] || !shown.contains(p))
      continue;
    const double share = std::clamp((p.z() - box_.min().z()) / height, 0.0, 1.0);
    image.addPoint(view_.see(p),
                   mixed(Colour{84, 96, 116}, Colour{216, 214, 206}, share),
                   point_size);
  }
  image.shadeDepth();
  return pngOf(image.image());
}

std::string
ModelPictures::model(const TriangleMesh& mesh) const
{
  const auto is_ceiling = rule_.ofMesh(mesh);
  DepthImage image(picture_width, view_.height() / DepthImage::fineness);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t).normalized();
    if (is_ceiling[t] || !view_.faces(normal))
      continue;
    const auto label = mesh.labels.empty()
                           ? StructureLabel::Wall
                           : static_cast<StructureLabel>(mesh.labels[t]);
    image.addTriangle({view_.see(mesh.corner(t, 0)), view_.see(mesh.corner(t, 1)),
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
  DepthImage image(picture_width, view_.height() / DepthImage::fineness);
  constexpr double overlap = 1.2;
  constexpr double largest = 24; // fine pixels
  const int size = static_cast<int>(std::lround(
      std::clamp(overlap * spacing * view_.scale(), double{point_size}, largest)));
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (distances[i] <= farthest)
      image.addPoint(view_.see(cloud.points[i].cast<double>()),
                     distanceColour(distances[i], range), size);
  image.shadeDepth();
  return pngOf(image.image());
}

} // namespace pcl::sedr::tools
