// SPDX-License-Identifier: BSD-3-Clause
#include "building.h"

#include "simulator/scan/random.h"
#include "simulator/truth/files.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pcl::sedr::sim {

namespace {

constexpr double kWall = 0.3; ///< metres between two copies

/** @brief A point without noise, and the direction of its noise. */
struct Hit {
  Vec3 place;
  Vec3 ray; ///< unit length
  double noise = 0.0;
  std::uint32_t label = 0;
};

/** @brief Returns the points on the rooms that all stations of a scene see. */
std::vector<Hit>
hitsOf(Scene scene, const ScanOptions& options)
{
  scene.outside.clear();
  scene.placement = {};
  const std::vector<Scanner> scanners = scene.scanners;
  std::vector<Hit> hits;
  ScanOptions exact = options;
  exact.progress = nullptr;
  exact.noise = 0.0;
  for (const Scanner& scanner : scanners)
    for (const Vec3& station : scanner.stations) {
      scene.scanners = {scanner};
      scene.scanners.front().stations = {station};
      ++exact.seed;
      for (const ScanPoint& point : scan(scene, exact).points) {
        const Vec3 place{point.x, point.y, point.z};
        const Vec3 way = place - station;
        hits.push_back({place, (1.0 / length(way)) * way,
                        options.noise.value_or(scanner.noise), point.label});
      }
    }
  return hits;
}

/** @brief Returns the distances between neighbouring copies along x and y. */
Vec2
pitchOf(const Scene& scene)
{
  Vec2 low{1e9, 1e9};
  Vec2 high{-1e9, -1e9};
  for (const Room& room : scene.rooms) {
    const Rectangle bounds = boundsOf(room.outline);
    low = {std::min(low.x, bounds.min.x), std::min(low.y, bounds.min.y)};
    high = {std::max(high.x, bounds.max.x), std::max(high.y, bounds.max.y)};
  }
  return high - low + Vec2{kWall, kWall};
}

} // namespace

BuildingScan
writeBuilding(const std::filesystem::path& path,
              const Scene& scene,
              std::size_t points,
              const ScanOptions& options)
{
  const std::vector<Hit> hits = hitsOf(scene, options);
  if (hits.empty())
    throw std::invalid_argument("no ray of scene " + scene.name + " hits a room");
  BuildingScan building;
  building.copies = std::max<std::size_t>(1, (points + hits.size() / 2) / hits.size());
  building.points = building.copies * hits.size();
  const Vec2 pitch = pitchOf(scene);
  const double side =
      std::sqrt(static_cast<double>(building.copies) * pitch.y / pitch.x);
  const auto in_row = static_cast<std::size_t>(std::max(1.0, std::round(side)));

  writePcdStream(path, building.points, [&](const PointSink& write) {
    for (std::size_t copy = 0; copy < building.copies; ++copy) {
      const Vec3 shift{static_cast<double>(copy % in_row) * pitch.x,
                       static_cast<double>(copy / in_row) * pitch.y, 0.0};
      for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit& hit = hits[i];
        const double noise =
            hit.noise * RayRandom(options.seed, ~std::uint64_t{copy}, i).gaussian();
        const Vec3 p = hit.place + shift + noise * hit.ray;
        write({static_cast<float>(p.x), static_cast<float>(p.y),
               static_cast<float>(p.z), hit.label});
      }
      if (options.progress)
        options.progress(static_cast<double>(copy + 1) /
                         static_cast<double>(building.copies));
    }
  });
  return building;
}

} // namespace pcl::sedr::sim
