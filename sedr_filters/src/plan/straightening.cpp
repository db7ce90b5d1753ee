// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/straightening.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Cosine of what two faces may turn by and be parallel still: 15 degrees. */
constexpr double parallel = 0.966;

/** @brief How far from a wall that leans its surroundings give way, beyond what it
 * moves by, metres. */
constexpr double reach = 1;

Eigen::Vector2d
leftOf(const Eigen::Vector2d& v)
{
  return {-v.y(), v.x()};
}

Eigen::Vector2d
directionOf(const LeaningFace& face)
{
  return (face.end - face.start).normalized();
}

/** @brief How far a face leans out of where it is at its head, at a height. */
double
shiftAt(const LeaningFace& face, double z)
{
  return z < face.low ? 0 : face.run * std::min(z - face.head, 0.0);
}

/** @brief A place by a face: along its foot line, and off it, on lines that go as the
 * walls at its ends do. */
struct FacePlace {
  double along = 0;
  double off = 0;
};

class FaceFrame {
public:
  explicit FaceFrame(const LeaningFace& face)
      : face_(face)
      , way_(directionOf(face))
      , left_(leftOf(way_))
      , length_((face.end - face.start).norm())
      , turn_((face.skew_end - face.skew_start) / length_)
  {}

  FacePlace placeOf(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d from = p - face_.start;
    FacePlace place;
    place.off = from.dot(left_);
    const double stretch = 1 + place.off * turn_;
    place.along = (from.dot(way_) - place.off * face_.skew_start) /
                  (std::abs(stretch) > 0.1 ? stretch : 0.1);
    return place;
  }

  /** @brief Way in plan for a metre to the left. */
  Eigen::Vector2d wayOff(double along) const
  {
    const double at = std::clamp(along, 0.0, length_);
    return left_ + (face_.skew_start + turn_ * at) * way_;
  }

  Eigen::Vector2d pointAt(double along) const { return face_.start + along * way_; }

  bool covers(double along) const
  {
    return along >= -face_.before_start && along <= length_ + face_.beyond_end;
  }

  const Eigen::Vector2d& left() const { return left_; }

private:
  const LeaningFace& face_;
  Eigen::Vector2d way_;
  Eigen::Vector2d left_;
  double length_;
  double turn_;
};

/** @brief Where a face is on a line off another one, in the scan and straightened. */
struct Anchor {
  double scan = 0;
  double straight = 0;
};

/** @brief Where a face crosses the line p + off * way at a height.
 * @return whether it does, within its ends */
bool
anchorOn(const LeaningFace& face,
         const Eigen::Vector2d& p,
         const Eigen::Vector2d& way,
         double z,
         Anchor& anchor)
{
  const Eigen::Vector2d left = leftOf(directionOf(face));
  const double across = way.dot(left);
  if (std::abs(across) < parallel * way.norm() || z < face.low || z > face.head)
    return false;
  const double straight = (face.start - p).dot(left);
  anchor.straight = straight / across;
  anchor.scan = (straight + shiftAt(face, z)) / across;
  const double along = (p + anchor.straight * way - face.start).dot(directionOf(face));
  return along >= -face.before_start &&
         along <= (face.end - face.start).norm() + face.beyond_end;
}

double
between(double value, double low, double high, double low_image, double high_image)
{
  return low_image + (value - low) / (high - low) * (high_image - low_image);
}

} // namespace

Straightening::Straightening(std::vector<LeaningFace> faces)
{
  for (LeaningFace& face : faces)
    if ((face.end - face.start).norm() > 1e-3 && face.head > face.low)
      faces_.push_back(face);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].run == 0)
      continue;
    const auto group =
        std::find_if(groups_.begin(), groups_.end(), [&](const Group& other) {
          return std::abs(directionOf(faces_[f]).dot(
                     directionOf(faces_[other.front()]))) > parallel;
        });
    if (group == groups_.end())
      groups_.push_back({f});
    else
      group->push_back(f);
  }
}

Eigen::Vector3d
Straightening::move(const Group& group, const Eigen::Vector3d& p, bool is_forth) const
{
  // The face of the group that the place is nearest to tells the line it moves along.
  std::size_t nearest = faces_.size();
  FacePlace place;
  double least = 0;
  for (const std::size_t f : group) {
    const LeaningFace& face = faces_[f];
    if (p.z() < face.low || p.z() >= face.head)
      continue;
    const FaceFrame frame(face);
    const FacePlace here = frame.placeOf(p.head<2>());
    const double off = std::abs(here.off - (is_forth ? shiftAt(face, p.z()) : 0));
    if (!frame.covers(here.along) || (nearest < faces_.size() && off >= least))
      continue;
    nearest = f;
    place = here;
    least = off;
  }
  if (nearest == faces_.size())
    return p;
  const LeaningFace& face = faces_[nearest];
  const FaceFrame frame(face);
  const Eigen::Vector2d origin = frame.pointAt(place.along);
  const Eigen::Vector2d way = frame.wayOff(place.along);
  const Anchor own{shiftAt(face, p.z()), 0};
  const auto here = [&](const Anchor& a) { return is_forth ? a.scan : a.straight; };
  const auto there = [&](const Anchor& a) { return is_forth ? a.straight : a.scan; };
  // The next faces on both sides, or where nothing moves any more.
  const double width = reach + 2 * std::abs(face.run) * (face.head - face.low);
  const double low = std::min(own.scan, own.straight) - width;
  const double high = std::max(own.scan, own.straight) + width;
  Anchor before{low, low};
  Anchor behind{high, high};
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Anchor other;
    if (f == nearest || !anchorOn(faces_[f], origin, way, p.z(), other))
      continue;
    const bool is_below = other.scan < own.scan && other.straight < own.straight;
    const bool is_above = other.scan > own.scan && other.straight > own.straight;
    if (is_below && other.scan > before.scan && other.straight > before.straight)
      before = other;
    if (is_above && other.scan < behind.scan && other.straight < behind.straight)
      behind = other;
  }
  double moved = place.off;
  if (place.off <= here(before) || place.off >= here(behind))
    return p; // another face, or none, moves it
  if (place.off < here(own))
    moved = between(place.off, here(before), here(own), there(before), there(own));
  else
    moved = between(place.off, here(own), here(behind), there(own), there(behind));
  const Eigen::Vector2d to = origin + moved * way;
  return {to.x(), to.y(), p.z()};
}

Eigen::Vector3d
Straightening::straighten(const Eigen::Vector3d& p) const
{
  Eigen::Vector3d moved = p;
  for (const Group& group : groups_)
    moved = move(group, moved, true);
  return moved;
}

Eigen::Vector3d
Straightening::back(const Eigen::Vector3d& p) const
{
  Eigen::Vector3d moved = p;
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group)
    moved = move(*group, moved, false);
  return moved;
}

Eigen::Vector3d
Straightening::normalBack(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const
{
  constexpr double step = 1e-4; // metres
  const Eigen::Vector3d side =
      std::abs(normal.z()) < 0.5 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d a = normal.cross(side).normalized();
  const Eigen::Vector3d b = normal.cross(a);
  const auto tangent = [&](const Eigen::Vector3d& way) -> Eigen::Vector3d {
    return back(p + step * way) - back(p - step * way);
  };
  const Eigen::Vector3d across = tangent(a).cross(tangent(b));
  return across.norm() > 0 ? across.normalized() : normal;
}

} // namespace sedr
} // namespace pcl
