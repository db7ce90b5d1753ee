// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"
#include "simulator/scene/queries.h"

namespace pcl::sedr::sim {

namespace {

constexpr std::size_t kMostParts = 200'000; ///< boxes and cylinders in a list
constexpr int kDeepestGroup = 4;
constexpr double kGap = 0.02; ///< metres between furniture and the wall behind it
constexpr std::size_t kLongestRow = 1000;

/** @brief Reads a list of objects in a room, or outside; groups read their own lists in
 * their own frame. */
class ObjectReader {
public:
  /** @param room null for the outside */
  ObjectReader(const Room* room, std::vector<Object>& objects)
      : room_(room)
      , objects_(objects)
  {}

  void readList(const std::vector<JsonView>& list)
  {
    for (const JsonView& item : list) {
      const auto [name, view] = item.single();
      const auto kind = furnitureKinds().find(name);
      if (name == "group")
        readGroup(view);
      else if (name == "object")
        readObject(view);
      else if (kind != furnitureKinds().end() && (room_ || !kind->second.is_indoors))
        readKind(kind->second, view);
      else
        item.fail("is of unknown kind \"" + name + "\"; known are " + knownKinds());
    }
  }

private:
  std::string knownKinds() const
  {
    std::string names = "group, object";
    for (const auto& [name, kind] : furnitureKinds())
      if (room_ || !kind.is_indoors)
        names += ", " + name;
    return names;
  }

  void add(const JsonView& view, Object object)
  {
    parts_ += object.parts.size();
    if (parts_ > kMostParts)
      view.fail("makes more than " + std::to_string(kMostParts) + " parts");
    objects_.push_back(std::move(object));
  }

  void readKind(const Kind& kind, const JsonView& view)
  {
    const auto name = view.find("name");
    for (const Spot& spot : spotsOf(kind, view)) {
      Assembly assembly(name ? name->text() : kind.name, spot);
      kind.build(view, assembly);
      add(view, std::move(assembly.object));
    }
  }

  /** @brief Returns where objects of a kind are: one place, or a row at a wall. */
  std::vector<Spot> spotsOf(const Kind& kind, const JsonView& view) const
  {
    if (kind.standing == Standing::OnFloor && room_ && !is_group_ &&
        view.find("wall")) {
      Assembly sample(kind.name, {});
      kind.build(view, sample);
      return spotsAtWall(view, sample.footprint());
    }
    const bool is_hinged = kind.standing == Standing::Hinged;
    const Vec2 place = toScene(view.at(is_hinged ? "hinge" : "at").point2());
    return {{place, yawOf(view, is_hinged ? "direction" : "yaw"),
             kind.standing == Standing::BelowCeiling ? ceilingAt(view, place)
                                                     : floorAt(view, place)}};
  }

  /** @param footprint width and depth of an object */
  std::vector<Spot> spotsAtWall(const JsonView& view, const Vec2& footprint) const
  {
    const auto& walls = room_->boundary.elements;
    const Element& wall = walls[view.at("wall").count(0, walls.size() - 1)];
    const double behind = view.numberOr("gap", kGap, 0.0, 100.0);
    const double first = view.at("s").number();
    std::size_t count = 1;
    double between = 0.0; // objects of a row
    if (const auto row = view.find("row")) {
      count = row->at("count").count(1, kLongestRow);
      between = row->at("gap").number(0.0, 100.0);
    }
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < count; ++i) {
      const double s = first + static_cast<double>(i) * (footprint.x() + between);
      double clearance = behind; // on a curved wall the corners keep clear
      if (wall.isArc() && wall.counter_clockwise) {
        const double reach = wall.radius - behind;
        clearance +=
            reach - std::sqrt(reach * reach - 0.25 * footprint.x() * footprint.x());
      }
      const Vec2 center = pointBeside(wall, s, -clearance - 0.5 * footprint.y());
      const double yaw = directionOf(-wall.normalAt(s)) - 0.5 * pi;
      spots.push_back({center, yaw, floorAt(view, center)});
    }
    return spots;
  }

  double floorAt(const JsonView& view, const Vec2& point) const
  {
    if (!room_)
      return view.numberOr("floor", 0.0);
    requireWithin(view, point);
    return room_->floorAt(point) + view.numberOr("raise", 0.0);
  }

  double ceilingAt(const JsonView& view, const Vec2& point) const
  {
    requireWithin(view, point);
    return room_->ceilingAt(point);
  }

  void requireWithin(const JsonView& view, const Vec2& point) const
  {
    if (!room_->contains(point))
      view.fail("is not within its room");
  }

  Vec2 toScene(const Vec2& point) const { return origin_ + rotated(point, yaw_); }

  double yawOf(const JsonView& view, const std::string& key = "yaw") const
  {
    return yaw_ + view.numberOr(key, 0.0) * pi / 180.0;
  }

  /** @brief Reads single boxes and cylinders; z is that of the scene. */
  void readObject(const JsonView& view)
  {
    const auto name = view.find("name");
    Assembly assembly(name ? name->text() : "object", {origin_, yaw_, 0.0});
    for (const JsonView& box : view.itemsOf("boxes"))
      assembly.addBox(box.at("center").point3(), box.at("size").size3(),
                      box.numberOr("yaw", 0.0) * pi / 180.0);
    for (const JsonView& cylinder : view.itemsOf("cylinders"))
      assembly.addCylinder(cylinder.at("base").point3(), cylinder.at("radius").size(),
                           cylinder.at("height").size());
    if (assembly.object.parts.empty())
      view.fail("has neither boxes nor cylinders");
    add(view, std::move(assembly.object));
  }

  /** @brief Reads objects repeated at several places, each [x, y] or [x, y, yaw]. */
  void readGroup(const JsonView& view)
  {
    if (depth_ == kDeepestGroup)
      view.fail("is a group too deep within groups");
    const auto list = view.at("objects").items(1);
    const ObjectReader outer = *this;
    is_group_ = true;
    ++depth_;
    for (const JsonView& place : view.at("places").items(1)) {
      const bool is_turned = place.items().size() == 3;
      origin_ = outer.toScene(is_turned ? plan(place.point3()) : place.point2());
      yaw_ = outer.yaw_ + (is_turned ? place.point3().z() * pi / 180.0 : 0.0);
      readList(list);
    }
    origin_ = outer.origin_;
    yaw_ = outer.yaw_;
    is_group_ = outer.is_group_;
    --depth_;
  }

  const Room* room_;
  std::vector<Object>& objects_;
  std::size_t parts_ = 0;
  Vec2 origin_ = Vec2::Zero(); ///< of the group's frame
  double yaw_ = 0.0;           ///< of the group's frame, radians
  bool is_group_ = false;      ///< whose objects cannot refer to walls
  int depth_ = 0;
};

} // namespace

std::vector<Object>
readObjects(const std::vector<JsonView>& list, const Room* room)
{
  std::vector<Object> objects;
  ObjectReader(room, objects).readList(list);
  return objects;
}

} // namespace pcl::sedr::sim
