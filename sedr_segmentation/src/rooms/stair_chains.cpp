// SPDX-License-Identifier: BSD-3-Clause
#include "stair_chains.h"

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief What is believed of stairs; metres. Building codes ask for rises of 0.14 to
 * 0.2 and goings of 0.22 to 0.37, on the line on which one walks. */
struct StairPriors {
  double min_rise = 0.12;
  double max_rise = 0.22;
  double min_going = 0.1; ///< of winders, near the newel
  double max_going = 0.45;
  double deepest = 0.55;    ///< of a tread; what is deeper is a landing
  double min_area = 0.02;   ///< square metres, of the part of a tread that was seen
  double clearance = 1.2;   ///< of the air above one
  double level = 0.025;     ///< a surface rises by less a cell or two
  double flatness = 0.02;   ///< standard deviation of its heights
  double rise_sigma = 0.02; ///< of the steps of a flight
  double going_sigma = 0.06;
  double turn_sigma = 0.6;  ///< radians a step
  double step_gain = 3;     ///< nats that the next step is worth against furniture
  double missing = 2.5;     ///< nats that a tread costs which was not seen
  int max_missing = 3;      ///< of treads that follow each other
  double floor_gain = 3;    ///< nats that the floor at an end of a chain is worth
  double chain_cost = 9;    ///< nats: a chain may begin anywhere
  double min_odds = 4;      ///< nats of a chain that is told
  double same_floor = 0.08; ///< metres between heights of one floor
  double near = 0.6;        ///< metres from the end of a flight to its floor, and from
                            ///< treads to their underside
  double straight = 0.25;   ///< radians that treads of a straight flight are off
  int max_unseen = 20;      ///< treads from the last one that was seen to a floor
};

constexpr StairPriors priors;

/** @brief The top of something in a fine column, with air above. */
struct Level {
  Cell cell;
  std::int32_t voxel = 0;
  bool is_riser = false; ///< it goes down, as a ramp does not
  double z = 0;
  std::size_t points = 0;
};

/** @brief A level patch: a tread, the upper edge of a riser above which the tread was
 * not seen, a landing, or the top of furniture. */
struct Patch {
  std::vector<Eigen::Vector2d> cells; ///< their middles
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero(); ///< of the cells, their sum
  double z = 0;
  Eigen::Vector2d edge = Eigen::Vector2d::Zero(); ///< middle of what is above risers
  std::size_t edge_cells = 0;
  bool is_tread = false;
  Eigen::AlignedBox2d box{};

  /** @brief How far along a direction its front lies: where its riser was seen, else
   * that of a rectangle or a wedge. */
  double front(const Eigen::Vector2d& way) const
  {
    if (edge_cells >= 8 && way.dot(edge - middle) < 0.03)
      return way.dot(edge);
    return way.dot(middle) -
           std::sqrt(3 * way.dot(scatter * way) / static_cast<double>(cells.size()));
  }
};

/** @brief The direction in which treads are shallow. */
Eigen::Vector2d
acrossTreads(const Eigen::Matrix2d& scatter, const Eigen::Vector2d& forwards)
{
  const Eigen::Vector2d way =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(0);
  return way.dot(forwards) < 0 ? -way : way;
}

/** @brief The main floors of rooms, by place: neither treads nor platforms. */
class RoomFloors {
public:
  explicit RoomFloors(const Building& building)
      : grid_(building.grid)
  {
    for (const BuildingRoom& room : building.rooms)
      for (const RoomColumn& c : room.columns)
        if (std::abs(c.floor - room.floor) < priors.same_floor)
          at_[keyOf(c.cell)].push_back({room.id, c.floor});
  }

