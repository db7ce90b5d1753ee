// SPDX-License-Identifier: BSD-3-Clause
#include "unit_check.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/quantiles.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

std::string
inchProblem(const PointView& points, std::size_t storeys)
{
  constexpr float lowest = 60;   // metres, if the metre is the unit
  constexpr float highest = 200; // above, the check of the scan detects the unit
  constexpr float max_a_storey = 30;
  std::vector<float> heights;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      heights.push_back(points[i].z());
  if (heights.empty())
    return {};
  const auto cut = static_cast<std::ptrdiff_t>(heights.size() / 10);
  std::nth_element(heights.begin(), heights.begin() + cut, heights.end());
  const float low = heights[static_cast<std::size_t>(cut)];
  std::nth_element(heights.begin(), heights.end() - 1 - cut, heights.end());
  const float height = *(heights.end() - 1 - cut) - low;
  if (!(height > lowest && height < highest &&
        height > max_a_storey * static_cast<float>(storeys)))
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
