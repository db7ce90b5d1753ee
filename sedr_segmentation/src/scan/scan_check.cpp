// SPDX-License-Identifier: BSD-3-Clause
#include "scan_check.h"

#include "patch_normals.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/quantiles.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief Returns the extent along an axis, without a share of the points at each end:
 * one in `of`. */
double
extentAlong(const std::vector<Eigen::Vector3f>& points, int axis, std::size_t of = 100)
{
  std::vector<float> values;
  for (const auto& p : points)
    values.push_back(p[axis]);
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / of);
  const auto high = values.end() - 1 - (low - values.begin());
  std::nth_element(values.begin(), low, values.end());
  const double from = *low;
  std::nth_element(values.begin(), high, values.end());
  return *high - from;
}

} // namespace

std::string
scanProblem(const PointView& points,
            const std::vector<int>* indices,
            const Priors& priors)
{
  constexpr std::size_t max_sample = 100000;
  const std::size_t size = indices ? indices->size() : points.size();
  const std::size_t step = size / max_sample + 1;
  std::vector<Eigen::Vector3f> sample;
  std::size_t finite = 0;
  for (std::size_t k = 0; k < size; ++k)
    if (const Eigen::Vector3f p =
            points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
        p.allFinite() && finite++ % step == 0)
      sample.push_back(p);
  const auto fewest = static_cast<std::size_t>(priors.min_scan_points);
  if (finite < fewest)
    return formatText("%.0f of %.0f points are finite, a room needs at least %.0f",
                      static_cast<double>(finite), static_cast<double>(size),
                      static_cast<double>(fewest));
  const double x = extentAlong(sample, 0);
  const double y = extentAlong(sample, 1);
  const double z = extentAlong(sample, 2);
  if (z > priors.max_building_height || std::min(x, y) > priors.max_building_extent) {
    // The unit in which the scan would have the height of a building.
    const bool is_centimetre = z < 10 * priors.max_building_height &&
                               std::min(x, y) < priors.max_building_extent;
    const char* const scale = is_centimetre ? "0.01" : "0.001";
    return formatText("the scan is %.0f x %.0f x %.0f m large: if its unit is the %s, "
                      "scale it by %s (--unit %s in pcl_sedr)%s",
                      x, y, z, is_centimetre ? "centimetre" : "millimetre", scale,
                      scale, is_centimetre ? ", if it is the inch, by 0.0254" : "");
  }
  if (std::max(x, y) < 1 || std::max({x, y, z}) < 1.5)
    return formatText(
        "the scan is %.3f x %.3f x %.3f m large, too small for a room: its unit must "
        "be the metre",
        x, y, z);
  return {};
}

namespace {

constexpr std::int32_t square_size = 20;
constexpr std::size_t min_of_square = 10;

/** @brief Minimum median fill; below it the scan is sparse in too many places. */
constexpr double fill_enough = 0.98;

/** @brief Numbers of cells between two occupied ones. */
struct Between {
  std::size_t all = 0;
  std::size_t occupied = 0;
};

CellKey
squareOf(Cell cell)
{
  const auto down = [](std::int32_t v) {
    return (v >= 0 ? v : v - square_size + 1) / square_size;
  };
  return keyOf({down(cell.x), down(cell.y)});
}

/** @brief Counts the cells between two occupied ones in direction `way`. */
void
countBetween(const CellSet& cells, Cell way, std::map<CellKey, Between>& squares)
{
  auto last = squares.end(); // the next cell in a row is mostly in the same square
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell middle{cells[i].x + way.x, cells[i].y + way.y};
    if (!cells.contains({middle.x + way.x, middle.y + way.y}))
      continue;
    const CellKey square = squareOf(middle);
    if (last == squares.end() || last->first != square)
      last = squares.try_emplace(square).first;
    ++last->second.all;
    last->second.occupied += cells.contains(middle) ? 1 : 0;
  }
}

/** @brief Returns the fill of each square, weighted by its occupied cells. */
std::vector<Weighted>
sharesOf(const std::vector<CellSet>& ceilings)
{
  std::vector<Weighted> shares;
  for (const CellSet& cells : ceilings) {
    std::map<CellKey, Between> squares;
    countBetween(cells, {1, 0}, squares);
    countBetween(cells, {0, 1}, squares);
    for (const auto& [key, square] : squares)
      if (square.all >= min_of_square) {
        const auto occupied = static_cast<double>(square.occupied);
        shares.push_back({occupied / static_cast<double>(square.all), occupied});
      }
  }
  return shares;
}

} // namespace

