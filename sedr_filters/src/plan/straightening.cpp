// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/straightening.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Minimum cosine of the angle between parallel faces: 15 degrees. */
constexpr double parallel = 0.966;

/** @brief Distance over which the surroundings of a tilted wall are deformed, beyond
 * its own displacement, metres. */
constexpr double reach = 1;

Eigen::Vector2d
leftOf(const Eigen::Vector2d& v)
{
  return {-v.y(), v.x()};
}

Eigen::Vector2d
directionOf(const TiltedFace& face)
{
  return (face.end - face.start).normalized();
}

/** @brief Returns the displacement of a face at a height, relative to its head. */
double
shiftAt(const TiltedFace& face, double z)
{
  return z < face.low ? 0 : face.run * std::min(z - face.head, 0.0);
}

/** @brief Coordinates along a face and off it, parallel to the walls at its ends. */
struct FacePlace {
  double along = 0;
  double off = 0;
};

/** @brief The coordinate lines of a face. They are parallel to the wall at its start up
 * to `first`, to the wall at its end from `last` on, and turn evenly in between. */
class FaceFrame {
public:
  template <typename Ends>
  FaceFrame(const TiltedFace& face, const Ends& ends)
      : face_(face)
      , way_(directionOf(face))
      , left_(leftOf(way_))
      , length_((face.end - face.start).norm())
      , first_(ends[0].along)
      , last_(ends[1].along)
      , skew_first_(ends[0].skew)
      , skew_last_(ends[1].skew)
      , turn_((skew_last_ - skew_first_) / (last_ - first_))
  {}

  FacePlace placeOf(const Eigen::Vector2d& p) const
  {
    constexpr double min_stretch = 0.1; // crossing lines would be ambiguous
    const Eigen::Vector2d from = p - face_.start;
    const double off = from.dot(left_);
    const double along = from.dot(way_);
    const double stretch = std::max(min_stretch, 1 + off * turn_);
    double at = first_ + (along - off * skew_first_ - first_) / stretch;
    if (at < first_)
      at = along - off * skew_first_;
    else if (at > last_)
      at = along - off * skew_last_;
    return {at, off};
  }

  /** @brief Returns the direction in plan for one metre to the left. */
  Eigen::Vector2d wayOff(double along) const
  {
    const double at = std::clamp(along, first_, last_);
    return left_ + (skew_first_ + turn_ * (at - first_)) * way_;
  }

  Eigen::Vector2d pointAt(double along) const { return face_.start + along * way_; }

  bool covers(double along) const
  {
    return along >= -face_.before_start && along <= length_ + face_.beyond_end;
  }

private:
  const TiltedFace& face_;
  Eigen::Vector2d way_;
  Eigen::Vector2d left_;
  double length_;
  double first_;
  double last_;
  double skew_first_;
  double skew_last_;
  double turn_;
};

/** @brief Position of a face on a line across it, in the scan and straightened. */
struct Anchor {
  double scan = 0;
  double straight = 0;
};

bool
areParallel(const TiltedFace& a, const TiltedFace& b)
{
  return std::abs(directionOf(a).dot(directionOf(b))) > parallel;
}

/** @brief Intersects a face with the line p + off * way at a height.
 * @return whether they meet within the ends of the face */
bool
anchorOn(const TiltedFace& face,
         const Eigen::Vector2d& p,
         const Eigen::Vector2d& way,
         double z,
         Anchor& anchor)
{
  const Eigen::Vector2d left = leftOf(directionOf(face));
  const double across = way.dot(left);
  if (z < face.low || z > face.head)
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

Straightening::Straightening(std::vector<TiltedFace> faces)
{
  for (TiltedFace& face : faces)
    if ((face.end - face.start).norm() > 1e-3 && face.head > face.low)
      faces_.push_back(face);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].run == 0)
      continue;
    const auto group =
        std::find_if(groups_.begin(), groups_.end(), [&](const Group& other) {
          return areParallel(faces_[f], faces_[other.front()]);
        });
    if (group == groups_.end())
      groups_.push_back({f});
    else
      group->push_back(f);
  }
  for (std::size_t f = 0; f < faces_.size(); ++f)
    ends_.push_back(endsOf(f));
}

