// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include <algorithm>
#include <functional>
#include <map>

namespace pcl::sedr::sim {

Assembly::Assembly(std::string name, const Spot& spot)
    : spot_(spot)
{
  object.name = std::move(name);
}

void
Assembly::addBox(const Vec3& low, const Vec3& high)
{
  addBox(0.5 * (low + high), high - low, 0.0);
}

void
Assembly::addBox(const Vec3& center, const Vec3& size, double yaw)
{
  const Vec3 middle = moved(center);
  Prism box{{}, middle.z() - 0.5 * size.z(), middle.z() + 0.5 * size.z()};
  for (const Vec2& sign :
       {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)})
    box.corners.push_back(plan(middle) +
                          rotated(sign.cwiseProduct(plan(size)), spot_.yaw + yaw));
  object.parts.push_back(std::move(box));
}

void
Assembly::addCylinder(const Vec3& base, double radius, double height)
{
  const Vec3 foot = moved(base);
  Prism cylinder{{}, foot.z(), foot.z() + height};
  for (const Element& half : circleLoop(plan(foot), radius).elements) {
    const std::vector<double> ends = chordEnds(half);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      cylinder.corners.push_back(half.pointAt(ends[i]));
  }
  object.parts.push_back(std::move(cylinder));
}

Vec3
Assembly::moved(const Vec3& point) const
{
  return lifted(spot_.center + rotated(plan(point), spot_.yaw), spot_.z + point.z());
}

Vec2
Assembly::footprint() const
{
  Box2 box;
  for (const Prism& part : object.parts)
    for (const Vec2& corner : part.corners)
      box.extend(corner);
  return box.sizes();
}

