// SPDX-License-Identifier: BSD-3-Clause
#include "scan.h"

#include "sedr_filters/src/base/parallel.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pcl::sedr::sim {

namespace {

constexpr double kStart = 1e-4; ///< metres skipped behind a pane that is passed
constexpr int kMaxPanes = 16;   ///< maximum number of panes along a ray

/** @brief Difference of both distances, metres, beyond which a ray grazes its triangle
 * so much that its plane says nothing. */
constexpr double kGrazing = 1e-3;

/** @brief A half line; @p direction has unit length. */
struct Ray {
  Vec3 origin;
  Vec3 direction;

  /** @brief Returns the point at distance @p t. */
  Vec3 at(double t) const { return origin + t * direction; }
};

/** @brief The nearest triangle along a ray. */
struct Hit {
  double distance = 0.0;
  std::size_t triangle = 0; ///< of the scene's mesh
};

/** @brief Casts rays at a scene's mesh with Embree; gaps let them pass.
 *
 * Embree finds the triangle in single precision. The distance is computed in double
 * precision from the triangle's plane. Threads may share a caster; the same ray gives
 * the same hit in every run. */
class RayCaster {
public:
  /** @throw std::runtime_error if Embree fails */
  explicit RayCaster(const SceneMesh& scene)
      : scene_(scene)
  {
    // One thread builds a tree that is the same in every run; the scene keeps the
    // device.
    const std::shared_ptr<RTCDeviceTy> device(rtcNewDevice("threads=1"),
                                              rtcReleaseDevice);
    if (!device)
      throw std::runtime_error("Embree cannot be started");
    embree_.reset(rtcNewScene(device.get()), rtcReleaseScene);
    rtcSetSceneFlags(embree_.get(),
                     RTC_SCENE_FLAG_ROBUST); // no ray passes between faces
    const TriangleMesh& mesh = scene.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (scene.surfaces[t] != Surface::Gap)
        triangles_.push_back(t);
    origin_ = triangles_.empty() ? Vec3(Vec3::Zero()) : mesh.bounds().center();
    const RTCGeometry geometry =
        rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
      return rtcSetNewGeometryBuffer(geometry, type, 0, format, 12, count);
    };
    if (!triangles_.empty()) {
      auto* place = static_cast<float*>(
          buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size()));
      for (const Vec3& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
          *place++ = static_cast<float>(vertex[axis] - origin_[axis]);
      auto* corner = static_cast<std::uint32_t*>(
          buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles_.size()));
      for (const std::size_t t : triangles_)
        for (const std::uint32_t vertex : mesh.triangles[t])
          *corner++ = vertex;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree_.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
      throw std::runtime_error("Embree cannot hold the scene");
  }

  /** @brief Returns the first hit beyond @p from and at most @p to metres away. */
  std::optional<Hit> nearest(const Ray& ray, double from, double to) const
  {
    const Vec3 start = ray.origin - origin_;
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(start.x());
    query.ray.org_y = static_cast<float>(start.y());
    query.ray.org_z = static_cast<float>(start.z());
    query.ray.dir_x = static_cast<float>(ray.direction.x());
    query.ray.dir_y = static_cast<float>(ray.direction.y());
    query.ray.dir_z = static_cast<float>(ray.direction.z());
    query.ray.tnear = static_cast<float>(from);
    query.ray.tfar = static_cast<float>(to);
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
      return std::nullopt;
    Hit hit{static_cast<double>(query.ray.tfar), triangles_[query.hit.primID]};
    const Vec3 normal = normalOf(hit.triangle);
    const double exact = normal.dot(scene_.mesh.corner(hit.triangle, 0) - ray.origin) /
                         normal.dot(ray.direction);
    if (std::abs(exact - hit.distance) < kGrazing)
      hit.distance = exact;
    return hit;
  }

  /** @brief Returns the unit normal of a triangle. */
  Vec3 normalOf(std::size_t triangle) const
  {
    return scene_.mesh.scaledNormal(triangle).normalized();
  }

private:
  const SceneMesh& scene_;
  Vec3 origin_; ///< of Embree's coordinates, which have single precision
  std::vector<std::size_t> triangles_; ///< of the scene, as Embree numbers them
  std::shared_ptr<RTCSceneTy> embree_;
};