  bool isFloor(const Eigen::Vector2d& place, double z) const
  {
    const auto found = at_.find(keyOf(grid_.at(place.x(), place.y())));
    return found != at_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const Floor& floor) {
                         return std::abs(floor.z - z) < priors.same_floor;
                       });
  }

  struct Floor {
    std::uint32_t room = 0; ///< 0: none
    double z = 0;
  };

  /** @brief The floor at a height near a place.
   * @param same metres that it may be off */
  Floor
  near(const Eigen::Vector2d& place, double z, double same = priors.same_floor) const
  {
    const int reach = static_cast<int>(std::ceil(priors.near / grid_.size()));
    const Cell middle = grid_.at(place.x(), place.y());
    Floor nearest;
    double least = priors.near;
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy) {
        const Cell cell{middle.x + dx, middle.y + dy};
        const auto found = at_.find(keyOf(cell));
        const double away = (grid_.centre(cell) - place).norm();
        if (found == at_.end() || away > least)
          continue;
        for (const Floor& floor : found->second)
          if (std::abs(floor.z - z) < same) {
            nearest = floor;
            least = away;
          }
      }
    return nearest;
  }

private:
  CellGrid grid_;
  std::unordered_map<CellKey, std::vector<Floor>> at_;
};

/** @brief The level patches of a scan that are no floors of rooms, from below. */
class LevelPatches {
public:
  LevelPatches(const PointView& points,
               const std::vector<int>& indices,
               const VoxelColumns& fine,
               const RoomFloors& floors)
      : fine_(fine)
      , first_(fine.size() + 1, 0)
  {
    findLevels(floors);
    measureHeights(points, indices);
  }

  std::vector<Patch> find() const
  {
    // At a corner of a tread eight of the 24 cells around are level with it, at the end
    // of a riser's upper edge two; some were not seen.
    std::vector<std::uint8_t> is_core(levels_.size(), 0);
    for (std::uint32_t k = 0; k < levels_.size(); ++k) {
      int level = 0;
      forEachBeside(k, [&](std::uint32_t) { ++level; });
      is_core[k] = level >= (levels_[k].is_riser ? 3 : 6) ? 1 : 0;
    }
    DisjointSets<> sets(levels_.size());
    for (std::uint32_t k = 0; k < levels_.size(); ++k)
      if (is_core[k] != 0)
        forEachBeside(k, [&](std::uint32_t o) {
          if (is_core[o] != 0)
            sets.join(k, o);
        });
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
    for (std::uint32_t k = 0; k < levels_.size(); ++k)
      if (is_core[k] != 0)
        members[sets.find(k)].push_back(k);
    std::vector<Patch> patches;
    for (const auto& entry : members)
      addPatch(entry.second, patches);
    std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) {
      return std::tuple(a.z, a.middle.x(), a.middle.y()) <
             std::tuple(b.z, b.middle.x(), b.middle.y());
    });
    return patches;
  }