namespace {

/** @brief Where an object of a kind stands or hangs. */
enum class Standing { OnFloor, BelowCeiling, Hinged };

/** @brief A kind of furniture. */
struct Kind {
  std::string name; ///< of its objects, unless the file gives another
  Standing standing = Standing::OnFloor;
  bool is_indoors = false; ///< in rooms only
  std::function<void(const JsonView&, Assembly&)> build;
};

constexpr std::size_t kMostSteps = 200; ///< of a flight of stairs

void
addCentred(Assembly& assembly, double width, double depth, double low, double high)
{
  assembly.addBox({-0.5 * width, -0.5 * depth, low}, {0.5 * width, 0.5 * depth, high});
}

void
addLegs(Assembly& assembly, double half_width, double half_depth, double height)
{
  constexpr double thickness = 0.05;
  for (const double x : {-half_width, half_width - thickness})
    for (const double y : {-half_depth, half_depth - thickness})
      assembly.addBox({x, y, 0.0}, {x + thickness, y + thickness, height});
}

/** @brief Adds books of varying height on about two thirds of a board's width. */
void
addBooks(Assembly& assembly, const Vec3& shelf, double board, double room, int row)
{
  constexpr double width = 0.21;
  const double half_width = 0.5 * shelf.x();
  int place = 0;
  for (double x = -half_width + 0.03; x + width < half_width - 0.03; x += width) {
    ++place;
    if ((place + row) % 3 == 0)
      continue;
    const double height = room * (0.62 + 0.08 * ((place * 7 + row * 3) % 4));
    const double front = -0.5 * shelf.y() + 0.04 + 0.01 * ((place * 5 + row) % 4);
    assembly.addBox({x, front, board},
                    {x + width, 0.5 * shelf.y() - 0.02, board + height});
  }
}

/** @brief Builds sides, back, boards about every 0.35 m, and books. */
void
buildShelf(const JsonView& view, Assembly& assembly)
{
  constexpr double board = 0.02;
  const Vec3 size = view.at("size").size3();
  const double x = 0.5 * size.x();
  const double y = 0.5 * size.y();
  assembly.addBox({-x, -y, 0.0}, {-x + board, y, size.z()});
  assembly.addBox({x - board, -y, 0.0}, {x, y, size.z()});
  assembly.addBox({-x + board, y - 0.01, 0.0}, {x - board, y, size.z()});
  const int rows = std::max(1, static_cast<int>(std::lround(size.z() / 0.35)));
  const double pitch = (size.z() - board) / rows;
  for (int row = 0; row <= rows; ++row) {
    const double z = row * pitch;
    assembly.addBox({-x + board, -y, z}, {x - board, y - 0.01, z + board});
    if (row < rows)
      addBooks(assembly, size, z + board, pitch - board, row);
  }
}

/** @brief Builds a straight flight that climbs along y from its foot. */
void
buildStairs(const JsonView& view, Assembly& assembly)
{
  constexpr double thickness = 0.15; // metres below the inner corners of the steps
  const double half = 0.5 * view.at("width").size();
  const double rise = view.at("rise").size();
  const double going = view.at("going").size();
  const auto solid = view.find("solid");
  const bool is_solid = solid && solid->boolean();
  const std::size_t steps = view.at("steps").count(1, kMostSteps);
  for (std::size_t i = 0; i < steps; ++i) {
    const double y = static_cast<double>(i) * going;
    const double top = static_cast<double>(i + 1) * rise;
    const double bottom = is_solid ? 0.0 : std::max(0.0, top - rise - thickness);
    assembly.addBox({-half, y, bottom}, {half, y + going, top});
  }
}

/** @brief Returns the kinds by their key in scene files. */
const std::map<std::string, Kind>&
furnitureKinds()
{
  using View = const JsonView&;
  constexpr auto floor = Standing::OnFloor;
  static const std::map<std::string, Kind> kinds{
      {"block",
       {"block", floor, false,
        [](View view, Assembly& block) {
          const Vec3 size = view.at("size").size3();
          addCentred(block, size.x(), size.y(), 0.0, size.z());
        }}},
      {"chair",
       {"chair", floor, false,
        [](View, Assembly& chair) {
          constexpr double half = 0.225;
          addLegs(chair, half, half, 0.43);
          addCentred(chair, 2 * half, 2 * half, 0.43, 0.47);
          chair.addBox({-half, half - 0.04, 0.47}, {half, half, 0.92});
        }}},
      {"cylinder",
       {"cylinder", floor, false,
        [](View view, Assembly& cylinder) {
          cylinder.addCylinder(Vec3::Zero(), view.at("radius").size(),
                               view.at("height").size());
        }}},
      {"door_leaf", // 4 cm thick, from its hinge along x
       {"door leaf", Standing::Hinged, true,
        [](View view, Assembly& leaf) {
          leaf.addBox({0.0, -0.02, 0.01},
                      {view.at("width").size(), 0.02, view.at("height").size()});
        }}},
      {"lamp", // a shade on a cord
       {"lamp", Standing::BelowCeiling, true,
        [](View view, Assembly& lamp) {
          const double drop = view.at("drop").size();
          const double shade = std::min(0.25, 0.5 * drop);
          lamp.addCylinder({0.0, 0.0, -drop}, view.at("radius").size(), shade);
          lamp.addCylinder({0.0, 0.0, shade - drop}, 0.008, drop - shade);
        }}},
      {"shelf", {"shelf", floor, false, buildShelf}},
      {"stairs", {kStairs, floor, true, buildStairs}},
      {"table",
       {"table", floor, false,
        [](View view, Assembly& table) {
          const Vec3 size = view.at("size").size3();
          const double under = size.z() - 0.03;
          addCentred(table, size.x(), size.y(), under, size.z());
          addLegs(table, 0.5 * size.x() - 0.04, 0.5 * size.y() - 0.04, under);
        }}},
      {"tree", {"tree", floor, false, [](View view, Assembly& tree) {
                  const double height = view.at("height").size();
                  const double crown = view.at("crown").size();
                  tree.addCylinder(Vec3::Zero(), 0.15, 0.4 * height);
                  tree.addCylinder({0.0, 0.0, 0.4 * height}, crown, 0.4 * height);
                  tree.addCylinder({0.0, 0.0, 0.8 * height}, 0.6 * crown, 0.2 * height);
                }}}};
  return kinds;
}

constexpr std::size_t kMostParts = 200'000; ///< boxes and cylinders in a list
constexpr int kDeepestGroup = 4;
constexpr double kGap = 0.02; ///< metres between furniture and the wall behind it
constexpr std::size_t kLongestRow = 1000;

/** @brief The frame of a group, in that of the scene. */
struct Frame {
  Vec2 origin = Vec2::Zero();
  double yaw = 0.0; ///< radians
  int depth = 0;    ///< of groups; those in one cannot refer to walls

  Vec2 place(const Vec2& point) const { return origin + rotated(point, yaw); }

  double yawIn(const JsonView& view, const std::string& key = "yaw") const
  {
    return yaw + view.numberOr(key, 0.0) * pi / 180.0;
  }
};

/** @brief Reads lists of objects in a room, or outside. */
class ObjectReader {
public:
  /** @param room null for the outside */
  ObjectReader(const Room* room, std::vector<Object>& objects)
      : room_(room)
      , objects_(objects)
  {}

