// SPDX-License-Identifier: BSD-3-Clause
#include "scan_colours.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/voxels/voxel_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t at_once = std::size_t{1} << 12; // rows
constexpr double reach = 0.03; // metres, of the points that give a place its colour

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

/** @brief Finds the places within reach of a point. */
class NearPlaces {
public:
  explicit NearPlaces(const pcl::PointCloud<pcl::PointXYZ>& places)
      : places_(places)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
      cells_[cellOf(places[i].getVector3fMap())].push_back(
          static_cast<std::uint32_t>(i));
  }

  /** @brief Calls `see(i)` for each place, of at most eight cells. */
  template <typename See>
  void forEach(const Eigen::Vector3f& p, const See& see) const
  {
    constexpr float far = 1e7F; // metres, beyond cells
    if (!(p.cwiseAbs().maxCoeff() < far))
      return;
    const Eigen::Vector3f off = Eigen::Vector3f::Constant(reach);
    const VoxelCode low = cellOf(p - off);
    const VoxelCode high = cellOf(p + off);
    VoxelCode at{};
    for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
        for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
          if (const auto cell = cells_.find(at); cell != cells_.end())
            for (const std::uint32_t i : cell->second)
              if ((places_[i].getVector3fMap() - p).norm() <= reach)
                see(i);
  }

private:
  struct Hash {
    std::size_t operator()(const VoxelCode& code) const { return hashOf(code); }
  };

  static VoxelCode cellOf(const Eigen::Vector3f& p)
  {
    VoxelCode cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int32_t>(
          std::floor(p[static_cast<Eigen::Index>(axis)] / (2 * reach)));
    return cell;
  }

  const pcl::PointCloud<pcl::PointXYZ>& places_;
  std::unordered_map<VoxelCode, std::vector<std::uint32_t>, Hash> cells_;
};

/** @brief Calls `see(place, t)` for places on the elements of a solid, at most 10 cm
 * apart, or a fiftieth of a large triangle. */
template <typename See>
void
forEachSample(const TriangleMesh& solid, const See& see)
{
  constexpr double step = 0.1; // metres
  constexpr double most = 50;  // steps along a triangle
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    if (solid.elements[t] == 0)
      continue;
    const double size = std::sqrt(solid.scaledNormal(t).norm());
    const auto n = static_cast<int>(std::clamp(std::ceil(size / step), 1.0, most));
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const double a = (i + 1.0 / 3) / n;
        const double b = (j + 1.0 / 3) / n;
        const Eigen::Vector3d place = a * solid.corner(t, 0) + b * solid.corner(t, 1) +
                                      (1 - a - b) * solid.corner(t, 2);
        see(place.cast<float>(), t);
      }
  }
}

SurfacePlaces
samplesOf(const TriangleMesh& solid)
{
  SurfacePlaces places;
  forEachSample(solid, [&](const Eigen::Vector3f& place, std::size_t t) {
    places.add(place, {solid.rooms[t], solid.labels[t]});
  });
  return places;
}

} // namespace

void
SurfacePlaces::add(const Eigen::Vector3f& place, const Surface& surface)
{
  points.emplace_back(place.x(), place.y(), place.z());
  surfaces.push_back(surface);
}

void
SurfacePlaces::add(const SurfacePlaces& others)
{
  points += others.points;
  surfaces.insert(surfaces.end(), others.surfaces.begin(), others.surfaces.end());
}

SurfacePlaces
placesOf(const pcl::PointCloud<pcl::PointStructure>& points)
{
  SurfacePlaces places;
  for (const auto& point : points)
    places.add(point.getVector3fMap(), {point.room, point.label});
  return places;
}

SurfacePlaces
verticesOf(const TriangleMesh& mesh)
{
  std::vector<Surface> surfaces(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.labels.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangles[t])
      surfaces[vertex] = {mesh.rooms[t], mesh.labels[t]};
  SurfacePlaces places;
  for (std::size_t v = 0; v < surfaces.size(); ++v)
    places.add(mesh.vertices[v].cast<float>(), surfaces[v]);
  return places;
}

