// SPDX-License-Identifier: BSD-3-Clause
#include "mirror_panes.h"

#include "../grids/disjoint_sets.h"
#include <pcl/sedr_filters/parallel.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace pcl {
namespace sedr {

namespace {

constexpr double thickness = 0.03;        // metres, of a pane to either side
constexpr std::size_t fewest_rays = 3;    // through a cube
constexpr std::size_t fewest_cubes = 6;   // of a pane: a third of a square metre

/** @brief The cubes that several rays went through, by the regions that they make, the
 * numbers in each increasing. */
std::vector<std::vector<std::uint32_t>>
piercedRegions(const CubeTable& cubes, const std::vector<std::uint32_t>& pierced)
{
  std::vector<std::size_t> rays(cubes.size(), 0);
  for (const std::uint32_t cube : pierced)
    if (cube != CubeTable::none)
      ++rays[cube];
  DisjointSets<> sets(cubes.size());
  for (std::uint32_t k = 0; k < cubes.size(); ++k)
    if (rays[k] >= fewest_rays)
      cubes.anyAround(cubes[k], [&](std::uint32_t other) {
        if (rays[other] >= fewest_rays)
          sets.join(k, other);
        return false;
      });
  std::map<std::uint32_t, std::vector<std::uint32_t>> regions;
  for (std::uint32_t k = 0; k < cubes.size(); ++k)
    if (rays[k] >= fewest_rays)
      regions[sets.find(k)].push_back(k);
  std::vector<std::vector<std::uint32_t>> all;
  for (auto& region : regions)
    all.push_back(std::move(region.second));
  return all;
}

/** @brief Takes planes out of the cubes of a region, the largest first. */
class PaneSearch {
public:
  PaneSearch(const PiercedSurfaces& surfaces, std::vector<std::uint32_t> region)
      : surfaces_(surfaces)
      , left_(std::move(region))
  {}

  std::vector<Pane> run()
  {
    std::vector<Pane> panes;
    while (left_.size() >= fewest_cubes) {
      Pane best;
      constexpr int trials = 60;
      for (int k = 0; k < trials; ++k) {
        Pane pane;
        if (!throughThree(pane))
          continue;
        pane.cubes = cubesOf(pane);
        if (pane.cubes.size() > best.cubes.size())
          best = std::move(pane);
      }
      if (best.cubes.size() < fewest_cubes)
        return panes;
      refine(best);
      std::vector<std::uint32_t> rest;
      std::set_difference(left_.begin(), left_.end(), best.cubes.begin(),
                          best.cubes.end(), std::back_inserter(rest));
      left_ = std::move(rest);
      panes.push_back(std::move(best));
    }
    return panes;
  }

private:
  /** @brief A point of a cube of the region, which the random number chooses. */
  Eigen::Vector3d anyPointOf(std::uint32_t cube)
  {
    std::vector<Eigen::Vector3f> places;
    surfaces_.forEachPoint(cube, [&](const auto& p) { places.push_back(p); });
    return places[random_() % places.size()].cast<double>();
  }

  /** @brief The plane through three points that are 0.4 to 1.5 m apart.
   * @return false where chance has found none */
  bool throughThree(Pane& pane)
  {
    constexpr double nearest = 0.4;
    constexpr double farthest = 1.5;
    constexpr int tries = 30;
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < tries && points.size() < 3; ++k) {
      const Eigen::Vector3d p = anyPointOf(left_[random_() % left_.size()]);
      const bool fits = std::all_of(points.begin(), points.end(), [&](const auto& q) {
        return (p - q).norm() > nearest && (p - q).norm() < farthest;
      });
      if (fits)
        points.push_back(p);
    }
    if (points.size() < 3)
      return false;
    const Eigen::Vector3d normal =
        (points[1] - points[0]).cross(points[2] - points[0]);
    if (normal.norm() < nearest * nearest / 2)
      return false;
    pane.normal = normal.normalized();
    pane.offset = pane.normal.dot(points[0]);
    return true;
  }

  std::vector<std::uint32_t> cubesOf(const Pane& pane) const
  {
    std::vector<std::uint32_t> cubes;
    for (const std::uint32_t cube : left_) {
      bool is_on = false;
      surfaces_.forEachPoint(cube, [&](const Eigen::Vector3f& p) {
        is_on = is_on || isOn(pane, p);
      });
      if (is_on)
        cubes.push_back(cube);
    }
    return cubes;
  }

  static bool isOn(const Pane& pane, const Eigen::Vector3f& p)
  {
    return std::abs(pane.normal.dot(p.cast<double>()) - pane.offset) < thickness;
  }

  /** @brief Least squares through the points on a pane. */
  void refine(Pane& pane) const
  {
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::uint32_t cube : pane.cubes)
      surfaces_.forEachPoint(cube, [&](const Eigen::Vector3f& p) {
        if (isOn(pane, p)) {
          points.push_back(p.cast<double>());
          mean += points.back();
        }
      });
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : points)
      squares += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
    pane.normal = solver.eigenvectors().col(0);
    pane.offset = pane.normal.dot(mean);
  }

  const PiercedSurfaces& surfaces_;
  std::vector<std::uint32_t> left_; ///< cubes, increasing
  std::mt19937 random_{1};
};

bool
isFilledNear(const CubeTable& filled, const Eigen::Vector3d& p)
{
  return filled.anyAround(filled.at(p), [](std::uint32_t) { return true; });
}

/** @brief What was met behind a pane at places that say something: their like elsewhere
 * is not there by chance, as that of a floor behind an upright pane would be. */