private:
  void findLevels(const RoomFloors& floors)
  {
    const auto clear =
        static_cast<std::int32_t>(std::lround(priors.clearance / fine_.voxelHeight()));
    const auto rise =
        static_cast<std::int32_t>(std::ceil(priors.min_rise / fine_.voxelHeight()));
    for (std::uint32_t c = 0; c < fine_.size(); ++c) {
      bool has_top = false;
      bool is_riser = false;
      std::int32_t top = 0;
      fine_.forEachRun(c, [&](std::int32_t begin, std::int32_t end) {
        if (has_top && begin - top >= clear) {
          const Cell cell = fine_.cellOf(c);
          const double z = fine_.heightOf(top) - fine_.voxelHeight() / 2;
          if (!floors.isFloor(fine_.grid().centre(cell), z))
            levels_.push_back({cell, top - 1, is_riser});
        }
        has_top = true;
        is_riser = end - begin >= rise;
        top = end;
      });
      first_[c + 1] = static_cast<std::uint32_t>(levels_.size());
    }
  }

  /** @brief Gives each level the mean height of its points. */
  void measureHeights(const PointView& points, const std::vector<int>& indices)
  {
    const std::size_t n = indices.empty() ? points.size() : indices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
      const Eigen::Vector3f p = points[i];
      if (!points.isFinite(i) || !fine_.grid().holds(p.x(), p.y()))
        continue;
      const std::uint32_t c = fine_.columnAt(fine_.grid().at(p.x(), p.y()));
      if (c == VoxelColumns::none)
        continue;
      for (std::uint32_t l = first_[c]; l < first_[c + 1]; ++l)
        if (fine_.voxelAt(p.z()) == levels_[l].voxel) {
          levels_[l].z += p.z();
          ++levels_[l].points;
        }
    }
    for (Level& level : levels_)
      level.z = level.points == 0 ? fine_.heightOf(level.voxel)
                                  : level.z / static_cast<double>(level.points);
  }

  /** @brief Calls `visit` for the levels at most two cells from one and as high. */
  template <typename Visitor>
  void forEachBeside(std::uint32_t k, Visitor visit) const
  {
    constexpr int reach = 2; // cells
    const Level& level = levels_[k];
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy) {
        const std::uint32_t c = fine_.columnAt({level.cell.x + dx, level.cell.y + dy});
        if (c == VoxelColumns::none)
          continue;
        for (std::uint32_t l = first_[c]; l < first_[c + 1]; ++l)
          if (l != k && std::abs(levels_[l].z - level.z) <= priors.level)
            visit(l);
      }
  }

  void addPatch(const std::vector<std::uint32_t>& members,
                std::vector<Patch>& patches) const
  {
    const double cell = fine_.cellSize();
    const auto n = static_cast<double>(members.size());
    if (n * cell * cell < priors.min_area)
      return;
    Patch patch;
    double squares = 0;
    for (const std::uint32_t k : members) {
      patch.cells.push_back(fine_.grid().centre(levels_[k].cell));
      patch.middle += patch.cells.back() / n;
      patch.z += levels_[k].z / n;
      patch.box.extend(patch.cells.back());
      if (levels_[k].is_riser) {
        patch.edge += patch.cells.back();
        ++patch.edge_cells;
      }
    }
    for (const std::uint32_t k : members) {
      const Eigen::Vector2d d = fine_.grid().centre(levels_[k].cell) - patch.middle;
      patch.scatter += d * d.transpose();
      squares += std::pow(levels_[k].z - patch.z, 2) / n;
    }
    if (squares > priors.flatness * priors.flatness)
      return; // a ramp, cushions
    patch.edge /= std::max(1.0, static_cast<double>(patch.edge_cells));
    const double depth = std::sqrt(
        12 / n *
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(patch.scatter).eigenvalues()[0]);
    patch.is_tread = depth <= priors.deepest;
    patches.push_back(std::move(patch));
  }

  const VoxelColumns& fine_;
  std::vector<std::uint32_t> first_; ///< of the levels of a column
  std::vector<Level> levels_;
};

/** @brief A step from one patch up to another, also over treads that nobody saw. */
struct Step {
  std::size_t from = 0;
  std::size_t to = 0;
  int steps = 1;
  double rise = 0;                                ///< of each, metres
  Eigen::Vector2d way = Eigen::Vector2d::UnitX(); ///< its direction in plan
  double going = 0;                               ///< of each, metres
  bool is_on_treads = false;                      ///< both ends are treads
  double odds = 0;            ///< of the best chain up to here, nats
  std::ptrdiff_t before = -1; ///< the step before it there
};

/** @brief Chains of patches, each a step above the one before. */
class StairChains {
public:
  StairChains(const std::vector<Patch>& patches, const RoomFloors& floors, double cell)
      : patches_(patches)
      , floors_(floors)
      , cell_(cell)
      , is_used_(patches.size(), 0)
  {
    for (std::size_t a = 0; a < patches.size(); ++a)
      for (std::size_t b = a + 1;
           b < patches.size() &&
           patches[b].z - patches[a].z <= (priors.max_missing + 1) * priors.max_rise;
           ++b)
        for (int steps = 1; steps <= priors.max_missing + 1; ++steps)
          addStep(a, b, steps);
    // Patches are by height: of the steps up to a place all before it are known.
    std::stable_sort(steps_.begin(), steps_.end(),
                     [](const Step& a, const Step& b) { return a.to < b.to; });
  }