double
cellSizeFor(const std::vector<CellSet>& ceilings, double size, const Priors& priors)
{
  const std::vector<Weighted> shares = sharesOf(ceilings);
  if (shares.empty() || weightedQuantile(shares, 0.5) >= fill_enough)
    return size;
  const double fill = std::max(weightedQuantile(shares, 0.1), 0.01);
  const double enlargement =
      std::sqrt(std::log(1 - priors.cell_fill) / std::log(1 - fill));
  const double wanted = size * std::clamp(enlargement, 1.0, priors.max_enlargement);
  const double up = 1 / std::max(1.0, std::floor(1 / wanted));
  const bool is_too_large = up > size * priors.max_enlargement;
  return std::max(size, is_too_large ? 1 / std::ceil(1 / wanted) : up);
}

namespace {

constexpr double patch = 0.3; // metres

/** @brief Returns what is missing of a floor and a ceiling.
 * @param level points on level planes, by height in patches
 * @param upright likewise on upright ones */
std::string
missingLevel(const std::map<long, double>& level,
             const std::map<long, double>& upright,
             double headroom)
{
  double most = 0;
  for (const auto& of_height : level)
    most = std::max(most, of_height.second);
  long low = std::numeric_limits<long>::max(), high = 0;
  for (const auto& [height, count] : level)
    if (4 * count >= most) {
      low = std::min(low, height);
      high = height;
    }
  if (level.empty())
    return "neither a floor nor a ceiling was seen";
  if (static_cast<double>(high - low + 1) * patch > headroom)
    return {};
  double above = 0, below = 0;
  for (const auto& [height, count] : upright) {
    above += height > high ? count : 0;
    below += height < low ? count : 0;
  }
  return above >= below
             ? formatText("a floor was seen at z = %.1f m, but no ceiling above it: it "
                          "is outdoors, or its ceiling is missing",
                          static_cast<double>(low) * patch)
             : formatText("a ceiling was seen at z = %.1f m, but no floor below it",
                          static_cast<double>(high) * patch);
}

} // namespace

MissingSurfaces
missingSurfaces(const PointView& points,
                const std::vector<int>& indices,
                unsigned threads,
                const Priors& priors)
{
  std::vector<PlanePatch> patches;
  for (const double offset : {0.0, 0.5}) { // a surface may lie between two cubes
    const std::vector<PlanePatch> found =
        planesOf(points, indices, Eigen::Matrix3d::Identity(), patch, threads, offset,
                 std::numeric_limits<double>::infinity());
    patches.insert(patches.end(), found.begin(), found.end());
  }
  const double max_scatter = 2 * priors.slab_noise;
  double count = 0;
  std::vector<Weighted> scatters;
  std::map<long, double> level, upright;
  for (const PlanePatch& plane : patches) {
    count += plane.count;
    scatters.push_back({plane.scatter, plane.count});
    if (plane.scatter > max_scatter)
      continue;
    const long height = std::lround(plane.middle.z() / patch);
    if (plane.normal.z() > 0.9)
      level[height] += plane.count;
    else if (plane.normal.z() < 0.2)
      upright[height] += plane.count;
  }
  MissingSurfaces missing;
  if (5 * count < 2 * static_cast<double>(indices.size())) {
    missing.reason =
        "the points are too sparse, or strewn: few cubes of 0.3 m have 20 of them";
    return missing;
  }
  missing.scatter = weightedQuantile(scatters, 0.5);
  missing.is_noisy = missing.scatter > max_scatter;
  missing.reason =
      missing.is_noisy
          ? formatText("half of the points lie %.1f cm or more off the planes that fit "
                       "them best: the scan is too noisy, or its points are strewn",
                       100 * missing.scatter)
          : missingLevel(level, upright, priors.min_headroom);
  return missing;
}

std::string
inchProblem(const PointView& points, std::size_t storeys)
{
  constexpr double lowest = 60;   // metres, if the metre is the unit
  constexpr double highest = 200; // above, the check of the scan detects the unit
  constexpr double max_a_storey = 30;
  std::vector<Eigen::Vector3f> finite;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      finite.push_back(points[i]);
  const double height = finite.empty() ? 0 : extentAlong(finite, 2, 10);
  if (!(height > lowest && height < highest &&
        height > max_a_storey * static_cast<double>(storeys)))
    return {};
  return "the scan is " + std::to_string(std::lround(height)) +
         " m high: if its unit is the inch, scale it by 0.0254 (--unit 0.0254 in "
         "pcl_sedr)";
}

