// SPDX-License-Identifier: BSD-3-Clause
#include "panes.h"

#include "../grids/disjoint_sets.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>

namespace pcl::sedr {

namespace {

constexpr double thickness = 0.03;      // metres, of a pane to either side
constexpr std::size_t fewest_rays = 3;  // through a cube
constexpr std::size_t fewest_cubes = 6; // of a pane: a third of a square metre

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
  all.reserve(regions.size());
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
    const auto& places = surfaces_.pointsOf(cube);
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
    const Eigen::Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]);
    if (normal.norm() < nearest * nearest / 2)
      return false;
    pane.normal = normal.normalized();
    pane.offset = pane.normal.dot(points[0]);
    return true;
  }

  std::vector<std::uint32_t> cubesOf(const Pane& pane) const
  {
    std::vector<std::uint32_t> cubes;
    std::copy_if(left_.begin(), left_.end(), std::back_inserter(cubes),
                 [&](std::uint32_t cube) {
                   const auto& places = surfaces_.pointsOf(cube);
                   return std::any_of(places.begin(), places.end(),
                                      [&](const auto& p) { return isOn(pane, p); });
                 });
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
      for (const Eigen::Vector3f& p : surfaces_.pointsOf(cube))
        if (isOn(pane, p)) {
          points.push_back(p.cast<double>());
          mean += points.back();
        }
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

} // namespace pcl::sedr