  /** @brief The best chain of patches that no other has; empty if none is likely. */
  std::vector<Step> next()
  {
    std::vector<std::vector<std::size_t>> arriving(patches_.size());
    double most = priors.min_odds;
    std::ptrdiff_t last = -1;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      Step& step = steps_[k];
      if (is_used_[step.from] != 0 || is_used_[step.to] != 0)
        continue;
      const double own = priors.step_gain - priors.missing * (step.steps - 1);
      step.odds = own - priors.chain_cost + floorGain(step, true);
      step.before = -1;
      for (const std::size_t o : arriving[step.from])
        if (const double odds = own + steps_[o].odds - change(steps_[o], step);
            odds > step.odds) {
          step.odds = odds;
          step.before = static_cast<std::ptrdiff_t>(o);
        }
      arriving[step.to].push_back(k);
      if (const double odds = step.odds + floorGain(step, false); odds > most) {
        most = odds;
        last = static_cast<std::ptrdiff_t>(k);
      }
    }
    std::vector<Step> chain;
    for (; last >= 0; last = steps_[static_cast<std::size_t>(last)].before)
      chain.push_back(steps_[static_cast<std::size_t>(last)]);
    std::reverse(chain.begin(), chain.end());
    for (const Step& step : chain)
      for (const std::size_t tread : {step.from, step.to})
        for (std::size_t p = 0; p < patches_.size(); ++p)
          if (p == tread || isUnderside(patches_[p], patches_[tread]))
            is_used_[p] = 1;
    return chain;
  }

private:
  /** @brief Whether a patch may be the underside of a flight, where its treads were not
   * seen. */
  static bool isUnderside(const Patch& patch, const Patch& tread)
  {
    return patch.is_tread && std::abs(patch.z - tread.z) < priors.near &&
           (patch.middle - tread.middle).norm() < priors.near;
  }

  void addStep(std::size_t a, std::size_t b, int steps)
  {
    const Patch& from = patches_[a];
    const Patch& to = patches_[b];
    Step step{a, b, steps, (to.z - from.z) / steps};
    const double reach = 3 * cell_ + steps * priors.max_going;
    if (step.rise < priors.min_rise || step.rise > priors.max_rise ||
        from.box.exteriorDistance(to.box) > reach ||
        (steps > 1 && !(from.is_tread && to.is_tread)))
      return;
    step.is_on_treads = from.is_tread && to.is_tread;
    step.way = step.is_on_treads && steps == 1
                   ? acrossTreads(from.scatter + to.scatter, to.middle - from.middle)
                   : (to.middle - from.middle).normalized();
    step.going = (to.front(step.way) - from.front(step.way)) / steps;
    if (step.is_on_treads &&
        (step.going < priors.min_going || step.going > priors.max_going))
      return;
    for (int k = 1; k < steps; ++k) // a floor ends a stair
      if (floors_
              .near(from.middle + k * (to.middle - from.middle) / steps,
                    from.z + k * step.rise)
              .room != 0)
        return;
    for (const Eigen::Vector2d& p : from.cells)
      for (const Eigen::Vector2d& q : to.cells)
        if ((p - q).squaredNorm() <= reach * reach) {
          steps_.push_back(step);
          return;
        }
  }

  /** @brief Nats that a change of rise, going and direction costs. */
  static double change(const Step& a, const Step& b)
  {
    double squares = std::pow((b.rise - a.rise) / priors.rise_sigma, 2);
    if (a.is_on_treads && b.is_on_treads) {
      const double turn =
          std::atan2(a.way.x() * b.way.y() - a.way.y() * b.way.x(), a.way.dot(b.way));
      squares += std::pow((b.going - a.going) / priors.going_sigma, 2) +
                 std::pow(turn / priors.turn_sigma, 2) / std::max(a.steps, b.steps);
    }
    return squares / 2;
  }

  double floorGain(const Step& step, bool is_foot) const
  {
    const Patch& patch = patches_[is_foot ? step.from : step.to];
    const double sign = is_foot ? -1 : 1;
    for (const int away : {1, 2})
      if (!patch.is_tread ||
          floors_.near(patch.middle + sign * away * priors.max_going * step.way,
                       patch.z + sign * away * step.rise)
                  .room != 0)
        return priors.floor_gain;
    return 0;
  }

  const std::vector<Patch>& patches_;
  const RoomFloors& floors_;
  double cell_;
  std::vector<std::uint8_t> is_used_;
  std::vector<Step> steps_; ///< by where they lead to
};

