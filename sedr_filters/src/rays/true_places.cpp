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

namespace pcl::sedr {

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
    const float first = std::max(clear, surfaces_.entryOf(ray));
    // Far from 0, a step may be less than floats resolve.
    for (float along = first; along < length - clear;
         along = std::max(along + step, std::nextafter(along, length)))
      if (patchAt(ray.from + along * direction, direction, patch) &&
          std::abs((ray.from - patch.place).dot(patch.normal)) > clear &&
          std::abs((ray.to - patch.place).dot(patch.normal)) > clear)
        return true;
    return false;
  }

  /** @brief Whether a place is on a surface, as the corner of a room that is taken for
   * the origin. A scanner stands free, and gets no points from itself. */
  bool isOnSurface(const Eigen::Vector3f& place) const
  {
    constexpr float nearest = 0.12F; // metres
    constexpr float around = 0.25F;  // metres: returns of no range are no surface
    std::size_t near = 0;
    std::size_t beyond = 0;
    forEachNear(place, around, [&](const Eigen::Vector3f& p) {
      ++((p - place).norm() < nearest ? near : beyond);
    });
    return near >= 3 && beyond >= 8;
  }

private:
  static constexpr float clear = 0.4F; ///< metres before and behind a patch

  /** @brief Points of one face of a wall, and the plane through them. */
  struct Face {
    std::size_t points = 0;
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float mean_square = 0; ///< of distances from the plane
  };

  /** @brief Calls `see(p)` for the points within a radius of a place. */
  template <typename See>
  void forEachNear(const Eigen::Vector3f& place, float radius, See see) const
  {
    const CubeTable& cubes = surfaces_.cubes();
    cubes.anyAround(cubes.at(place.cast<double>()), [&](std::uint32_t cube) {
      surfaces_.forEachPoint(cube, [&](const Eigen::Vector3f& p) {
        if ((p - place).squaredNorm() < radius * radius)
          see(p);
      });
      return false;
    });
  }

  /** @brief The plane through the points near a place, at most half a partition wall
   * from it along `normal`; along 0 all points near it are taken. */
  Face faceAt(const Eigen::Vector3f& place, const Eigen::Vector3f& normal) const
  {
    constexpr float radius = 0.25F; // metres: 19 points that are 0.1 m apart
    Face face;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    forEachNear(place, radius, [&](const Eigen::Vector3f& p) {
      const Eigen::Vector3f way = p - place;
      if (std::abs(way.dot(normal)) > beside)
        return;
      ++face.points;
      sum += way;
      squares += way * way.transpose();
    });
    if (face.points < fewest)
      return face;
    const auto n = static_cast<float>(face.points);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(squares / n - sum / n * (sum / n).transpose());
    face.mean = place + sum / n;
    face.normal = solver.eigenvectors().col(0);
    face.mean_square = solver.eigenvalues()[0];
    return face;
  }

  bool patchAt(const Eigen::Vector3f& place,
               const Eigen::Vector3f& direction,
               Patch& patch) const
  {
    constexpr float flat = 0.02F;      // metres, root of the mean square
    constexpr float nearest = 0.06F;   // metres from the place, along the ray
    constexpr float min_cosine = 0.5F; // a ray that grazes proves nothing
    if (surfaces_.cubes().findAt(place.cast<double>()) == CubeTable::none)
      return false;
    // First of both faces of a wall, then of the one that is near.
    const Face all = faceAt(place, Eigen::Vector3f::Zero());
    if (all.points < fewest)
      return false;
    const Face face = faceAt(place, all.normal);
    const float cosine = direction.dot(face.normal);
    if (face.points < fewest || face.mean_square > flat * flat ||
        std::abs(cosine) < min_cosine)
      return false;
    patch.normal = face.normal;
    const float along = (face.mean - place).dot(patch.normal) / cosine;
    patch.place = place + along * direction;
    return std::abs(along) <= nearest && isSurrounded(place, patch);
  }

  /** @brief Whether there are points on all sides of a patch's place. */
  bool isSurrounded(const Eigen::Vector3f& place, const Patch& patch) const
  {
    constexpr float radius = 0.2F; // metres: 12 points that are 0.1 m apart
    constexpr int min_sides = 7;   // of eight
    const Eigen::Vector3f u = patch.normal.unitOrthogonal();
    const Eigen::Vector3f v = patch.normal.cross(u);
    std::array<bool, 8> has{};
    forEachNear(place, radius, [&](const Eigen::Vector3f& p) {
      const Eigen::Vector3f way = p - patch.place;
      const double turn = std::atan2(way.dot(v), way.dot(u)) / M_PI;
      if (std::abs(way.dot(patch.normal)) <= beside)
        has[static_cast<std::size_t>(std::clamp(4 * (turn + 1), 0.0, 7.0))] = true;
    });
    return std::count(has.begin(), has.end(), true) >= min_sides;
  }

  static constexpr std::size_t fewest = 16; ///< points of a face
  static constexpr float beside = 0.08F;    ///< metres, less than a partition wall

  const PiercedSurfaces& surfaces_;
};

