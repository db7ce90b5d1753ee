// SPDX-License-Identifier: BSD-3-Clause
#include "reveals.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Parts of rooms below a lower ceiling, one after the other. */
class Reveals {
public:
  Reveals(const AirGaps& air,
          const std::vector<float>& dip,
          double lintel,
          const std::vector<std::int32_t>& room)
      : air_(air)
      , dip_(dip)
      , lintel_(lintel)
      , room_(room)
      , is_met_(air.size(), 0)
  {}

  std::vector<std::uint8_t> find()
  {
    std::vector<std::uint8_t> is_reveal(air_.size(), 0);
    for (std::uint32_t g = 0; g < air_.size(); ++g) {
      if (!isLow(g) || is_met_[g] != 0)
        continue;
      const std::vector<std::uint32_t> part = partFrom(g);
      if (isReveal(part))
        for (const std::uint32_t of_part : part)
          is_reveal[of_part] = 1;
    }
    return is_reveal;
  }

private:
  static constexpr int beside = 3; ///< columns: more than what noise hides of a wall

  bool isLow(std::uint32_t g) const { return room_[g] >= 0 && dip_[g] >= lintel_; }

  std::vector<std::uint32_t> partFrom(std::uint32_t start)
  {
    std::vector<std::uint32_t> part{start};
    is_met_[start] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(part[k], d);
        if (o != AirGaps::none && isLow(o) && room_[o] == room_[start] && !is_met_[o]) {
          is_met_[o] = 1;
          part.push_back(o);
        }
      }
    return part;
  }

  Eigen::Vector2d placeOf(std::uint32_t g) const
  {
    return air_.columns().grid().centre(air_.columns().cellOf(air_[g].column));
  }

  /** @brief Whether there is air at a place, at the heights of a gap. */
  bool isAir(const Eigen::Vector2d& place, std::uint32_t like) const
  {
    const std::uint32_t column =
        air_.columns().columnAt(air_.columns().grid().at(place.x(), place.y()));
    return air_.goingOnFrom(air_[like], column) != AirGaps::none;
  }

  /** @brief Whether a wall, or a pier between two windows, is beside a gap.
   * @param out to the next column */
  bool isWallBeside(std::uint32_t g, const Eigen::Vector2d& out) const
  {
    for (int k = 1; k <= beside; ++k)
      if (!isAir(placeOf(g) + k * out, g))
        return true;
    return false;
  }

  bool isReveal(const std::vector<std::uint32_t>& part) const
  {
    // Where the part opens to its room, and which way.
    Eigen::Vector2d into_room = Eigen::Vector2d::Zero();
    std::vector<std::uint32_t> mouth;
    for (const std::uint32_t g : part)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(g, d);
        if (o == AirGaps::none || room_[o] != room_[g] || isLow(o))
          continue;
        into_room += placeOf(o) - placeOf(g);
        mouth.push_back(g);
      }
    const double cell = air_.columns().cellSize();
    if (mouth.empty() ||
        into_room.norm() < 0.5 * cell * static_cast<double>(mouth.size()))
      return false; // open on several sides: a beam
    into_room.normalize();
    const Eigen::Vector2d along(-into_room.y(), into_room.x());
    const std::vector<std::uint32_t> inner = innerHalf(part, into_room);
    if (meanTop(inner) < meanTop(mouth) - 0.5 * air_.voxels(lintel_))
      return false; // a ceiling that slopes down to a wall
    int walls = 0;
    int jambs = 0;
    for (const double side : {-1.0, 1.0}) {
      const std::uint32_t end = endOf(mouth, side * along);
      const std::uint32_t deepest = endOf(inner, side * along);
      const Eigen::Vector2d out = side * cell * along;
      walls += isWallBeside(deepest, out) ? 1 : 0;
      jambs += isAir(placeOf(end) + beside * out + 2 * cell * into_room, end) ? 1 : 0;
    }
    return walls == 2 && jambs > 0;
  }

  /** @brief Of the ceilings of some gaps, voxels. */
  double meanTop(const std::vector<std::uint32_t>& gaps) const
  {
    double sum = 0;
    for (const std::uint32_t g : gaps)
      sum += air_[g].high;
    return sum / static_cast<double>(gaps.size());
  }

  /** @brief The half of a part that is farther from the room. */
  std::vector<std::uint32_t> innerHalf(std::vector<std::uint32_t> part,
                                       const Eigen::Vector2d& into_room) const
  {
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), middle, part.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double off = into_room.dot(placeOf(a) - placeOf(b));
                       return off != 0 ? off < 0 : a < b;
                     });
    part.erase(middle + 1, part.end());
    return part;
  }

  /** @brief The gap of some that is farthest in a direction. */
  std::uint32_t endOf(const std::vector<std::uint32_t>& gaps,
                      const Eigen::Vector2d& direction) const
  {
    double farthest = -std::numeric_limits<double>::infinity();
    std::uint32_t end = gaps.front();
    for (const std::uint32_t g : gaps)
      if (direction.dot(placeOf(g)) > farthest) {
        farthest = direction.dot(placeOf(g));
        end = g;
      }
    return end;
  }

  const AirGaps& air_;
  const std::vector<float>& dip_;
  double lintel_;
  const std::vector<std::int32_t>& room_;
  std::vector<std::uint8_t> is_met_;
};

} // namespace

std::vector<std::uint8_t>
revealsOf(const AirGaps& air,
          const std::vector<float>& dip,
          double lintel,
          const std::vector<std::int32_t>& room)
{
  return Reveals(air, dip, lintel, room).find();
}

} // namespace pcl::sedr