/** @brief A tread that was seen. */
struct Tread {
  double number = 0; ///< in its flight, from 0
  const Patch* patch = nullptr;
  Eigen::Vector2d way; ///< of the step to it, of the first: from it
};

/** @brief Three quarters of the values are no larger. */
double
upperQuartile(std::vector<double> values)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(3 * values.size() / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** @brief Least squares: the value at 0 and the slope of values of treads, those that
 * were seen from above weigh more than the edges of risers. */
std::array<double, 2>
lineThrough(const std::vector<Tread>& treads, const std::vector<double>& values)
{
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const Patch& patch = *treads[k].patch;
    const auto weight = static_cast<double>(patch.cells.size() - patch.edge_cells + 1);
    const Eigen::Vector2d row(1, treads[k].number);
    normal += weight * row * row.transpose();
    right += weight * values[k] * row;
  }
  const Eigen::Vector2d line = normal.inverse() * right;
  return {line[0], line[1]};
}

Eigen::Vector2d
leftOf(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
}

/** @brief The riser before the first of a flight or after its last, as it runs and
 * turns there. */
PlanFlight::Riser
nextRiser(const PlanFlight& flight, bool is_foot)
{
  const std::size_t last = flight.steps() - 1;
  const std::size_t end = is_foot ? 0 : last;
  const std::size_t inner = is_foot ? 1 : last - 1;
  const Eigen::Vector2d middle = flight.middle(end);
  const Eigen::Vector2d a = flight.risers[inner][0] - flight.risers[inner][1];
  const Eigen::Vector2d b = flight.risers[end][0] - flight.risers[end][1];
  const Eigen::Rotation2Dd turn(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  PlanFlight::Riser next = flight.risers[end];
  for (Eigen::Vector2d& corner : next)
    corner = middle + turn * (corner - flight.middle(inner));
  return next;
}

/** @brief The flight of treads that follow each other. Risers are where the fronts of
 * the treads lie: of a straight flight in the mean, at equal distances. */
PlanFlight
flightOf(std::vector<Tread> treads, double cell)
{
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  std::vector<double> heights;
  for (const Tread& tread : treads) {
    scatter += tread.patch->scatter;
    heights.push_back(tread.patch->z);
  }
  const Eigen::Vector2d mean =
      acrossTreads(scatter, treads.back().patch->middle - treads.front().patch->middle);
  const auto angleTo = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  };
  const bool is_straight =
      std::all_of(treads.begin(), treads.end(), [&](const Tread& tread) {
        return std::abs(angleTo(mean, tread.way)) < priors.straight;
      });
  // Treads that turn do so from riser to riser; the first one has no riser before it.
  double turn = 0;
  for (std::size_t k = 2; k < treads.size() && !is_straight; ++k)
    turn += angleTo(treads[k - 1].way, treads[k].way);
  turn /= std::max(1.0, treads.back().number -
                            treads[std::min<std::size_t>(1, treads.size() - 1)].number);
  treads.front().way = Eigen::Rotation2Dd(-turn) * treads.front().way;
  std::vector<double> fronts;
  std::vector<double> left;
  std::vector<double> right;
  for (Tread& tread : treads) {
    if (is_straight)
      tread.way = mean;
    const Eigen::Vector2d across = leftOf(tread.way);
    fronts.push_back(tread.patch->front(tread.way));
    const double origin = is_straight ? 0 : across.dot(tread.patch->middle);
    double most = -std::numeric_limits<double>::infinity();
    double least = -most;
    for (const Eigen::Vector2d& c : tread.patch->cells) {
      most = std::max(most, across.dot(c) - origin);
      least = std::min(least, across.dot(c) - origin);
    }
    left.push_back(most + cell / 2);
    right.push_back(cell / 2 - least);
  }
  PlanFlight flight;
  const auto [z, rise] = lineThrough(treads, heights);
  flight.bottom = z - rise;
  flight.rise = rise;
  const auto [first, going] = lineThrough(treads, fronts);
  const auto add = [&](const Eigen::Vector2d& at, const Eigen::Vector2d& way) {
    flight.risers.push_back({at + upperQuartile(left) * leftOf(way),
                             at - upperQuartile(right) * leftOf(way)});
  };
  const auto last = static_cast<std::size_t>(treads.back().number) + 1;
  if (is_straight) {
    for (std::size_t k = 0; k <= last; ++k)
      add((first + static_cast<double>(k) * going) * mean, mean);
    return flight;
  }
  // Each riser is as wide as the treads beside it are there.
  constexpr double beside = 0.12; // metres
  const auto riserOf = [&](std::size_t k) -> PlanFlight::Riser {
    const Eigen::Vector2d& way = treads[k].way;
    const Eigen::Vector2d& middle = treads[k].patch->middle;
    const Eigen::Vector2d at = middle + (fronts[k] - way.dot(middle)) * way;
    double most = 0;
    double least = 0;
    for (std::size_t tread = k == 0 ? 0 : k - 1; tread <= k; ++tread)
      for (const Eigen::Vector2d& c : treads[tread].patch->cells)
        if (std::abs(way.dot(c - at)) < beside) {
          most = std::max(most, leftOf(way).dot(c - at) + cell / 2);
          least = std::min(least, leftOf(way).dot(c - at) - cell / 2);
        }
    return {at + most * leftOf(way), at + least * leftOf(way)};
  };
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const PlanFlight::Riser riser = riserOf(k);
    const double steps = k == 0 ? 1 : treads[k].number - treads[k - 1].number;
    for (int n = 1; n < steps; ++n) { // those between that nobody saw
      const PlanFlight::Riser before = riserOf(k - 1);
      flight.risers.push_back({before[0] + n / steps * (riser[0] - before[0]),
                               before[1] + n / steps * (riser[1] - before[1])});
    }
    flight.risers.push_back(riser);
  }
  flight.risers.push_back(nextRiser(flight, false));
  return flight;
}

