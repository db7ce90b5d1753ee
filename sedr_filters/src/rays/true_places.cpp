// SPDX-License-Identifier: BSD-3-Clause
#include "true_places.h"

#include "../base/parallel.h"
#include "direction_grid.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

using Place = std::tuple<float, float, float>;

Place
placeOf(const Eigen::Vector3f& p)
{
  return {p.x(), p.y(), p.z()};
}

/** @brief A place on a flat surface. */
struct Patch {
  Eigen::Vector3f place;
  Eigen::Vector3f normal;
};

/** @brief Finds what is flat, and dense in all directions, along rays. */
class PatchSearch {
public:
  explicit PatchSearch(const PiercedSurfaces& surfaces)
      : surfaces_(surfaces)
  {}

  /** @brief The first patch that a ray goes through, well before its end.
   * @return whether there is one */
  bool firstOn(const ScanRay& ray, Patch& patch) const
  {
    constexpr float step = 0.1F;
    const Eigen::Vector3f whole = ray.to - ray.from;
    const float length = whole.norm();
    const Eigen::Vector3f direction = whole / length;
    for (float along = clear; along < length - clear; along += step)
      if (patchAt(ray.from + along * direction, direction, patch) &&
          std::abs((ray.from - patch.place).dot(patch.normal)) > clear &&
          std::abs((ray.to - patch.place).dot(patch.normal)) > clear)
        return true;
    return false;
  }

private:
  static constexpr float clear = 0.4F; ///< metres before and behind a patch

  /** @brief The points within a radius of a place.
   * @return how many */
  template <typename See>
  std::size_t forEachNear(const Eigen::Vector3f& place, float radius, See see) const
  {
    std::size_t count = 0;
    const CubeTable& cubes = surfaces_.cubes();
    cubes.anyAround(cubes.at(place.cast<double>()), [&](std::uint32_t cube) {
      surfaces_.forEachPoint(cube, [&](const Eigen::Vector3f& p) {
        if ((p - place).squaredNorm() < radius * radius) {
          ++count;
          see(p);
        }
      });
      return false;
    });
    return count;
  }

  bool patchAt(const Eigen::Vector3f& place,
               const Eigen::Vector3f& direction,
               Patch& patch) const
  {
    constexpr float radius = 0.2F;     // metres
    constexpr std::size_t fewest = 16; // points
    constexpr float flat = 0.02F;      // metres, root of the mean square
    constexpr float nearest = 0.06F;   // metres from the place, along the ray
    constexpr float min_cosine = 0.5F; // a ray that grazes proves nothing
    if (surfaces_.cubes().findAt(place.cast<double>()) == CubeTable::none)
      return false;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    const std::size_t count =
        forEachNear(place, radius, [&](const Eigen::Vector3f& p) { sum += p - place; });
    if (count < fewest)
      return false;
    const Eigen::Vector3f mean = place + sum / static_cast<float>(count);
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    forEachNear(place, radius, [&](const Eigen::Vector3f& p) {
      squares += (p - mean) * (p - mean).transpose();
    });
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(squares / static_cast<float>(count));
    patch.normal = solver.eigenvectors().col(0);
    const float cosine = direction.dot(patch.normal);
    if (solver.eigenvalues()[0] > flat * flat || std::abs(cosine) < min_cosine)
      return false;
    const float along = (mean - place).dot(patch.normal) / cosine;
    patch.place = place + along * direction;
    return std::abs(along) <= nearest && isSurrounded(place, patch);
  }

  /** @brief Whether there are points on all sides of a patch's place. */
  bool isSurrounded(const Eigen::Vector3f& place, const Patch& patch) const
  {
    constexpr float radius = 0.15F; // metres
    constexpr int fewest = 7;       // of eight directions
    const Eigen::Vector3f u = patch.normal.unitOrthogonal();
    const Eigen::Vector3f v = patch.normal.cross(u);
    std::array<bool, 8> has{};
    forEachNear(place, radius, [&](const Eigen::Vector3f& p) {
      const double turn =
          std::atan2((p - patch.place).dot(v), (p - patch.place).dot(u)) / M_PI;
      has[static_cast<std::size_t>(std::clamp(4 * (turn + 1), 0.0, 7.0))] = true;
    });
    return std::count(has.begin(), has.end(), true) >= fewest;
  }

  const PiercedSurfaces& surfaces_;
};

/** @brief The rows of a scan that are said to be taken from one place, by direction. */
class RangeImage {
public:
  RangeImage(const Eigen::Vector3f& from,
             const PointView& rows,
             const std::vector<std::uint32_t>& seen)
      : from_(from)
      , rows_(rows)
      , grid_(DirectionGrid::forDirections(seen.size(), rows_a_cell))
      , first_(grid_.size() + 1, 0)
      , seen_(seen.size())
  {
    std::vector<std::uint32_t> cell_of;
    cell_of.reserve(seen.size());
    for (const std::uint32_t row : seen) {
      cell_of.push_back(static_cast<std::uint32_t>(
          grid_.cellOf((rows[row] - from).cast<double>().normalized())));
      ++first_[cell_of.back() + 1];
    }
    for (std::size_t k = 1; k < first_.size(); ++k)
      first_[k] += first_[k - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < seen.size(); ++k)
      seen_[next[cell_of[k]]++] = seen[k];
  }