  void readList(const std::vector<JsonView>& list, const Frame& frame)
  {
    for (const JsonView& item : list) {
      const auto [name, view] = item.single();
      const auto kind = furnitureKinds().find(name);
      if (name == "group")
        readGroup(view, frame);
      else if (name == "object")
        readObject(view, frame);
      else if (kind != furnitureKinds().end() && (room_ || !kind->second.is_indoors))
        readKind(kind->second, view, frame);
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
    if (const auto name = view.find("name"))
      object.name = name->text();
    objects_.push_back(std::move(object));
  }

  void readKind(const Kind& kind, const JsonView& view, const Frame& frame)
  {
    const auto addAt = [&](const Vec2& place, double yaw, double z) {
      Assembly assembly(kind.name, {place, yaw, z});
      kind.build(view, assembly);
      add(view, std::move(assembly.object));
    };
    if (kind.standing == Standing::OnFloor && room_ && frame.depth == 0 &&
        view.find("wall"))
      return readRow(kind, view, addAt);
    const bool is_hinged = kind.standing == Standing::Hinged;
    const Vec2 place = frame.place(view.at(is_hinged ? "hinge" : "at").point2());
    addAt(place, frame.yawIn(view, is_hinged ? "direction" : "yaw"),
          heightAt(view, place, kind.standing == Standing::BelowCeiling));
  }

  /** @brief Adds an object at a wall, or a row of them. */
  template <typename AddAt>
  void readRow(const Kind& kind, const JsonView& view, const AddAt& addAt) const
  {
    Assembly sample(kind.name, {});
    kind.build(view, sample);
    const Vec2 footprint = sample.footprint();
    const auto& walls = room_->boundary.elements;
    const Element& wall = walls[view.at("wall").count(0, walls.size() - 1)];
    const double behind = view.numberOr("gap", kGap, 0.0, 100.0);
    const double first = view.at("s").number();
    const auto row = view.find("row");
    const std::size_t count = row ? row->at("count").count(1, kLongestRow) : 1;
    const double between = row ? row->at("gap").number(0.0, 100.0) : 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double s = first + static_cast<double>(i) * (footprint.x() + between);
      double clearance = behind; // on a curved wall the corners keep clear
      if (wall.isArc() && wall.counter_clockwise) {
        const double reach = wall.radius - behind;
        clearance +=
            reach - std::sqrt(reach * reach - 0.25 * footprint.x() * footprint.x());
      }
      const Vec2 center = pointBeside(wall, s, -clearance - 0.5 * footprint.y());
      addAt(center, directionOf(-wall.normalAt(s)) - 0.5 * pi,
            heightAt(view, center, false));
    }
  }

  /** @brief Returns z of the feet of an object, or of the ceiling above it. */
  double heightAt(const JsonView& view, const Vec2& place, bool of_ceiling) const
  {
    if (!room_)
      return view.numberOr("floor", 0.0);
    if (!room_->contains(place))
      view.fail("is not within its room");
    return of_ceiling ? room_->ceilingAt(place)
                      : room_->floorAt(place) + view.numberOr("raise", 0.0);
  }

  /** @brief Reads single boxes and cylinders; z is that of the scene. */
  void readObject(const JsonView& view, const Frame& frame)
  {
    Assembly assembly("object", {frame.origin, frame.yaw, 0.0});
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
  void readGroup(const JsonView& view, const Frame& frame)
  {
    if (frame.depth == kDeepestGroup)
      view.fail("is a group too deep within groups");
    const auto list = view.at("objects").items(1);
    for (const JsonView& place : view.at("places").items(1)) {
      const bool is_turned = place.items().size() == 3;
      const Vec2 at = is_turned ? plan(place.point3()) : place.point2();
      const double yaw = is_turned ? place.point3().z() * pi / 180.0 : 0.0;
      readList(list, {frame.place(at), frame.yaw + yaw, frame.depth + 1});
    }
  }

  const Room* room_;
  std::vector<Object>& objects_;
  std::size_t parts_ = 0;
};

} // namespace

std::vector<Object>
readObjects(const std::vector<JsonView>& list, const Room* room)
{
  std::vector<Object> objects;
  ObjectReader(room, objects).readList(list, {});
  return objects;
}

} // namespace pcl::sedr::sim
