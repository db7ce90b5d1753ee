// SPDX-License-Identifier: BSD-3-Clause
#include "room_parting.h"

#include "gap_distance.h"
#include "height_counts.h"
#include "reveals.h"
#include "wall_beside.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr std::uint32_t none = AirGaps::none;
constexpr std::int32_t no_room = PartedAir::no_room;

/** @brief Sets that are joined. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t n)
      : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t into, std::uint32_t other) { parent_[other] = into; }

private:
  std::vector<std::uint32_t> parent_;
};

/** @brief Whether the floors below two gaps in which one can stand are those of
 * different levels. */
bool
isLevelApart(const AirGaps& air, std::uint32_t g, std::uint32_t o)
{
  const double headroom = air.parameters().headroom;
  return air.height(g) >= headroom && air.height(o) >= headroom &&
         std::abs(air[g].low - air[o].low) * air.columns().voxelHeight() >
             air.parameters().highest_step;
}

/** @brief Basins of the distance from the rim: from their middles outwards; where two
 * meet in a neck that is about as wide as the narrower of them they are one. */
std::vector<std::int32_t>
basinsOf(const AirGaps& air, const std::vector<float>& distance, double same_basin)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (distance[g] > 0)
      order.push_back(g);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return distance[a] > distance[b];
  });
  std::vector<std::int32_t> basin(air.size(), no_room);
  std::vector<float> peak;
  DisjointSets sets(order.size());
  for (const std::uint32_t g : order) {
    std::vector<std::uint32_t> met;
    std::uint32_t uphill = none; // towards its own middle, not into what is larger
    for (int d = 0; d < 4; ++d)
      for (const std::uint32_t o :
           {air.isDrop(g, d) ? none : air.link(g, d), air.diagonal(g, d)})
        if (o != none && basin[o] != no_room && !isLevelApart(air, g, o)) {
          met.push_back(sets.find(static_cast<std::uint32_t>(basin[o])));
          if (uphill == none || distance[o] > distance[uphill])
            uphill = o;
        }
    if (met.empty()) {
      basin[g] = static_cast<std::int32_t>(peak.size());
      peak.push_back(distance[g]);
      continue;
    }
    basin[g] = basin[uphill];
    const auto highest = *std::max_element(
        met.begin(), met.end(), [&](std::uint32_t a, std::uint32_t b) {
          return std::pair(peak[a], b) < std::pair(peak[b], a);
        });
    for (const std::uint32_t other : met)
      if (sets.find(other) != sets.find(highest) &&
          distance[g] >= same_basin * std::min(peak[other], peak[highest]))
        sets.join(highest, sets.find(other));
  }
  for (std::int32_t& b : basin)
    if (b != no_room)
      b = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(b)));
  return basin;
}

/** @brief Takes labels outwards, step by step, to gaps that have none. */
void
growLabels(const AirGaps& air, std::vector<std::int32_t>& label)
{
  std::vector<std::uint32_t> front;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (label[g] != no_room)
      front.push_back(g);
  while (!front.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t g : front)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air.link(g, d);
        if (o != none && label[o] == no_room && !air.isDrop(g, d)) {
          label[o] = label[g];
          next.push_back(o);
        }
      }
    front = std::move(next);
  }
}

/** @brief A link from the air of one room to that of another. */
struct Crossing {
  std::uint32_t from = 0; ///< gap of the room with the lower number
  std::uint32_t to = 0;
};

/** @brief What is between two rooms. */
struct Border {
  std::vector<Crossing> crossings;
  std::size_t walls = 0;   ///< ends of air that face the other room's across a wall
  std::size_t stacked = 0; ///< columns in which one lies above the other
};

/** @brief Two rooms, the lower number first. */
using RoomPair = std::pair<std::uint32_t, std::uint32_t>;