/** @brief Scrambles 64 bits (the finalizer of splitmix64). */
std::uint64_t
scrambled(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/** @brief Random numbers of one ray, a function of seed, station and ray number only.
 *
 * A scan is therefore the same whichever thread casts a ray. */
class RayRandom {
public:
  RayRandom(std::uint64_t seed, std::uint64_t station, std::uint64_t ray)
      : state_(scrambled(scrambled(scrambled(seed) ^ station) ^ ray))
  {}

  /** @brief Uniform in [0, 1). */
  double uniform()
  {
    state_ = scrambled(state_);
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;
  }

  /** @brief Normal with mean 0 and standard deviation 1. */
  double gaussian()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

private:
  std::uint64_t state_;
};

/** @brief The surface point that ends a ray. */
struct Echo {
  double range = 0.0; ///< along all legs of the ray
  Label label = Label::Other;
  std::uint32_t room = 0;
};

/** @brief Computes where rays end. Threads may share it. */
class Tracer {
public:
  explicit Tracer(const SceneMesh& scene)
      : scene_(scene)
      , caster_(scene)
  {}

  /** @brief Returns where a ray in the scene's own frame ends, if it does. */
  std::optional<Echo>
  findEcho(const Ray& ray, double max_range, RayRandom& random) const
  {
    Ray leg = ray;       // changes where a pane mirrors
    double walked = 0.0; // length of the previous legs
    double from = 0.0;   // start of the search on the leg
    for (int pane = 0; pane < kMaxPanes; ++pane) {
      const auto hit = caster_.nearest(leg, from, max_range - walked);
      if (!hit)
        return std::nullopt;
      const Pane* glass = paneOf(hit->triangle);
      const double fate = glass != nullptr ? random.uniform() : 0.0;
      if (glass == nullptr || fate < glass->glazing.return_share) {
        const Echo echo = echoOf(leg, *hit);
        return walked > 0.0 ? Echo{walked + echo.range} : echo;
      }
      from = hit->distance + kStart;
      // Curved panes do not mirror: their images would not resemble a room.
      if (glass->is_flat &&
          fate < glass->glazing.return_share + glass->glazing.mirror_share) {
        const Vec3 normal = caster_.normalOf(hit->triangle);
        leg = {leg.at(hit->distance),
               leg.direction - 2.0 * leg.direction.dot(normal) * normal};
        walked += hit->distance;
        from = kStart;
      }
    }
    return std::nullopt;
  }

private:
  const Pane* paneOf(std::size_t triangle) const
  {
    return scene_.surfaces[triangle] == Surface::Pane
               ? &scene_.panes[scene_.mesh.elements[triangle] - 1]
               : nullptr;
  }

  Echo echoOf(const Ray& leg, const Hit& hit) const
  {
    // Structure seen from behind is the outside of the building.
    if (scene_.surfaces[hit.triangle] == Surface::Structure &&
        caster_.normalOf(hit.triangle).dot(leg.direction) < 0.0)
      return {hit.distance};
    return {hit.distance, static_cast<Label>(scene_.mesh.labels[hit.triangle]),
            scene_.mesh.rooms[hit.triangle]};
  }

  const SceneMesh& scene_;
  const RayCaster caster_;
};

constexpr std::size_t kBlockSteps = 16; ///< azimuth steps in a block of work
constexpr std::uint64_t kTurn = ~0ULL;  ///< ray number of a station's rotation

/** @brief A station with the angular raster of its scanner, about the requested rays at
 * equal steps in both angles, from the lowest elevation to the zenith. */
struct Station {
  static constexpr double lowest = -65; ///< degrees; the highest is the zenith

  Station(const Scanner& of, const Vec3& at, std::size_t n)
      : scanner(of)
      , place(at)
      , number(n)
      , low(lowest * pi / 180.0)
  {
    const double span = 0.5 * pi - low;
    const auto rays = static_cast<double>(of.rays_per_station);
    const double around = std::max(1.0, std::round(std::sqrt(rays * 2.0 * pi / span)));
    azimuths = static_cast<std::size_t>(around);
    elevations = std::max<std::size_t>(1, of.rays_per_station / azimuths);
    step = span / static_cast<double>(elevations);
  }

  /** @brief Returns a jittered direction in a raster cell; @p turn shifts the
   * azimuth. */
  Vec3 direction(std::size_t i, std::size_t j, double turn, RayRandom& random) const
  {
    const double jitter = scanner.jitter;
    const double across =
        static_cast<double>(i) + turn + jitter * (random.uniform() - 0.5);
    const double up = static_cast<double>(j) + 0.5 + jitter * (random.uniform() - 0.5);
    const double azimuth = 2.0 * pi * across / static_cast<double>(azimuths);
    const double elevation = low + step * up;
    const Vec2 level(std::cos(azimuth), std::sin(azimuth));
    return lifted(std::cos(elevation) * level, std::sin(elevation));
  }

  const Scanner& scanner;
  const Vec3 place;
  const std::size_t number; ///< in the scene
  double low;               ///< elevation, radians
  double step;              ///< of elevation, radians
  std::size_t azimuths;
  std::size_t elevations;
};

/** @brief Casts the rays of some azimuth steps of a station. */
std::vector<ScanPoint>
scanBlock(const Tracer& tracer,
          const Placement& placement,
          const Station& station,
          std::size_t first,
          std::uint64_t seed)
{
  std::vector<ScanPoint> points;
  const double turn = RayRandom(seed, station.number, kTurn).uniform();
  const std::size_t last = std::min(first + kBlockSteps, station.azimuths);
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t j = 0; j < station.elevations; ++j) {
      RayRandom random(seed, station.number, i * station.elevations + j);
      const Ray ray{station.place, station.direction(i, j, turn, random)};
      const auto echo = tracer.findEcho(ray, station.scanner.max_range, random);
      if (!echo)
        continue;
      const double range = echo->range + station.scanner.noise * random.gaussian();
      const Vec3 point = placed(placement, ray.at(range));
      points.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()),
                        static_cast<float>(point.z()),
                        static_cast<std::uint32_t>(echo->label), echo->room});
    }
  return points;
}