/** @brief The flights of a chain, which landings part. */
std::vector<PlanFlight>
flightsOf(const std::vector<Step>& chain,
          const std::vector<Patch>& patches,
          double cell)
{
  std::vector<PlanFlight> flights;
  std::vector<Tread> treads;
  const auto close = [&] {
    if (treads.size() > 1)
      flights.push_back(flightOf(std::move(treads), cell));
    treads.clear();
  };
  if (patches[chain.front().from].is_tread)
    treads.push_back({0, &patches[chain.front().from], chain.front().way});
  for (const Step& step : chain) {
    const Patch& to = patches[step.to];
    if (!to.is_tread)
      close();
    else if (treads.empty())
      treads.push_back({0, &to, step.way});
    else {
      if (treads.size() == 1)
        treads.front().way = step.way;
      treads.push_back({treads.back().number + step.steps, &to, step.way});
    }
  }
  close();
  return flights;
}

/** @brief Leads a flight on, as it runs and turns, to the floor at its foot or its
 * head, over treads that nobody saw.
 * @return the floor; none: the flight stays as it is */
RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot)
{
  PlanFlight longer = flight;
  for (int missing = 0; missing <= priors.max_unseen; ++missing) {
    const PlanFlight::Riser next = nextRiser(longer, is_foot);
    const RoomFloors::Floor floor =
        floors.near((next[0] + next[1]) / 2, is_foot ? longer.bottom : longer.top(),
                    (missing == 0 ? 1 : 0.6) * priors.same_floor);
    if (floor.room != 0) {
      flight = longer;
      return floor;
    }
    auto& risers = longer.risers;
    risers.insert(is_foot ? risers.begin() : risers.end(), next);
    longer.bottom -= is_foot ? longer.rise : 0;
  }
  return {};
}