/** @brief Rays in the direction of a patch: numbers. */
struct Sight {
  double ended = 0; ///< on it
  double all = 0;   ///< on it and behind it
  double usual = 0; ///< in a direction of this size

  /** @brief Whether most rays ended on it, or more than a scanner casts went on: it is
   * no pane. */
  bool isTooFull() const
  {
    constexpr double most = 0.5;
    constexpr double fullest = 2.5; // times as many rays as in other directions
    return ended > most * all || all > fullest * usual + enough;
  }

  /** @brief Whether nearly nothing ended on it: a wall from where no scanner stood, or
   * a pane that returns little. */
  bool isBare() const
  {
    constexpr double least = 0.02; // of the rays
    return all >= enough && ended < least * all;
  }

  static constexpr double enough = 100; ///< rays that tell
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

  /** @brief What was seen in the direction of a patch, on it and behind it. */
  Sight sightOf(const Patch& patch) const
  {
    constexpr float on = 0.1F; // metres
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
    // As many as there would be if all directions had the same.
    const double solid_angle =
        M_PI * radius * radius * std::abs(before) / std::pow(whole.norm(), 3);
    return {static_cast<double>(ended), static_cast<double>(ended + through),
            static_cast<double>(seen_.size()) * solid_angle / (4 * M_PI)};
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
  constexpr std::size_t enough = 1000;    // rays
  constexpr double most = 0.02;           // of them, wrong
  constexpr std::size_t fewest = 5;       // wrong rays: fewer may be strays
  constexpr float shortest = 1.2F;        // metres, of a ray that tells something
  constexpr double least_of_pane = 0.005; // share of the rays that any pane returns
  if (patches.isOnSurface(taken.from))
    return false;
  const RangeImage image(taken.from, rows, taken.rows);
  std::size_t looked_at = 0;
  std::size_t too_full = 0;
  std::size_t bare = 0;
  Sight of_bare; // together, as one of them has too few rays to tell a pane
  const std::size_t stride = taken.rays.size() / enough + 1;
  for (std::size_t r = 0; r < taken.rays.size(); r += stride) {
    const ScanRay& ray = *taken.rays[r];
    if ((ray.to - ray.from).norm() < shortest)
      continue;
    ++looked_at;
    Patch patch;
    if (!patches.firstOn(ray, patch))
      continue;
    const Sight sight = image.sightOf(patch);
    if (sight.isTooFull())
      ++too_full;
    else if (sight.isBare()) {
      ++bare;
      of_bare.ended += sight.ended;
      of_bare.all += sight.all;
    }
  }
  const bool are_panes = of_bare.ended >= least_of_pane * of_bare.all;
  const std::size_t wrong = too_full + (are_panes ? 0 : bare);
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

} // namespace pcl::sedr