/** @brief An opening with what is needed to judge it. */
struct Measured {
  RoomOpening opening;
  double jamb_a = 0; ///< how far the first room goes on beside one of its ends, metres
  double jamb_b = 0; ///< the same of the second
  double beside = 0; ///< beside both ends together, of the room with more, metres
  double open_height = 0; ///< of the opening over that of the air beside it
  double floor_step = 0;  ///< between the floors beside it, metres
  bool has_ends = false;  ///< whether walls stand at both of its ends
};

class Parting {
public:
  Parting(const AirGaps& air, const PartingParameters& parameters)
      : air_(air)
      , parameters_(parameters)
      , cell_(air.columns().cellSize())
      , dip_(dipOfCeiling(
            air,
            static_cast<int>(std::lround(parameters.lintel_reach / cell_))))
      , free_(distanceToRim(air, std::vector<std::uint8_t>(air.size(), 1)))
  {}

  PartedAir run()
  {
    visited_.assign(air_.size(), 0);
    dropSpecks();
    std::vector<std::uint8_t> is_level(air_.size());
    for (std::size_t g = 0; g < air_.size(); ++g)
      is_level[g] = dip_[g] < parameters_.lintel ? 1 : 0;
    label_ = basinsOf(air_, distanceToRim(air_, is_level), parameters_.same_basin);
    growLabels(air_, label_);
    number();
    measureBorders();
    joinAll();
    number();
    return result();
  }

private:
  /** @brief Takes dips of too few columns for a lintel for points in the air. */
  void dropSpecks()
  {
    for (std::uint32_t start = 0; start < air_.size(); ++start) {
      if (dip_[start] < parameters_.lintel || visited_[start] != 0)
        continue;
      std::vector<std::uint32_t> speck{start};
      visited_[start] = 1;
      for (std::size_t k = 0; k < speck.size(); ++k)
        for (int d = 0; d < 4; ++d)
          for (const std::uint32_t o :
               {air_.link(speck[k], d), air_.diagonal(speck[k], d)})
            if (o != none && dip_[o] >= parameters_.lintel && visited_[o] == 0) {
              visited_[o] = 1;
              speck.push_back(o);
            }
      if (speck.size() < static_cast<std::size_t>(parameters_.smallest_lintel))
        for (const std::uint32_t g : speck)
          dip_[g] = 0;
    }
    round_ = 1;
  }

  /** @brief Numbers the labels anew by size, largest first. */
  void number()
  {
    std::map<std::int32_t, std::size_t> size;
    for (const std::int32_t l : label_)
      if (l != no_room)
        ++size[l];
    std::vector<std::pair<std::size_t, std::int32_t>> order;
    for (const auto& [l, n] : size)
      order.emplace_back(n, l);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::map<std::int32_t, std::int32_t> number;
    for (std::size_t k = 0; k < order.size(); ++k)
      number[order[k].second] = static_cast<std::int32_t>(k);
    for (std::int32_t& l : label_)
      if (l != no_room)
        l = number[l];
    area_.assign(order.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k)
      area_[k] = static_cast<double>(order[k].first) * cell_ * cell_;
  }

  Border& borderOf(std::uint32_t a, std::uint32_t b)
  {
    return borders_[{std::min(a, b), std::max(a, b)}];
  }