  /** @brief Whether what was seen in the direction of a patch, on it and behind it, may
   * be seen through a pane. */
  bool mayBePane(const Patch& patch) const
  {
    constexpr double least = 0.02; // share of the rays that a pane returns
    constexpr double most = 0.5;
    constexpr double fullest = 2.5; // times as many rays as in other directions
    constexpr double enough = 100;  // rays that tell
    constexpr float on = 0.1F;      // metres
    const Eigen::Vector3f whole = patch.place - from_;
    const float before = whole.dot(patch.normal);
    const float radius = std::max(0.15F, 0.01F * whole.norm()); // metres
    std::size_t ended = 0;
    std::size_t through = 0;
    grid_.forEachAround(whole.cast<double>(), radius, [&](std::size_t cell) {
      for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
        const Eigen::Vector3f way = rows_[seen_[k]] - from_;
        const float share = way.dot(patch.normal) / before;
        if (!(share > 0) || (way / share - whole).squaredNorm() > radius * radius)
          continue;
        const float behind = (share - 1) * std::abs(before);
        if (std::abs(behind) < on)
          ++ended;
        else if (behind > 0)
          ++through;
      }
    });
    const auto all = static_cast<double>(ended + through);
    // As many as there would be if all directions had the same.
    const double solid_angle =
        M_PI * radius * radius * std::abs(before) / std::pow(whole.norm(), 3);
    const double usual = static_cast<double>(seen_.size()) * solid_angle / (4 * M_PI);
    return (static_cast<double>(ended) >= least * all || all < enough) &&
           static_cast<double>(ended) <= most * all && all <= fullest * usual + enough;
  }

private:
  static constexpr double rows_a_cell = 8;

  Eigen::Vector3f from_;
  const PointView& rows_;
  DirectionGrid grid_;
  std::vector<std::uint32_t> first_; ///< row of each cell, and the end
  std::vector<std::uint32_t> seen_;
};

/** @brief What is said to be taken from one place. */
struct Taken {
  Eigen::Vector3f from;
  std::vector<std::uint32_t> rows;
  std::vector<const ScanRay*> rays;
  bool is_true = true;
};

/** @brief Whether few of the rays from a place contradict it. */
bool
isTrue(const Taken& taken, const PatchSearch& patches, const PointView& rows)
{
  constexpr std::size_t enough = 1000; // rays
  constexpr double most = 0.02;        // of them, wrong
  constexpr std::size_t fewest = 5;    // wrong rays: fewer may be strays
  constexpr float shortest = 1.2F;     // metres, of a ray that tells something
  const RangeImage image(taken.from, rows, taken.rows);
  std::size_t looked_at = 0;
  std::size_t wrong = 0;
  const std::size_t stride = taken.rays.size() / enough + 1;
  for (std::size_t r = 0; r < taken.rays.size(); r += stride) {
    const ScanRay& ray = *taken.rays[r];
    if ((ray.to - ray.from).norm() < shortest)
      continue;
    ++looked_at;
    Patch patch;
    wrong += patches.firstOn(ray, patch) && !image.mayBePane(patch) ? 1 : 0;
  }
  return wrong < fewest ||
         static_cast<double>(wrong) <= most * static_cast<double>(looked_at);
}

} // namespace

std::vector<Eigen::Vector3f>
untruePlaces(const PiercedSurfaces& surfaces,
             const std::vector<ScanRay>& rays,
             const PointView& rows,
             std::size_t step,
             const ScanPositions& positions,
             unsigned threads)
{
  std::map<Place, std::size_t> number;
  std::vector<Taken> all;
  const auto numberOf = [&](const Eigen::Vector3f& from) {
    const auto [at, is_new] = number.emplace(placeOf(from), all.size());
    if (is_new)
      all.push_back({from, {}, {}});
    return at->second;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t position = positionOfRow(positions, i * step);
    if (position < positions.size() && positions[position].isKnown() &&
        rows.isFinite(i) && rows[i] != positions[position].place)
      all[numberOf(positions[position].place)].rows.push_back(
          static_cast<std::uint32_t>(i));
  }
  for (const ScanRay& ray : rays)
    all[numberOf(ray.from)].rays.push_back(&ray);
  const PatchSearch patches(surfaces);
  parallelBlocks(all.size(), 1, threads, [&](std::size_t k, std::size_t) {
    all[k].is_true = isTrue(all[k], patches, rows);
  });
  std::vector<Eigen::Vector3f> untrue;
  for (const Taken& taken : all)
    if (!taken.is_true)
      untrue.push_back(taken.from);
  return untrue;
}

} // namespace sedr
} // namespace pcl
