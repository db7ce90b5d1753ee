// SPDX-License-Identifier: BSD-3-Clause
#include "scan.h"

#include "random.h"
#include "ray_caster.h"
#include "scene_surfaces.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace pcl::sedr::sim {

namespace {

/** @brief Computes what a scanner records for a single ray. Threads may share it. */
class Tracer {
public:
  /** @brief Keeps a reference to @p scene, which must outlive the tracer.
   * @throw std::invalid_argument if the scene cannot be built: see surfacesOf()
   */
  explicit Tracer(const Scene& scene);

  /** @brief Returns the record of a ray in the frame of the files; empty without a hit.
   *
   * A window pane returns some of the rays, mirrors some and transmits the others. A
   * mirrored ray is recorded along its original direction, as a real scanner does.
   * @param ray in the scene's own frame, direction of unit length
   */
  std::optional<ScanPoint>
  measure(const Ray& ray, const Scanner& scanner, RayRandom& random) const;

private:
  /** @brief The surface point that ends a ray. */
  struct Echo {
    double range = 0.0; ///< along all legs of the ray
    Label label = Label::Other;
    std::uint32_t room = 0;
  };

  std::optional<Echo>
  findEcho(const Ray& ray, double max_range, RayRandom& random) const;

  static Echo echoOf(const Ray& leg, const Hit& hit);

  const Scene& scene_;
  const RayCaster caster_;
};

constexpr double kStart = 1e-6; ///< metres skipped behind a surface that is passed
constexpr int kMaxPanes = 16;   ///< maximum number of panes along a ray

/** @brief Returns the leg that starts where @p leg meets a flat pane. */
Ray
mirroredAt(const PlanePatch& pane, const Ray& leg, double distance)
{
  const Vec3 normal = lifted(leftOf(pane.direction), 0.0);
  const Vec3 direction = leg.direction - 2.0 * dot(leg.direction, normal) * normal;
  return {leg.at(distance), direction};
}

Tracer::Tracer(const Scene& scene)
    : scene_(scene)
    , caster_(surfacesOf(scene))
{}

std::optional<ScanPoint>
Tracer::measure(const Ray& ray, const Scanner& scanner, RayRandom& random) const
{
  const auto echo = findEcho(ray, scanner.max_range, random);
  if (!echo)
    return std::nullopt;
  const double range = echo->range + scanner.noise * random.gaussian();
  const Vec3 point = placed(scene_.placement, ray.at(range));
  return ScanPoint{static_cast<float>(point.x), static_cast<float>(point.y),
                   static_cast<float>(point.z), static_cast<std::uint32_t>(echo->label),
                   echo->room};
}

std::optional<Tracer::Echo>
Tracer::findEcho(const Ray& ray, double max_range, RayRandom& random) const
{
  Ray leg = ray;        // changes where a pane mirrors
  double walked = 0.0;  // length of the previous legs
  double from = kStart; // start of the search on the leg
  for (int pane = 0; pane < kMaxPanes; ++pane) {
    const auto hit = caster_.nearest(leg, from, max_range - walked);
    if (!hit)
      return std::nullopt;
    const auto& glazing = hit->surface->glazing;
    const double fate = glazing ? random.uniform() : 0.0;
    if (!glazing || fate < glazing->return_share) {
      const Echo echo = echoOf(leg, *hit);
      return walked > 0.0 ? Echo{walked + echo.range} : echo;
    }
    from = hit->distance + kStart;
    // Curved panes do not mirror: their images would not resemble a room.
    const auto* flat = std::get_if<PlanePatch>(&hit->surface->shape);
    if (flat != nullptr && fate < glazing->return_share + glazing->mirror_share) {
      leg = mirroredAt(*flat, leg, hit->distance);
      walked += hit->distance;
      from = kStart;
    }
  }
  return std::nullopt;
}

Tracer::Echo
Tracer::echoOf(const Ray& leg, const Hit& hit)
{
  const Surface& surface = *hit.surface;
  // The back of a surface is the outside of the building.
  if (surface.front != Side::None &&
      sideSeenFrom(surface.shape, leg, hit.distance) != surface.front)
    return {hit.distance};
  return {hit.distance, surface.label, surface.room};
}

constexpr std::size_t kBlockSteps = 16; ///< azimuth steps in a block of work
constexpr unsigned kMaxThreads = 256;
constexpr std::uint64_t kTurn = ~0ULL; ///< ray number of a station's rotation

/** @brief A scanner's angular raster, from its lowest elevation to the zenith. */
struct Raster {
  std::size_t azimuths = 1;
  std::size_t elevations = 1;
  double low = 0.0;  ///< radians
  double step = 0.0; ///< radians of elevation
};

/** @brief Returns a raster of about the requested rays; equal steps in both angles. */
Raster
rasterOf(const Scanner& scanner)
{
  Raster raster;
  raster.low = scanner.min_elevation * pi / 180.0;
  const double span = 0.5 * pi - raster.low;
  const auto rays = static_cast<double>(scanner.rays_per_station);
  const double around = std::round(std::sqrt(rays * 2.0 * pi / span));
  raster.azimuths = std::max<std::size_t>(1, static_cast<std::size_t>(around));
  raster.elevations =
      std::max<std::size_t>(1, scanner.rays_per_station / raster.azimuths);
  raster.step = span / static_cast<double>(raster.elevations);
  return raster;
}

/** @brief A block of work for a thread: some azimuth steps of one station. */
struct Block {
  const Scanner* scanner = nullptr;
  Raster raster;
  Vec3 station;
  std::size_t station_number = 0;
  std::size_t first = 0; ///< azimuth step
  std::size_t last = 0;  ///< azimuth step, exclusive
};

std::vector<Block>
blocksOf(const Scene& scene)
{
  std::vector<Block> blocks;
  std::size_t number = 0;
  for (const Scanner& scanner : scene.scanners) {
    const Raster raster = rasterOf(scanner);
    for (const Vec3& station : scanner.stations) {
      for (std::size_t first = 0; first < raster.azimuths; first += kBlockSteps) {
        const std::size_t last = std::min(first + kBlockSteps, raster.azimuths);
        blocks.push_back({&scanner, raster, station, number, first, last});
      }
      ++number;
    }
  }
  return blocks;
}

/** @brief Returns a jittered direction in a raster cell; @p turn shifts the azimuth. */
Vec3
direction(const Block& block,
          std::size_t i,
          std::size_t j,
          double turn,
          RayRandom& random)
{
  const double jitter = block.scanner->jitter;
  const double across =
      static_cast<double>(i) + turn + jitter * (random.uniform() - 0.5);
  const double up = static_cast<double>(j) + 0.5 + jitter * (random.uniform() - 0.5);
  const double azimuth = 2.0 * pi * across / static_cast<double>(block.raster.azimuths);
  const double elevation = block.raster.low + block.raster.step * up;
  const Vec2 level = std::cos(elevation) * Vec2{std::cos(azimuth), std::sin(azimuth)};
  return lifted(level, std::sin(elevation));
}

std::vector<ScanPoint>
scanBlock(const Tracer& tracer, const Block& block, std::uint64_t seed)
{
  std::vector<ScanPoint> points;
  const double turn = RayRandom(seed, block.station_number, kTurn).uniform();
  const std::size_t elevations = block.raster.elevations;
  for (std::size_t i = block.first; i < block.last; ++i)
    for (std::size_t j = 0; j < elevations; ++j) {
      RayRandom random(seed, block.station_number, i * elevations + j);
      const Ray ray{block.station, direction(block, i, j, turn, random)};
      if (const auto point = tracer.measure(ray, *block.scanner, random))
        points.push_back(*point);
    }
  return points;
}

/** @brief Calls @p work(i) for all i below @p count, on several threads. */
template <typename Work>
void
parallelFor(std::size_t count, unsigned threads, const Work& work)
{
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++)
      work(i);
  };
  std::vector<std::thread> helpers;
  for (unsigned i = 1; i < std::min(threads, kMaxThreads) && i < count; ++i)
    helpers.emplace_back(run);
  run();
  for (std::thread& helper : helpers)
    helper.join();
}