/** @brief Gives a flight the rise that equal steps between two floors have. A straight
 * one gets as many as fit best: treads that were not seen may have been miscounted. */
void
fitBetween(double bottom, double top, PlanFlight& flight)
{
  const auto steps =
      static_cast<std::size_t>(std::max(2L, std::lround((top - bottom) / flight.rise)));
  const Eigen::Vector2d first = flight.risers.front()[0] - flight.risers.front()[1];
  const Eigen::Vector2d last = flight.risers.back()[0] - flight.risers.back()[1];
  const bool is_straight = last.isApprox(first, 1e-6);
  if (is_straight && steps != flight.steps()) {
    const std::vector<PlanFlight::Riser> old = flight.risers;
    flight.risers.resize(steps);
    for (std::size_t k = 0; k < steps; ++k)
      for (std::size_t side = 0; side < 2; ++side)
        flight.risers[k][side] =
            old.front()[side] + static_cast<double>(k) /
                                    static_cast<double>(steps - 1) *
                                    (old.back()[side] - old.front()[side]);
  }
  flight.bottom = bottom;
  flight.rise = (top - bottom) / static_cast<double>(flight.steps());
}

/** @brief Adds flights to the nearest link between the floors that they join, or as a
 * new one. Others between these floors are then edges of the void that it leads
 * through, and go. */
void
addStair(std::vector<PlanFlight>&& flights,
         const std::array<std::uint32_t, 2>& rooms,
         std::vector<PlanStair>& stairs)
{
  constexpr double near = 2; // metres in plan from a link's opening
  const double bottom = flights.front().bottom;
  const double top = flights.back().top();
  const auto distanceOf = [&](const PlanStair& stair) {
    double away = std::numeric_limits<double>::infinity();
    for (const PlanFlight& flight : flights)
      for (std::size_t k = 0; k < flight.steps(); ++k)
        away = std::min(away, (flight.middle(k) - stair.at).norm());
    return away;
  };
  const auto isBeside = [&](const PlanStair& stair) {
    return stair.flights.empty() && std::abs(stair.bottom - bottom) < near / 4 &&
           std::abs(stair.top - top) < near / 4 && distanceOf(stair) < near;
  };
  PlanStair stair{rooms, flights.back().middle(flights.back().steps() - 1), bottom,
                  top};
  double nearest = near;
  for (const PlanStair& link : stairs)
    if (isBeside(link) && distanceOf(link) < nearest) {
      nearest = distanceOf(link);
      stair.rooms = link.rooms;
      stair.at = link.at;
    }
  stairs.erase(std::remove_if(stairs.begin(), stairs.end(), isBeside), stairs.end());
  stair.flights = std::move(flights);
  stairs.push_back(std::move(stair));
}

} // namespace

void
addFlights(const PointView& points,
           const std::vector<int>& indices,
           const VoxelColumns& fine,
           Building& building)
{
  constexpr double widest_cell = 0.1; // metres
  if (fine.cellSize() > widest_cell)
    return;
  const RoomFloors floors(building);
  const std::vector<Patch> patches = LevelPatches(points, indices, fine, floors).find();
  StairChains chains(patches, floors, fine.cellSize());
  for (std::vector<Step> chain = chains.next(); !chain.empty(); chain = chains.next()) {
    std::vector<PlanFlight> flights = flightsOf(chain, patches, fine.cellSize());
    if (flights.empty())
      continue;
    const RoomFloors::Floor foot = leadToFloor(flights.front(), floors, true);
    const RoomFloors::Floor head = leadToFloor(flights.back(), floors, false);
    if (flights.size() == 1 && foot.room != 0 && head.room != 0) {
      fitBetween(foot.z, head.z, flights[0]);
    }
    addStair(std::move(flights), {foot.room, head.room}, building.stairs);
  }
}

} // namespace pcl::sedr