std::vector<Scanner>
adjusted(std::vector<Scanner> scanners, const ScanOptions& options)
{
  for (Scanner& scanner : scanners) {
    scanner.noise = options.noise.value_or(scanner.noise);
    scanner.max_range = options.max_range.value_or(scanner.max_range);
    scanner.rays_per_station =
        options.rays_per_station.value_or(scanner.rays_per_station);
  }
  return scanners;
}

} // namespace

Scan
scan(const Scene& scene, const ScanOptions& options)
{
  return scan(scene, meshOf(scene), options);
}

Scan
scan(const Scene& scene, const SceneMesh& mesh, const ScanOptions& options)
{
  const std::vector<Scanner> scanners = adjusted(scene.scanners, options);
  std::vector<Station> stations;
  std::vector<std::pair<std::size_t, std::size_t>> blocks; // station, first azimuth
  for (const Scanner& scanner : scanners)
    for (const Vec3& place : scanner.stations) {
      stations.emplace_back(scanner, place, stations.size());
      for (std::size_t i = 0; i < stations.back().azimuths; i += kBlockSteps)
        blocks.emplace_back(stations.size() - 1, i);
    }
  const Tracer tracer(mesh);
  std::vector<std::vector<ScanPoint>> results(blocks.size());
  parallelBlocks(blocks.size(), 1, options.threads, [&](std::size_t i, std::size_t) {
    results[i] = scanBlock(tracer, scene.placement, stations[blocks[i].first],
                           blocks[i].second, options.seed);
  });
  Scan scan;
  for (const Station& station : stations) {
    scan.positions.push_back({placed(scene.placement, station.place), 0});
    scan.rays += station.azimuths * station.elevations;
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    scan.positions[blocks[i].first].points += results[i].size();
    scan.points.insert(scan.points.end(), results[i].begin(), results[i].end());
    results[i] = {};
  }
  return scan;
}

} // namespace pcl::sedr::sim
