// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/loop.h"
#include "simulator/truth/room_regions.h"
#include "simulator/truth/truth_mesh.h"

#include <exception>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kBeside = 1e-4; ///< metres into a room, where its floor is measured

/** @brief The part of a wall that an opening or niche occupies, and its name. */
struct Gap {
  std::string place;
  std::size_t wall = 0;
  double from = 0.0;
  double to = 0.0;
  double sill = 0.0;
  double head = 0.0;
  double depth = 0.0;
};

template <typename Part>
Gap
gapOf(const std::string& place, const Part& part)
{
  return {place, part.wall, part.from, part.to, part.sill, part.head, part.depth};
}

/** @brief Returns a gap's part of the wall's face on the side of @p room. */
Element
faceOf(const Room& room, const Gap& gap)
{
  return pieceOf(elementOf(room.outline, gap.wall), gap.from, gap.to);
}

/** @brief The space that a gap occupies in a wall. */
struct Recess {
  std::string place;
  Loop footprint; ///< clockwise
  double low = 0.0;
  double high = 0.0;
};

bool
overlap(const Recess& a, const Recess& b)
{
  if (!(a.low < b.high - kContact && b.low < a.high - kContact))
    return false;
  for (const auto& [loop, other] : {std::make_pair(a.footprint, b.footprint),
                                    std::make_pair(b.footprint, a.footprint)})
    for (const Vec2 sample : samplesAlong(loop, -kInside))
      if (contains(loop, sample) && contains(other, sample))
        return true;
  return false;
}

class GapChecker {
public:
  GapChecker(const Scene& scene, Problems& problems)
      : scene_(scene)
      , problems_(problems)
  {}

  void run()
  {
    for (std::size_t i = 0; i < scene_.rooms.size(); ++i)
      checkNiches(i);
    if (!problems_.empty())
      return;
    openingsByRoom(scene_); // throws if one lies on no wall
    for (std::size_t i = 0; i < scene_.rooms.size(); ++i)
      checkRoom(i);
    checkOverlaps();
    if (problems_.empty())
      truthMesh(scene_); // throws if niches cannot be meshed
  }

private:
  void checkNiches(std::size_t room)
  {
    for (std::size_t k = 0; k < scene_.rooms[room].niches.size(); ++k) {
      const Niche& niche = scene_.rooms[room].niches[k];
      const Loop& outline = scene_.rooms[room].outline;
      const std::string place = placeOf(placeOf("rooms", room) + ".niches", k);
      if (niche.wall >= outline.size())
        problems_.report(place, " lies on no wall");
      else if (!(niche.from >= 0.0 && niche.from < niche.to &&
                 niche.to <= lengthOf(elementOf(outline, niche.wall))))
        problems_.report(place, " does not lie within its wall");
      else if (!(niche.sill < niche.head && niche.depth > 0.0))
        problems_.report(place, " has no height or depth");
    }
  }

  void checkRoom(std::size_t i)
  {
    const Room& room = scene_.rooms[i];
    const std::string place = placeOf("rooms", i);
    for (std::size_t k = 0; k < room.openings.size(); ++k) {
      const Gap gap = gapOf(placeOf(place + ".openings", k), room.openings[k]);
      checkHeights(room, gap);
      if (const auto target = room.openings[k].leads_to)
        checkHeights(scene_.rooms[*target],
                     gapOf(gap.place, otherSideOf(scene_, i, k)));
      else if (const Room* other = roomBehind(room, gap))
        problems_.report(gap.place, " reaches into room '", other->name,
                         "' but does not lead to it");
      remember(room, gap);
    }
    for (std::size_t k = 0; k < room.niches.size(); ++k) {
      const Gap gap = gapOf(placeOf(place + ".niches", k), room.niches[k]);
      checkHeights(room, gap);
      if (const Room* other = roomBehind(room, gap))
        problems_.report(gap.place, " reaches into room '", other->name, "'");
      remember(room, gap);
    }
  }

  /** @brief Checks that sill and head are between floor and ceiling along the gap. */
  void checkHeights(const Room& room, const Gap& gap)
  {
    const Element face = faceOf(room, gap);
    for (const double s : stepsAlong(face)) {
      const Vec2 inside = pointAt(face, s) - kBeside * rightNormalAt(face, s);
      if (!isInRoom(room, inside))
        continue;
      const double floor = floorBelow(room, inside);
      const double ceiling = ceilingAbove(room, inside);
      if (gap.sill < floor - kContact)
        return problems_.report(gap.place, ".sill is ", gap.sill,
                                ", below the floor of room '", room.name, "' at ",
                                floor);
      if (gap.head > ceiling + kContact)
        return problems_.report(gap.place, ".head is ", gap.head,
                                ", above the ceiling of room '", room.name, "' at ",
                                ceiling);
    }
  }

  static bool holds(const Room& room, Vec2 point, const Gap& gap)
  {
    return contains(room.outline, point) &&
           floorBelow(room, point) < gap.head - kContact &&
           ceilingAbove(room, point) > gap.sill + kContact;
  }

  /** @brief Returns the room that a gap's far side reaches, if any. */
  const Room* roomBehind(const Room& room, const Gap& gap) const
  {
    const Element far = offsetRight(faceOf(room, gap), gap.depth);
    for (const double s : stepsAlong(far))
      for (const Room& other : scene_.rooms)
        if (holds(other, pointAt(far, s), gap))
          return &other;
    return nullptr;
  }

  void remember(const Room& room, const Gap& gap)
  {
    recesses_.push_back(
        {gap.place, recessFootprint(faceOf(room, gap), gap.depth), gap.sill, gap.head});
  }

  void checkOverlaps()
  {
    for (std::size_t i = 0; i < recesses_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (overlap(recesses_[i], recesses_[k]))
          problems_.report(recesses_[i].place, " overlaps ", recesses_[k].place);
  }

  const Scene& scene_;
  Problems& problems_;
  std::vector<Recess> recesses_;
};

} // namespace

void
checkOpenings(const Scene& scene, Problems& problems)
{
  try {
    GapChecker(scene, problems).run();
  }
  catch (const std::exception& error) {
    problems.report(error.what());
  }
}

} // namespace pcl::sedr::sim