std::array<Straightening::End, 2>
Straightening::endsOf(std::size_t face) const
{
  constexpr double min_turn = 0.2; // sine
  constexpr double farthest = 0.5; // distance of a corner from the ends of both, metres
  constexpr double most =
      1.0 / 3; // maximum share of a face with the direction of one end
  const TiltedFace& own = faces_[face];
  const Eigen::Vector2d way = directionOf(own);
  const Eigen::Vector2d left = leftOf(way);
  const double length = (own.end - own.start).norm();
  std::array<End, 2> ends{End{0, 0}, End{0, length}};
  std::array<double, 2> nearest{farthest, farthest};
  for (const TiltedFace& other : faces_) {
    const Eigen::Vector2d beside = directionOf(other);
    const double sine = beside.dot(left);
    if (std::abs(sine) < min_turn || other.low > own.head || other.head < own.low)
      continue;
    const double skew = beside.dot(way) / sine;
    const auto crossing = [&](double z) {
      const Eigen::Vector2d at = other.start + shiftAt(other, z) * leftOf(beside);
      return (at - own.start).dot(way) - (at - own.start).dot(left) * skew;
    };
    // The crossing with the other wall at its head, and at the higher foot of both.
    const double high = crossing(other.head);
    const double low = crossing(std::max(own.low, other.low));
    const Eigen::Vector2d corner = own.start + high * way;
    const double tilted = std::abs(shiftAt(own, std::max(own.low, other.low)) / sine);
    const double off_other = std::max(
        0.0,
        std::min((corner - other.start).norm(), (corner - other.end).norm()) - tilted);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const double at = end == 0 ? 0 : length;
      const double off_own =
          std::max({0.0, std::min(low, high) - at, at - std::max(low, high)});
      if (off_own + off_other >= nearest[end])
        continue;
      nearest[end] = off_own + off_other;
      ends[end].skew = skew;
      ends[end].along =
          end == 0 ? std::clamp(std::max(low, high), 0.0, most * length)
                   : std::clamp(std::min(low, high), (1 - most) * length, length);
    }
  }
  return ends;
}

Eigen::Vector3d
Straightening::move(const Group& group, const Eigen::Vector3d& p, bool is_forth) const
{
  // The nearest face of the group defines the line that the place moves along.
  std::size_t nearest = faces_.size();
  FacePlace place;
  double least = 0;
  for (const std::size_t f : group) {
    const TiltedFace& face = faces_[f];
    if (p.z() < face.low || p.z() >= face.head)
      continue;
    const FaceFrame frame(face, ends_[f]);
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
  const TiltedFace& face = faces_[nearest];
  const FaceFrame frame(face, ends_[nearest]);
  const Eigen::Vector2d origin = frame.pointAt(place.along);
  const Eigen::Vector2d way = frame.wayOff(place.along);
  const Anchor own{shiftAt(face, p.z()), 0};
  const auto here = [&](const Anchor& a) { return is_forth ? a.scan : a.straight; };
  const auto there = [&](const Anchor& a) { return is_forth ? a.straight : a.scan; };
  // The next faces on both sides, or the limits of the deformation.
  const double width = reach + 2 * std::abs(face.run) * (face.head - face.low);
  const double low = std::min(own.scan, own.straight) - width;
  const double high = std::max(own.scan, own.straight) + width;
  Anchor before{low, low};
  Anchor behind{high, high};
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Anchor other;
    if (f == nearest || !areParallel(face, faces_[f]) ||
        !anchorOn(faces_[f], origin, way, p.z(), other))
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
    return p; // another face moves it, or none
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

} // namespace pcl::sedr
