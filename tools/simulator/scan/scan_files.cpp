// SPDX-License-Identifier: BSD-3-Clause
#include "scan_files.h"

#include "bytes/whole_file.h"
#include "random.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kBetween = 0.3; ///< metres of wall between two copies of a building

static_assert(sizeof(ScanPoint) == 20, "a point is written as it lies in memory");

void
writeHeader(std::ostream& file, std::size_t count)
{
  file << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
       << "FIELDS x y z label room\nSIZE 4 4 4 4 4\nTYPE F F F U U\nCOUNT 1 1 "
          "1 1 1\n"
       << "WIDTH " << count << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
       << "POINTS " << count << "\nDATA binary\n";
}

void
writeRows(std::ostream& file, const std::vector<ScanPoint>& points)
{
  file.write(reinterpret_cast<const char*>(points.data()),
             static_cast<std::streamsize>(points.size() * sizeof(ScanPoint)));
}

/** @brief A point without noise, and the direction of its noise. */
struct ExactPoint {
  Vec3 place;
  Vec3 ray; ///< unit length
  double noise = 0.0;
  const ScanPoint* point = nullptr;
};

/** @brief Returns the points of a scan with the directions they were seen from. */
std::vector<ExactPoint>
exactPointsOf(const Scene& scene, const Scan& scan, std::optional<double> noise)
{
  std::vector<ExactPoint> points;
  auto position = scan.positions.begin();
  for (const Scanner& scanner : scene.scanners)
    for (std::size_t i = 0; i < scanner.stations.size(); ++i, ++position)
      for (std::size_t k = 0; k < position->points; ++k) {
        const ScanPoint& point = scan.points[points.size()];
        const Vec3 place(point.x, point.y, point.z);
        points.push_back({place, (place - position->place).normalized(),
                          noise.value_or(scanner.noise), &point});
      }
  return points;
}

/** @brief Returns the distances between neighbouring copies along x and y. */
Vec2
pitchOf(const Scene& scene)
{
  Box2 bounds;
  for (const Room& room : scene.rooms)
    bounds.extend(boundsOf(room.outline));
  return bounds.sizes() + Vec2(kBetween, kBetween);
}

} // namespace

void
writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points)
{
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    writeHeader(file, points.size());
    writeRows(file, points);
  });
}

void
writePositions(const std::filesystem::path& path,
               const std::vector<ScanPosition>& positions)
{
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    file.precision(10);
    file << "# x y z points\n";
    for (const ScanPosition& position : positions)
      file << position.place.x() << ' ' << position.place.y() << ' '
           << position.place.z() << ' ' << position.points << '\n';
  });
}

BuildingScan
writeBuilding(const std::filesystem::path& path,
              const Scene& scene,
              std::size_t points,
              const ScanOptions& options)
{
  Scene plain = scene;
  plain.outside.clear();
  plain.placement = {};
  ScanOptions noiseless = options;
  noiseless.noise = 0.0;
  noiseless.progress = nullptr;
  const Scan one = scan(plain, noiseless);
  const std::vector<ExactPoint> exact = exactPointsOf(plain, one, options.noise);
  if (exact.empty())
    throw std::invalid_argument("no ray of scene " + scene.name + " hits a room");
  BuildingScan building;
  building.copies =
      std::max<std::size_t>(1, (points + exact.size() / 2) / exact.size());
  building.points = building.copies * exact.size();
  const Vec2 pitch = pitchOf(scene);
  const auto copies = static_cast<double>(building.copies);
  const auto in_row = static_cast<std::size_t>(
      std::max(1.0, std::round(std::sqrt(copies * pitch.y() / pitch.x()))));
  tools::writeWhole(path.string(), [&](std::ostream& file) {
    writeHeader(file, building.points);
    std::vector<ScanPoint> rows(exact.size());
    for (std::size_t copy = 0; copy < building.copies; ++copy) {
      const Vec3 shift(static_cast<double>(copy % in_row) * pitch.x(),
                       static_cast<double>(copy / in_row) * pitch.y(), 0.0);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const double noise =
            exact[i].noise *
            RayRandom(options.seed, ~std::uint64_t{copy}, i).gaussian();
        rows[i] = *exact[i].point;
        if (rows[i].room > 0)
          rows[i].room += static_cast<std::uint32_t>(copy * scene.rooms.size());
        const Vec3 p = exact[i].place + shift + noise * exact[i].ray;
        std::tie(rows[i].x, rows[i].y, rows[i].z) =
            std::make_tuple(static_cast<float>(p.x()), static_cast<float>(p.y()),
                            static_cast<float>(p.z()));
      }
      writeRows(file, rows);
      if (options.progress)
        options.progress(static_cast<double>(copy + 1) / copies);
    }
  });
  return building;
}

} // namespace pcl::sedr::sim