  void measureBorders()
  {
    const int reach = static_cast<int>(std::lround(parameters_.thickest_wall / cell_));
    ends_.assign(area_.size(), 0);
    for (std::uint32_t g = 0; g < air_.size(); ++g) {
      const std::int32_t own = label_[g];
      if (own == no_room)
        continue;
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(g, d);
        if (o != none) {
          if (own < label_[o])
            borderOf(static_cast<std::uint32_t>(own),
                     static_cast<std::uint32_t>(label_[o]))
                .crossings.push_back({g, o});
          continue;
        }
        ++ends_[static_cast<std::size_t>(own)];
        const std::int32_t facing = facedFrom(g, d, reach);
        if (facing != no_room && facing != own)
          ++borderOf(static_cast<std::uint32_t>(own),
                     static_cast<std::uint32_t>(facing))
                .walls;
      }
    }
    countStacked();
    depth_.assign(area_.size(), 0);
    floors_.assign(area_.size(), {});
    for (std::uint32_t g = 0; g < air_.size(); ++g)
      if (label_[g] != no_room) {
        const auto own = static_cast<std::size_t>(label_[g]);
        depth_[own] = std::max<double>(depth_[own], free_[g] * cell_);
        floors_[own].add(air_.columns().heightOf(air_[g].low));
      }
    sets_ = DisjointSets(area_.size());
    beside_.assign(area_.size(), {});
    for (auto& [pair, border] : borders_) {
      border.walls = (border.walls + 1) / 2; // each is met from both sides
      beside_[pair.first].insert(pair.second);
      beside_[pair.second].insert(pair.first);
    }
  }

  void countStacked()
  {
    for (std::uint32_t g = 0; g + 1 < air_.size(); ++g)
      for (std::uint32_t o = g + 1; o < air_.size() && air_[o].column == air_[g].column;
           ++o)
        if (label_[g] != no_room && label_[o] != no_room && label_[g] != label_[o])
          ++borderOf(static_cast<std::uint32_t>(label_[g]),
                     static_cast<std::uint32_t>(label_[o]))
                .stacked;
  }

  /** @brief The room whose air is first met behind what ends a gap's. */
  std::int32_t facedFrom(std::uint32_t g, int d, int reach) const
  {
    std::uint32_t column = air_[g].column;
    for (int step = 0; step <= reach; ++step) {
      column = air_.columns().neighbour(column, d);
      if (column == VoxelColumns::none)
        return no_room;
      const std::uint32_t o = air_.overlapping(column, air_[g].low, air_[g].high);
      if (o != none && (step > 0 || label_[o] != label_[g]))
        return label_[o];
    }
    return no_room;
  }

  /** @brief The openings of a border: its crossings, those near each other together.
   */
  std::vector<std::vector<Crossing>> openingsOf(const Border& border) const
  {
    std::unordered_map<CellKey, std::vector<std::uint32_t>> at;
    for (std::uint32_t k = 0; k < border.crossings.size(); ++k)
      at[keyOf(cellOfGap(border.crossings[k].from))].push_back(k);
    DisjointSets sets(border.crossings.size());
    constexpr int near = 2; // cells
    for (std::uint32_t k = 0; k < border.crossings.size(); ++k) {
      const Cell c = cellOfGap(border.crossings[k].from);
      for (int dx = -near; dx <= near; ++dx)
        for (int dy = -near; dy <= near; ++dy) {
          const auto found = at.find(keyOf({c.x + dx, c.y + dy}));
          if (found == at.end())
            continue;
          for (const std::uint32_t o : found->second) {
            const std::uint32_t p = sets.find(k);
            const std::uint32_t q = sets.find(o);
            if (p != q)
              sets.join(std::min(p, q), std::max(p, q));
          }
        }
    }
    std::map<std::uint32_t, std::vector<Crossing>> parts;
    for (std::uint32_t k = 0; k < border.crossings.size(); ++k)
      parts[sets.find(k)].push_back(border.crossings[k]);
    std::vector<std::vector<Crossing>> openings;
    for (auto& entry : parts)
      openings.push_back(std::move(entry.second));
    return openings;
  }

  /** @brief The room of a gap that has one, joined ones as one. */
  std::uint32_t roomOf(std::uint32_t g)
  {
    return sets_.find(static_cast<std::uint32_t>(label_[g]));
  }

  Cell cellOfGap(std::uint32_t g) const
  {
    return air_.columns().cellOf(air_[g].column);
  }

  /** @brief The height of a room's floor near an opening: that which most of it has,
   * not over the edge of a stairwell. */
  double floorBeside(const std::vector<Crossing>& crossings, bool of_first)
  {
    constexpr double reach = 1; // metres
    ++round_;
    const auto isNew = [&](std::uint32_t g) {
      return std::exchange(visited_[g], round_) != round_;
    };
    std::vector<std::uint32_t> front;
    for (const Crossing& c : crossings)
      if (isNew(of_first ? c.from : c.to))
        front.push_back(of_first ? c.from : c.to);
    HeightCounts lows;
    for (int step = 0; step <= reach / cell_ && !front.empty(); ++step) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t g : front) {
        lows.add(air_.columns().heightOf(air_[g].low));
        for (int d = 0; d < 4; ++d) {
          const std::uint32_t o = air_.link(g, d);
          if (o != none && !air_.isDrop(g, d) && label_[o] != no_room &&
              roomOf(o) == roomOf(g) && isNew(o))
            next.push_back(o);
        }
      }
      front = std::move(next);
    }
    return lows.highestCount();
  }

  /** @brief Whether a place in plan is in the air of a room at the heights of a gap. */
  bool isInRoom(const Eigen::Vector2d& place, std::uint32_t like, std::uint32_t room)
  {
    const std::uint32_t column =
        air_.columns().columnAt(air_.columns().grid().at(place.x(), place.y()));
    const std::uint32_t g = air_.overlapping(column, air_[like].low, air_[like].high);
    return g != none && label_[g] != no_room && roomOf(g) == room;
  }

  /** @brief How far a room goes on beside each end of an opening, metres: behind the
   * wall in which it is. */
  std::array<double, 2> besideOf(const std::array<std::uint32_t, 2>& ends,
                                 const Eigen::Vector2d& direction,
                                 const Eigen::Vector2d& into,
                                 std::uint32_t room)
  {
    constexpr double reach = 2; // metres
    constexpr int depth = 5;    // columns from the middle of the wall
    std::array<double, 2> farthest{0, 0};
    for (std::size_t end = 0; end < 2; ++end)
      for (int away = 1; away <= depth; ++away) {
        const Eigen::Vector2d outwards = (end == 0 ? -cell_ : cell_) * direction;
        Eigen::Vector2d place =
            air_.columns().grid().centre(cellOfGap(ends[end])) + away * cell_ * into;
        double length = -cell_; // the first step is the end itself
        while (length < reach && isInRoom(place, ends[end], room)) {
          length += cell_;
          place += outwards;
        }
        farthest[end] = std::max(farthest[end], length);
      }
    return farthest;
  }

  /** @brief The gaps at the two ends of an opening along its direction. */
  std::array<std::uint32_t, 2> endsOf(const std::vector<Crossing>& crossings,
                                      const Eigen::Vector2d& direction) const
  {
    std::array<double, 2> farthest{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    std::array<std::uint32_t, 2> end{};
    for (const Crossing& c : crossings) {
      const double along =
          direction.dot(air_.columns().grid().centre(cellOfGap(c.from)));
      if (along < farthest[0]) {
        farthest[0] = along;
        end[0] = c.from;
      }
      if (along > farthest[1]) {
        farthest[1] = along;
        end[1] = c.from;
      }
    }
    return end;
  }

  /** @brief Whether walls stand beyond both ends of an opening, not stairs, drops or
   * what was not seen. */
  bool endsAtWalls(const std::array<std::uint32_t, 2>& ends,
                   const Eigen::Vector2d& direction) const
  {
    const int reach = static_cast<int>(std::lround(parameters_.end_reach / cell_)) + 2;
    for (std::size_t end = 0; end < 2; ++end) {
      const Eigen::Vector2d outwards = (end == 0 ? -cell_ : cell_) * direction;
      const Eigen::Vector2d from = air_.columns().grid().centre(cellOfGap(ends[end]));
      bool is_wall = false;
      for (int step = 0; step <= reach && !is_wall; ++step) {
        const Eigen::Vector2d place = from + step * outwards;
        is_wall = isWallAt(
            air_,
            air_.columns().columnAt(air_.columns().grid().at(place.x(), place.y())),
            air_[ends[end]]);
      }
      if (!is_wall)
        return false;
    }
    return true;
  }

  /** @brief The direction along which most of an opening's crossings lie; for one or
   * two of them at a right angle to the way through. */
  Eigen::Vector2d directionOf(const std::vector<Crossing>& crossings,
                              const Eigen::Vector2d& normal) const
  {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const Crossing& c : crossings) {
      const Eigen::Vector2d at = (air_.columns().grid().centre(cellOfGap(c.from)) +
                                  air_.columns().grid().centre(cellOfGap(c.to))) /
                                 2;
      mean += at;
      squares += at * at.transpose();
    }
    const auto n = static_cast<double>(crossings.size());
    mean /= n;
    if (n <= 2 && normal.norm() > 0)
      return Eigen::Vector2d(-normal.y(), normal.x()).normalized();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(squares / n -
                                                          mean * mean.transpose())
        .eigenvectors()
        .col(1);
  }

  Measured measure(const std::vector<Crossing>& crossings)
  {
    Measured m;
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double dip = 0;
    double floor = 0;
    double top = 0;
    double beside_top = 0;
    for (const Crossing& c : crossings) {
      const Cell from = cellOfGap(c.from);
      const Cell to = cellOfGap(c.to);
      normal += Eigen::Vector2d(to.x - from.x, to.y - from.y);
      m.opening.middle +=
          (air_.columns().grid().centre(from) + air_.columns().grid().centre(to)) / 2;
      const float of_crossing = std::max(dip_[c.from], dip_[c.to]);
      const double high =
          air_.columns().heightOf(std::min(air_[c.from].high, air_[c.to].high));
      dip += of_crossing;
      floor += air_.columns().heightOf(std::max(air_[c.from].low, air_[c.to].low));
      top += high;
      beside_top += high + of_crossing;
    }
    const auto n = static_cast<double>(crossings.size());
    m.opening.middle /= n;
    m.opening.direction = directionOf(crossings, normal);
    const std::array<std::uint32_t, 2> ends = endsOf(crossings, m.opening.direction);
    const double chord =
        m.opening.direction.dot(air_.columns().grid().centre(cellOfGap(ends[1])) -
                                air_.columns().grid().centre(cellOfGap(ends[0])));
    m.opening.width = std::max(chord + cell_, n / std::sqrt(2.0) * cell_);
    m.opening.dip = dip / n;
    m.opening.bottom = floor / n;
    m.opening.top = top / n;
    const double floor_a = floorBeside(crossings, true);
    const double floor_b = floorBeside(crossings, false);
    m.floor_step = std::min(std::abs(floor_a - floor_b),
                            std::abs(floors_[roomOf(crossings[0].from)].highestCount() -
                                     floors_[roomOf(crossings[0].to)].highestCount()));
    m.open_height = std::clamp((m.opening.top - std::max(floor_a, floor_b)) /
                                   std::max(beside_top / n - std::min(floor_a, floor_b),
                                            air_.columns().voxelHeight()),
                               0.0, 1.0);
    m.has_ends = endsAtWalls(ends, m.opening.direction);
    if (m.has_ends && m.opening.width <= parameters_.widest_passage) {
      Eigen::Vector2d into(-m.opening.direction.y(), m.opening.direction.x());
      if (into.dot(normal) < 0)
        into = -into;
      const auto a =
          besideOf(ends, m.opening.direction, -into, roomOf(crossings[0].from));
      const auto b = besideOf(ends, m.opening.direction, into, roomOf(crossings[0].to));
      m.jamb_a = std::max(a[0], a[1]);
      m.jamb_b = std::max(b[0], b[1]);
      m.beside = std::max(a[0] + a[1], b[0] + b[1]);
    }
    return m;
  }

  bool isDoor(const Measured& m) const
  {
    if (!m.has_ends)
      return false;
    const bool has_lintel = m.opening.dip >= parameters_.least_lintel;
    const bool is_deep = m.opening.dip >= parameters_.deep_lintel;
    const bool on_one = std::max(m.jamb_a, m.jamb_b) >= parameters_.jamb;
    const bool on_both = std::min(m.jamb_a, m.jamb_b) >= parameters_.jamb;
    if (m.opening.width <= parameters_.widest_door)
      return on_both || (on_one && has_lintel);
    return m.opening.width <= parameters_.widest_passage &&
           ((on_both && has_lintel) || (on_one && is_deep));
  }

  /** @brief Share of a room's outline at which it goes on into others: what is open on
   * most sides is a place between columns or furniture and no room. */
  double openShare(std::uint32_t room) const
  {
    double open = 0;
    for (const std::uint32_t other : beside_[room]) {
      const auto found = borders_.find({std::min(room, other), std::max(room, other)});
      open += found == borders_.end()
                  ? 0
                  : static_cast<double>(found->second.crossings.size());
    }
    return open / std::max(1.0, open + static_cast<double>(ends_[room]));
  }

  /** @brief How open the border of two rooms is: the share of it that joins them; 0
   * where they are parted by doors alone. */
  double opennessOf(const RoomPair& pair, const Border& border)
  {
    constexpr double cells_a_length = 1.2; // of a slanting line, in the mean
    double open = 0;
    double length = static_cast<double>(border.walls) * cell_ / cells_a_length;
    bool are_doors = true;
    bool are_plain = true; // no wider than one door, below a lintel
    bool have_lintels = true;
    double beside = 0; // how far the wider room goes on beside a single opening
    const auto openings = openingsOf(border);
    for (const auto& crossings : openings) {
      const Measured m = measure(crossings);
      length += m.opening.width;
      open += m.opening.width * m.open_height;
      are_doors = are_doors && isDoor(m);
      beside = openings.size() == 1 ? m.beside : 0;
      have_lintels = have_lintels && m.opening.dip >= parameters_.least_lintel;
      are_plain =
          are_plain && have_lintels && m.opening.width <= parameters_.widest_door;
      if (m.floor_step > parameters_.same_floor && !isOnFurniture(pair))
        return 0;
    }
    const auto [smaller, larger] = std::minmax(area_[pair.first], area_[pair.second]);
    if (open <= 0 || static_cast<double>(border.stacked) * cell_ * cell_ >
                         parameters_.most_stacked * larger)
      return 0;
    const double share = open / length;
    const double of_width =
        have_lintels ? open / std::max(length, open + beside) : share;
    const bool parts = are_doors &&
                       (are_plain || of_width <= parameters_.widest_share) &&
                       smaller >= parameters_.smallest_room &&
                       openShare(pair.first) <= parameters_.most_open &&
                       openShare(pair.second) <= parameters_.most_open;
    return parts ? 0 : share;
  }

  /** @brief Whether the air of the smaller of two rooms is too narrow to stand in:
   * above shelves as high as a floor. */
  bool isOnFurniture(const RoomPair& pair) const
  {
    return std::min(depth_[pair.first], depth_[pair.second]) <=
           parameters_.deepest_shelf / 2;
  }

  bool joins(const RoomPair& pair, double share) const
  {
    const bool is_small =
        std::min(area_[pair.first], area_[pair.second]) < parameters_.smallest_room;
    return share > (is_small ? 0.3 : parameters_.least_open);
  }

  void joinAll()
  {
    std::map<RoomPair, double> openness;
    for (const auto& [pair, border] : borders_)
      openness[pair] = opennessOf(pair, border);
    while (true) {
      auto best = openness.end();
      for (auto it = openness.begin(); it != openness.end(); ++it)
        if (joins(it->first, it->second) &&
            (best == openness.end() || it->second > best->second))
          best = it;
      if (best == openness.end())
        break;
      join(best->first, openness);
    }
    for (std::int32_t& l : label_)
      if (l != no_room)
        l = static_cast<std::int32_t>(sets_.find(static_cast<std::uint32_t>(l)));
  }

  /** @brief Joins the second of two rooms to the first, and its borders. */
  void join(RoomPair joined, std::map<RoomPair, double>& openness)
  {
    const auto [a, b] = joined;
    sets_.join(a, b);
    area_[a] += area_[b];
    depth_[a] = std::max(depth_[a], depth_[b]);
    ends_[a] += ends_[b];
    floors_[a].add(floors_[b]);
    borders_.erase(joined);
    openness.erase(joined);
    std::vector<RoomPair> of_b;
    for (const std::uint32_t other : beside_[b])
      if (other != a)
        of_b.push_back({std::min(b, other), std::max(b, other)});
    beside_[a].erase(b);
    for (const RoomPair& pair : of_b) {
      const std::uint32_t other = pair.first == b ? pair.second : pair.first;
      const auto from = borders_.find(pair);
      Border moved = std::move(from->second);
      borders_.erase(from);
      openness.erase(pair);
      beside_[other].erase(b);
      beside_[other].insert(a);
      beside_[a].insert(other);
      Border& into = borderOf(a, other);
      for (Crossing c : moved.crossings) {
        if (roomOf(c.from) > roomOf(c.to))
          std::swap(c.from, c.to);
        into.crossings.push_back(c);
      }
      into.walls += moved.walls;
      into.stacked += moved.stacked;
    }
    beside_[b].clear();
    for (const std::uint32_t other : beside_[a]) {
      const RoomPair pair{std::min(a, other), std::max(a, other)};
      openness[pair] = opennessOf(pair, borders_[pair]);
    }
  }

  /** @brief Of the gaps of a column that are of one room the tallest stays: others are
   * below its stairs or above its furniture. */
  void keepHeightField(std::vector<std::int32_t>& room) const
  {
    for (std::uint32_t g = 0; g + 1 < air_.size(); ++g)
      for (std::uint32_t o = g + 1; o < air_.size() && air_[o].column == air_[g].column;
           ++o)
        if (room[g] != no_room && room[g] == room[o])
          room[air_.height(g) < air_.height(o) ? g : o] = no_room;
  }

  PartedAir result()
  {
    PartedAir parted;
    parted.rooms = area_.size();
    parted.room = std::move(label_);
    keepHeightField(parted.room);
    std::map<RoomPair, Border> borders;
    for (std::uint32_t g = 0; g < air_.size(); ++g)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air_.link(g, d);
        if (o == none || parted.room[g] == no_room || parted.room[o] == no_room)
          continue;
        const auto own = static_cast<std::uint32_t>(parted.room[g]);
        const auto other = static_cast<std::uint32_t>(parted.room[o]);
        if (own < other)
          borders[{own, other}].crossings.push_back({g, o});
      }
    label_ = parted.room;
    sets_ = DisjointSets(area_.size());
    for (const auto& [pair, border] : borders)
      for (const auto& crossings : openingsOf(border)) {
        RoomOpening opening = measure(crossings).opening;
        opening.a = pair.first;
        opening.b = pair.second;
        parted.openings.push_back(opening);
      }
    parted.is_reveal = revealsOf(air_, dip_, parameters_.lintel, parted.room);
    return parted;
  }

  const AirGaps& air_;
  const PartingParameters& parameters_;
  double cell_;
  std::vector<float> dip_;
  std::vector<float> free_; ///< distance from what ends the air, cells
  std::vector<std::int32_t> label_;
  std::vector<double> area_;         ///< of each label, square metres
  std::vector<std::size_t> ends_;    ///< of each label: where its air ends at walls
  std::vector<double> depth_;        ///< of each label: farthest from its rim, metres
  std::vector<HeightCounts> floors_; ///< of each label
  std::map<RoomPair, Border> borders_;
  std::vector<std::set<std::uint32_t>> beside_; ///< rooms with a border, of each
  DisjointSets sets_{0};                        ///< of labels that were joined
  std::vector<std::uint32_t> visited_;
  std::uint32_t round_ = 0;
};

} // namespace

PartedAir
partRooms(const AirGaps& air, const PartingParameters& parameters)
{
  return Parting(air, parameters).run();
}

} // namespace sedr
} // namespace pcl