/** @brief Scans all blocks; the results are in the order of the blocks. */
std::vector<std::vector<ScanPoint>>
scanBlocks(const Tracer& tracer,
           const std::vector<Block>& blocks,
           const ScanOptions& options)
{
  std::vector<std::vector<ScanPoint>> results(blocks.size());
  std::mutex mutex;
  std::size_t done = 0;
  const unsigned available = std::max(1U, std::thread::hardware_concurrency());
  const unsigned threads = options.threads > 0 ? options.threads : available;
  parallelFor(blocks.size(), threads, [&](std::size_t i) {
    results[i] = scanBlock(tracer, blocks[i], options.seed);
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (options.progress)
      options.progress(static_cast<double>(done) / static_cast<double>(blocks.size()));
  });
  return results;
}

Scene
adjusted(Scene scene, const ScanOptions& options)
{
  for (Scanner& scanner : scene.scanners) {
    scanner.noise = options.noise.value_or(scanner.noise);
    scanner.max_range = options.max_range.value_or(scanner.max_range);
    scanner.rays_per_station =
        options.rays_per_station.value_or(scanner.rays_per_station);
  }
  return scene;
}

} // namespace

Scan
scan(const Scene& scene, const ScanOptions& options)
{
  const Scene adapted = adjusted(scene, options);
  const std::vector<Block> blocks = blocksOf(adapted);
  const auto results = scanBlocks(Tracer(adapted), blocks, options);
  Scan scan;
  std::size_t count = 0;
  for (const auto& points : results)
    count += points.size();
  scan.points.reserve(count);
  for (const auto& points : results)
    scan.points.insert(scan.points.end(), points.begin(), points.end());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    scan.rays += (block.last - block.first) * block.raster.elevations;
    if (block.first == 0) // first block of a position
      scan.positions.push_back({placed(scene.placement, block.station), 0});
    scan.positions.back().points += results[i].size();
  }
  return scan;
}

} // namespace pcl::sedr::sim