std::vector<SeenColour>
medianColours(const JointScan& scan,
              const SurfacePlaces& places,
              const BuildingFrame& frame,
              unsigned threads)
{
  const NearPlaces near(places.points);
  std::vector<ColourSample> samples(places.points.size());
  std::vector<std::vector<std::pair<std::uint32_t, std::size_t>>> found; // and rows
  for (const auto& file : scan.files()) {
    const auto* const colour = file->colour();
    if (!colour)
      continue;
    RowCoordinates coordinates(file->fields(), file->rowSize());
    file->forEachPiece([&](const RowSource::Piece& piece) {
      const PointView points = coordinates.of(piece.rows, piece.size, threads);
      found.assign(piece.size / at_once + 1, {});
      parallelFor(piece.size, at_once, threads, [&](std::size_t i) {
        const Eigen::Vector3d p = frame.toBuilding(points[i].cast<double>());
        near.forEach(p.cast<float>(), [&](std::uint32_t place) {
          found[i / at_once].emplace_back(place, i);
        });
      });
      for (const auto& block : found)
        for (const auto& [place, i] : block)
          samples[place].add(piece.rows + i * file->rowSize() + colour->offset);
      return true;
    });
  }
  std::vector<SeenColour> medians;
  for (const ColourSample& sample : samples)
    medians.push_back(sample.median());
  return medians;
}

SurfaceColours::SurfaceColours(const SurfacePlaces& places,
                               const std::vector<SeenColour>& colours,
                               double near)
    : near_(near)
{
  std::map<Surface, pcl::PointCloud<pcl::PointXYZ>::Ptr> clouds;
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (const Surface& surface = places.surfaces[i];
        surface.second != 0 && colours[i].is_seen) {
      auto& cloud = clouds[surface];
      if (!cloud)
        cloud.reset(new pcl::PointCloud<pcl::PointXYZ>);
      cloud->push_back(places.points[i]);
      of_surface_[surface].colours.push_back(colours[i]);
    }
  for (const auto& [surface, cloud] : clouds)
    of_surface_[surface].tree.setInputCloud(cloud);
}

SeenColour
SurfaceColours::at(const pcl::PointXYZ& place, const Surface& surface) const
{
  SeenColour colour;
  float least = std::numeric_limits<float>::infinity(); // squared distance
  const auto search = [&](const Painted& painted) {
    pcl::Indices index(1);
    std::vector<float> squared(1);
    painted.tree.nearestKSearch(place, 1, index, squared);
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
SurfaceColours::of(const SurfacePlaces& places, unsigned threads) const
{
  std::vector<SeenColour> colours(empty() ? 0 : places.points.size());
  parallelFor(colours.size(), at_once, threads, [&](std::size_t i) {
    colours[i] = at(places.points[i], places.surfaces[i]);
  });
  return colours;
}

std::vector<SeenColour>
SurfaceColours::ofElements(const TriangleMesh& mesh,
                           std::size_t elements,
                           unsigned threads) const
{
  if (empty())
    return {};
  const std::vector<SeenColour> of_samples = of(samplesOf(mesh), threads);
  std::vector<std::vector<SeenColour>> seen(elements);
  std::vector<std::vector<SeenColour>> filled(elements);
  auto sample = of_samples.begin();
  forEachSample(mesh, [&](const Eigen::Vector3f&, std::size_t t) {
    (sample->is_seen ? seen : filled)[mesh.elements[t] - 1].push_back(*sample);
    ++sample;
  });
  std::vector<SeenColour> colours;
  for (std::size_t e = 0; e < elements; ++e) {
    const bool is_seen = seen[e].size() > filled[e].size();
    colours.push_back(medianOf(seen[e].empty() ? filled[e] : seen[e]));
    colours.back().is_seen = is_seen;
  }
  return colours;
}

SurfaceColours
coloursOf(const JointScan& scan,
          const StructureModel& model,
          const TriangleMesh& mesh,
          const TriangleMesh& solid,
          unsigned threads)
{
  SurfacePlaces places = placesOf(*model.structure);
  places.add(verticesOf(mesh));
  places.add(samplesOf(solid));
  // A place is its own nearest one: what is not seen there is filled in.
  return {places, medianColours(scan, places, model.levelFrame(), threads), 0};
}

} // namespace pcl::sedr::tools