namespace {

/** @brief Lengths of a kind, or areas, as they are in buildings. */
struct Usual {
  double low; ///< metres, square metres
  double high;
  double foot = pcl::sedr::foot; ///< the unit in which they may be
  bool may_be_less = false;      ///< as easily as they may be more

  double costOf(double value) const
  {
    const double x = std::log(value * value / (low * high)) / std::log(high / low);
    return x < 0 && !may_be_less ? 2 * x * x : std::log1p(x * x);
  }

  /** @brief Returns how much more likely a value is in feet, nats. */
  double natsOf(double value) const
  {
    return value > 0 ? costOf(value) - costOf(value * foot) : 0;
  }
};

Usual
usualHeight(const Priors& priors)
{
  return {priors.min_home_height, priors.max_home_height};
}

/** @brief What is known of the unit of a plan. */
struct UnitEvidence {
  double nats = 0;
  std::string words;

  /** @brief Adds the median of some values, if there are any, with words for it. */
  void add(const std::vector<double>& values, const Usual& usual, const char* format)
  {
    if (values.empty())
      return;
    const double value = middleValue(values);
    nats += usual.natsOf(value);
    words += formatText(format, value);
  }
};

/** @brief Returns how far above the floors of rooms the scanner stood. */
std::vector<double>
heightsOfScanners(const Floorplan& plan, const std::vector<Eigen::Vector3f>& places)
{
  std::vector<double> heights;
  for (const Eigen::Vector3f& place : places) {
    const Eigen::Vector3d p = place.cast<double>();
    for (const PlanRoom& room : plan.rooms)
      if (p.z() > room.floor.heightAt(p.head<2>()) &&
          p.z() < room.ceiling.heightAt(p.head<2>()) && room.contains(p.head<2>()))
        heights.push_back(p.z() - room.floor.heightAt(p.head<2>()));
  }
  return heights;
}

} // namespace

double
costOfHeight(double height, const Priors& priors)
{
  return usualHeight(priors).costOf(height);
}

UnitDoubt
footProblem(const Floorplan& plan,
            const std::vector<RoomLink>& links,
            const std::vector<Eigen::Vector3f>& places,
            const Priors& priors)
{
  constexpr double doubtful = 2;         // nats
  constexpr double lowest_scanner = 1.2; // metres; one on a table
  const Usual height = usualHeight(priors);
  const Usual area{4 * priors.min_slab_area, priors.max_home_area, foot * foot, true};
  double whole = 0;
  double sum = 0;
  double largest = 0;
  double height_of_largest = 0;
  for (const PlanRoom& room : plan.rooms) {
    if (room.boundary.elements.empty())
      continue;
    const double size = room.area();
    const double usual = clearHeight(room).usual;
    whole += size;
    sum += size * (height.natsOf(usual) + area.natsOf(size));
    if (size > largest) {
      largest = size;
      height_of_largest = usual;
    }
  }
  if (!(whole > 0))
    return {};
  UnitEvidence evidence;
  evidence.nats = sum / whole;
  std::vector<double> doors;
  for (const RoomLink& link : links)
    doors.push_back(link.height());
  std::vector<double> walls;
  for (const auto& of_room : wallThicknesses(plan, priors.max_wall / foot))
    for (const double thickness : of_room)
      if (thickness > 0)
        walls.push_back(thickness);
  evidence.add(doors, {priors.min_headroom, priors.max_door_height},
               ", doors are %.1f m high");
  evidence.add(walls, {priors.min_wall, priors.max_wall, foot, true},
               ", walls %.2f m thick");
  evidence.add(heightsOfScanners(plan, places),
               {lowest_scanner, priors.max_door_height},
               ", and the scanner stood %.1f m above the floor");
  if (!(evidence.nats > doubtful))
    return {};
  return {evidence.nats, formatText("the %sroom is %.1f m high and %.0f m2 large",
                                    plan.rooms.size() > 1 ? "largest " : "",
                                    height_of_largest, largest) +
                             evidence.words + ": " + if_in_feet};
}

} // namespace pcl::sedr