std::vector<Eigen::Vector3d>
tellingPlaces(const Pane& pane,
              const std::vector<Eigen::Vector3d>& behind,
              const CubeTable& filled)
{
  constexpr double aside = 0.5; // metres
  std::vector<Eigen::Vector3d> telling;
  for (const Eigen::Vector3d& p : behind)
    if (!isFilledNear(filled, p + aside * pane.normal) &&
        !isFilledNear(filled, p - aside * pane.normal))
      telling.push_back(p);
  return telling;
}

/** @brief How much of what is met behind a pane has its like in front of it. */
struct Likeness {
  double share = 0;  ///< at best
  double chance = 0; ///< the same of planes beside it, on average

  /** @brief 0 where it is what planes beside the pane have too, 1 where it is all. */
  double beyondChance() const
  {
    return chance < 1 ? (share - chance) / (1 - chance) : 0;
  }
};

/** @brief Share of places that have their like in front of a pane: the mean of those of
 * layers at different depths, so that one wall there that happens to be as far from the
 * pane as one here is not enough. */
double
mirroredShare(const Pane& pane,
              const std::vector<Eigen::Vector3d>& places,
              const CubeTable& filled)
{
  constexpr double layer = 0.5;     // metres
  constexpr std::size_t fewest = 8; // places of a layer
  struct Layer {
    std::size_t places = 0;
    std::size_t mirrored = 0;
  };
  std::map<long, Layer> layers;
  for (const Eigen::Vector3d& p : places) {
    Layer& at = layers[std::lround((pane.normal.dot(p) - pane.offset) / layer)];
    ++at.places;
    at.mirrored += isFilledNear(filled, pane.imageOf(p)) ? 1 : 0;
  }
  double sum = 0;
  std::size_t counted = 0;
  for (const auto& [depth, at] : layers)
    if (at.places >= fewest) {
      sum += static_cast<double>(at.mirrored) / static_cast<double>(at.places);
      ++counted;
    }
  return counted > 0 ? sum / static_cast<double>(counted) : 0;
}

/** @brief Moves a pane, whose normal points away from the scanner, to where it mirrors
 * most: it may stand behind its wall's face. */
Likeness
moveToMirror(Pane& pane,
             const std::vector<Eigen::Vector3d>& behind,
             const CubeTable& filled)
{
  constexpr std::size_t fewest = 30;
  constexpr double step = 0.05; // metres
  constexpr int before = -1;    // steps
  constexpr int after = 6;
  constexpr int beside = 10; // too far for the same pane
  constexpr int farthest = 20;
  const std::vector<Eigen::Vector3d> telling = tellingPlaces(pane, behind, filled);
  Likeness likeness;
  if (telling.size() < fewest)
    return likeness;
  const double offset = pane.offset;
  const auto shareAt = [&](int k) {
    Pane moved = pane;
    moved.offset = offset + k * step;
    return mirroredShare(moved, telling, filled);
  };
  for (int k = before; k <= after; ++k) {
    const double share = shareAt(k);
    if (share <= likeness.share)
      continue;
    likeness.share = share;
    pane.offset = offset + k * step;
  }
  for (int k = beside; k <= farthest; ++k)
    for (const int side : {-1, 1})
      likeness.chance += shareAt(side * k) / (2 * (farthest - beside + 1));
  return likeness;
}

} // namespace

std::vector<Pane>
panesOf(const PiercedSurfaces& surfaces, const std::vector<std::uint32_t>& pierced)
{
  std::vector<Pane> panes;
  for (auto& region : piercedRegions(surfaces.cubes(), pierced))
    for (Pane& pane : PaneSearch(surfaces, std::move(region)).run())
      panes.push_back(std::move(pane));
  return panes;
}

std::vector<Pane>
mirrorsAmong(std::vector<Pane> panes,
             const PiercedSurfaces& surfaces,
             const std::vector<ScanRay>& rays,
             const std::vector<std::uint32_t>& pierced,
             const CubeTable& filled,
             unsigned threads)
{
  constexpr double least_likeness = 0.5;
  constexpr double least_depth = 0.6; // metres: nearer to a pane all is like itself
  constexpr std::size_t enough = 3000; // places behind a pane
  std::vector<std::uint32_t> pane_of(surfaces.cubes().size(), CubeTable::none);
  for (std::uint32_t k = 0; k < panes.size(); ++k)
    for (const std::uint32_t cube : panes[k].cubes)
      pane_of[cube] = k;
  std::vector<std::vector<Eigen::Vector3d>> behind(panes.size());
  std::vector<long> away(panes.size(), 0); // rays along the normal less those against it
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const std::uint32_t k = pierced[r] == CubeTable::none ? CubeTable::none
                                                          : pane_of[pierced[r]];
    if (k == CubeTable::none || !panes[k].parts(rays[r], least_depth))
      continue;
    behind[k].push_back(rays[r].to.cast<double>());
    away[k] += panes[k].normal.dot((rays[r].to - rays[r].from).cast<double>()) > 0 ? 1 : -1;
  }
  for (std::size_t k = 0; k < panes.size(); ++k)
    if (away[k] < 0) {
      panes[k].normal = -panes[k].normal;
      panes[k].offset = -panes[k].offset;
    }
  std::vector<Likeness> likeness(panes.size());
  parallelBlocks(panes.size(), 1, threads, [&](std::size_t k, std::size_t) {
    std::vector<Eigen::Vector3d> some;
    for (std::size_t i = 0; i < behind[k].size(); i += behind[k].size() / enough + 1)
      some.push_back(behind[k][i]);
    likeness[k] = moveToMirror(panes[k], some, filled);
  });
  std::vector<Pane> mirrors;
  for (std::size_t k = 0; k < panes.size(); ++k)
    if (likeness[k].beyondChance() >= least_likeness)
      mirrors.push_back(std::move(panes[k]));
  return mirrors;
}

} // namespace sedr
} // namespace pcl
