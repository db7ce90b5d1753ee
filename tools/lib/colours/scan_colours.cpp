// SPDX-License-Identifier: BSD-3-Clause
#include "scan_colours.h"

#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t at_once = std::size_t{1} << 12; // rows
constexpr double scatter = 0.025; // metres, of points about their surface

/** @brief Returns the median of colours, per channel. */
SeenColour
medianOf(std::vector<SeenColour>& colours)
{
  SeenColour median{{}, !colours.empty()};
  const auto middle = colours.begin() + static_cast<std::ptrdiff_t>(colours.size() / 2);
  for (std::size_t k = 0; k < 3 && median.is_seen; ++k) {
    std::nth_element(
        colours.begin(), middle, colours.end(),
        [k](const SeenColour& a, const SeenColour& b) { return a.rgb[k] < b.rgb[k]; });
    median.rgb[k] = middle->rgb[k];
  }
  return median;
}

/** @brief Some of the colours of a group, spread over all of them. */
class ColourSample {
public:
  void add(const std::uint8_t* blue)
  {
    const std::uint64_t mixed = (++count_ * 0x9e3779b97f4a7c15U) >> 33;
    const std::size_t at = count_ <= most ? count_ - 1 : mixed % count_;
    if (at < most)
      kept_[at] = {blue[2], blue[1], blue[0]};
  }

  SeenColour median() const
  {
    std::vector<SeenColour> colours;
    for (std::size_t k = 0; k < std::min<std::size_t>(count_, most); ++k)
      colours.push_back({kept_[k], true});
    return medianOf(colours);
  }

private:
  static constexpr std::size_t most = 15;
  std::uint64_t count_ = 0;
  std::array<std::array<std::uint8_t, 3>, most> kept_{};
};

} // namespace

std::vector<SeenColour>
medianColours(const JointScan& scan,
              const std::function<std::size_t(const Eigen::Vector3f&)>& group_of,
              std::size_t groups,
              unsigned threads)
{
  std::vector<ColourSample> samples(groups);
  std::vector<std::size_t> group;
  for (const auto& file : scan.files()) {
    const auto* const colour = file->colour();
    if (!colour)
      continue;
    RowCoordinates coordinates(file->fields(), file->rowSize());
    file->forEachPiece([&](const RowSource::Piece& piece) {
      const PointView points = coordinates.of(piece.rows, piece.size, threads);
      group.resize(piece.size);
      parallelFor(piece.size, at_once, threads,
                  [&](std::size_t i) { group[i] = group_of(points[i]); });
      for (std::size_t i = 0; i < piece.size; ++i)
        if (group[i] < groups)
          samples[group[i]].add(piece.rows + i * file->rowSize() + colour->offset);
      return true;
    });
  }
  std::vector<SeenColour> medians;
  for (const ColourSample& sample : samples)
    medians.push_back(sample.median());
  return medians;
}

SurfaceColours::SurfaceColours(const pcl::PointCloud<pcl::PointXYZ>& points,
                               const std::vector<Surface>& surfaces,
                               const std::vector<SeenColour>& colours,
                               double voxel_size)
    : near_(voxel_size + scatter)
{
  std::map<Surface, pcl::PointCloud<pcl::PointXYZ>::Ptr> clouds;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (surfaces[i].second != 0 && colours[i].is_seen) {
      auto& cloud = clouds[surfaces[i]];
      if (!cloud)
        cloud.reset(new pcl::PointCloud<pcl::PointXYZ>);
      cloud->push_back(points[i]);
      of_surface_[surfaces[i]].colours.push_back(colours[i]);
    }
  for (const auto& [surface, cloud] : clouds)
    of_surface_[surface].tree.setInputCloud(cloud);
}

SeenColour
SurfaceColours::at(const Eigen::Vector3f& place, const Surface& surface) const
{
  SeenColour colour;
  float least = std::numeric_limits<float>::infinity(); // squared distance
  const auto search = [&](const Painted& painted) {
    pcl::Indices index(1);
    std::vector<float> squared(1);
    painted.tree.nearestKSearch({place.x(), place.y(), place.z()}, 1, index, squared);
    if (squared[0] >= least)
      return;
    least = squared[0];
    colour = painted.colours[static_cast<std::size_t>(index[0])];
  };
  if (const auto known = of_surface_.find(surface); known != of_surface_.end())
    search(known->second);
  else // as in a room that was parted by hand
    for (const bool is_any : {false, true})
      for (const auto& [other, painted] : of_surface_)
        if (other.second == surface.second || (is_any && std::isinf(least)))
          search(painted);
  colour.is_seen = std::sqrt(least) <= near_;
  return colour;
}

std::vector<SeenColour>
SurfaceColours::ofVertices(const TriangleMesh& mesh, unsigned threads) const
{
  std::vector<SeenColour> colours(empty() ? 0 : mesh.vertices.size());
  std::vector<Surface> surfaces(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.labels.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangles[t])
      surfaces[vertex] = {mesh.rooms[t], mesh.labels[t]};
  parallelFor(colours.size(), at_once, threads, [&](std::size_t v) {
    colours[v] = at(mesh.vertices[v].cast<float>(), surfaces[v]);
  });
  return colours;
}

std::vector<SeenColour>
SurfaceColours::ofPoints(const pcl::PointCloud<pcl::PointStructure>& points,
                         unsigned threads) const
{
  std::vector<SeenColour> colours(empty() ? 0 : points.size());
  parallelFor(colours.size(), at_once, threads, [&](std::size_t i) {
    colours[i] = at(points[i].getVector3fMap(), {points[i].room, points[i].label});
  });
  return colours;
}

std::vector<SeenColour>
SurfaceColours::ofElements(const TriangleMesh& mesh,
                           const std::vector<SolidElement>& elements) const
{
  constexpr double step = 0.1; // metres
  constexpr double most = 50;  // steps along a triangle
  if (empty())
    return {};
  std::vector<std::vector<SeenColour>> seen(elements.size());
  std::vector<std::vector<SeenColour>> filled(elements.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.elements[t] == 0)
      continue;
    const std::size_t e = mesh.elements[t] - 1;
    const double size = std::sqrt(mesh.scaledNormal(t).norm());
    const auto n = static_cast<int>(std::clamp(std::ceil(size / step), 1.0, most));
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const double a = (i + 1.0 / 3) / n;
        const double b = (j + 1.0 / 3) / n;
        const Eigen::Vector3d place = a * mesh.corner(t, 0) + b * mesh.corner(t, 1) +
                                      (1 - a - b) * mesh.corner(t, 2);
        const SeenColour colour =
            at(place.cast<float>(), {mesh.rooms[t], mesh.labels[t]});
        (colour.is_seen ? seen : filled)[e].push_back(colour);
      }
  }
  std::vector<SeenColour> colours;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const bool is_seen = seen[e].size() > filled[e].size();
    colours.push_back(medianOf(seen[e].empty() ? filled[e] : seen[e]));
    colours.back().is_seen = is_seen;
  }
  return colours;
}

} // namespace pcl::sedr::tools
