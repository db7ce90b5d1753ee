// SPDX-License-Identifier: BSD-3-Clause
#include "scene_parts.h"

#include "object_places.h"

#include <algorithm>
#include <map>

namespace pcl::sedr::sim {

namespace {

constexpr std::size_t kMostParts = 200'000; ///< boxes and cylinders in a list
constexpr int kDeepestGroup = 4;
constexpr std::size_t kMostSteps = 200; ///< steps of a flight of stairs

using Keys = std::vector<std::string>;

/** @brief Reads a list of objects; groups read their own lists in their own frame. */
class ObjectReader {
public:
  ObjectReader(const Room* room, std::vector<Object>& objects)
      : room_(room)
      , objects_(objects)
  {}

  void readList(const std::vector<JsonView>& list, const ObjectPlaces& places)
  {
    for (const JsonView& item : list) {
      const auto [kind, view] = item.single();
      const auto reader = readers().find(kind);
      if (reader == readers().end())
        item.fail("is of unknown kind \"" + kind + "\"; known are " + knownKinds());
      (this->*reader->second)(view, places);
    }
  }

private:
  using Reader = void (ObjectReader::*)(const JsonView&, const ObjectPlaces&);

  /** @brief Returns the readers by kind; a room has more kinds than the outside. */
  const std::map<std::string, Reader>& readers() const
  {
    static const std::map<std::string, Reader> anywhere{
        {"block", &ObjectReader::readBlock}, {"car", &ObjectReader::readCar},
        {"chair", &ObjectReader::readChair}, {"cylinder", &ObjectReader::readCylinder},
        {"group", &ObjectReader::readGroup}, {"object", &ObjectReader::readObject},
        {"shelf", &ObjectReader::readShelf}, {"table", &ObjectReader::readTable},
        {"tree", &ObjectReader::readTree}};
    static const std::map<std::string, Reader> indoors = [] {
      auto readers = anywhere;
      readers["door_leaf"] = &ObjectReader::readDoorLeaf;
      readers["duct"] = &ObjectReader::readDuct;
      readers["fixture"] = &ObjectReader::readFixture;
      readers["lamp"] = &ObjectReader::readLamp;
      readers["stairs"] = &ObjectReader::readStairs;
      return readers;
    }();
    return room_ == nullptr ? anywhere : indoors;
  }

  std::string knownKinds() const
  {
    std::string kinds;
    for (const auto& reader : readers())
      kinds += (kinds.empty() ? "" : ", ") + reader.first;
    return kinds;
  }

  void add(const JsonView& view, Object object)
  {
    parts_ += object.boxes.size() + object.cylinders.size();
    if (parts_ > kMostParts)
      view.fail("makes more than " + std::to_string(kMostParts) + " parts");
    object.place = view.place();
    objects_.push_back(std::move(object));
  }

  static void
  allow(const JsonView& view, const ObjectPlaces& places, const Keys& others)
  {
    Keys keys = places.keysOfSpots();
    keys.insert(keys.end(), others.begin(), others.end());
    view.allowOnly(keys);
  }

  static Extent extentOf(const JsonView& view)
  {
    const Vec3 size = view.at("size").size3();
    return {size.x, size.y, size.z};
  }

  static std::string nameOf(const JsonView& view, const std::string& otherwise)
  {
    const auto name = view.find("name");
    return name ? name->text() : otherwise;
  }

  void readBlock(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {"name", "size"});
    const Extent extent = extentOf(view);
    for (const Spot& spot : places.spotsOf(view, extent.width, extent.depth))
      add(view, makeBlock(nameOf(view, "block"), spot, extent));
  }

  void readTable(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {"size"});
    const Extent extent = extentOf(view);
    for (const Spot& spot : places.spotsOf(view, extent.width, extent.depth))
      add(view, makeTable(spot, extent));
  }

  void readShelf(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {"size"});
    const Extent extent = extentOf(view);
    for (const Spot& spot : places.spotsOf(view, extent.width, extent.depth))
      add(view, makeShelf(spot, extent));
  }

  void readChair(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {});
    for (const Spot& spot : places.spotsOf(view, kChairWidth, kChairWidth))
      add(view, makeChair(spot));
  }

  void readCylinder(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {"name", "radius", "height"});
    const double radius = view.at("radius").size();
    const double height = view.at("height").size();
    for (const Spot& spot : places.spotsOf(view, 2.0 * radius, 2.0 * radius)) {
      Object object;
      object.name = nameOf(view, "cylinder");
      object.cylinders.push_back({lifted(spot.center, spot.floor), radius, height});
      add(view, std::move(object));
    }
  }

  void readTree(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {"height", "crown"});
    const double height = view.at("height").size();
    const double crown = view.at("crown").size();
    for (const Spot& spot : places.spotsOf(view, 2.0 * crown, 2.0 * crown))
      add(view, makeTree(spot, height, crown));
  }

  void readCar(const JsonView& view, const ObjectPlaces& places)
  {
    allow(view, places, {});
    for (const Spot& spot : places.spotsOf(view, kCarLength, kCarWidth))
      add(view, makeCar(spot));
  }

  void readDoorLeaf(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"hinge", "direction", "width", "height", "raise"});
    const Vec2 hinge = places.pointOf(view.at("hinge"));
    add(view,
        makeDoorLeaf(hinge, places.yawOf(view, "direction"), view.at("width").size(),
                     view.at("height").size(), places.floorAt(view, hinge)));
  }

  void readStairs(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"at", "yaw", "raise", "width", "rise", "going", "steps", "solid"});
    Flight flight{view.at("width").size(), view.at("rise").size(),
                  view.at("going").size(), view.at("steps").count(1, kMostSteps)};
    if (const auto solid = view.find("solid"))
      flight.is_solid = solid->boolean();
    const Vec2 foot = places.pointOf(view.at("at"));
    add(view,
        makeStairs({foot, places.yawOf(view), places.floorAt(view, foot)}, flight));
  }

  void readLamp(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"at", "drop", "radius"});
    const Vec2 center = places.pointOf(view.at("at"));
    add(view, makeLamp(center, places.ceilingAt(view, center), view.at("drop").size(),
                       view.at("radius").size()));
  }

  void readFixture(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"name", "at", "yaw", "size", "drop"});
    const Vec2 center = places.pointOf(view.at("at"));
    const double drop = view.find("drop") ? view.at("drop").number(0.0) : 0.0;
    add(view, makeFixture(nameOf(view, "fixture"), center, places.yawOf(view),
                          extentOf(view), places.ceilingAt(view, center), drop));
  }

  void readDuct(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"from", "to", "radius", "drop"});
    const Vec2 from = places.pointOf(view.at("from"));
    const Vec2 to = places.pointOf(view.at("to"));
    if (!(length(to - from) >= 0.01))
      view.fail("begins where it ends");
    const double ceiling = places.ceilingAt(view, 0.5 * (from + to));
    const double drop = view.at("drop").number(0.0);
    add(view, makeDuct(from, to, view.at("radius").size(), ceiling - drop));
  }

  /** @brief Reads single boxes and cylinders; z is that of the scene. */
  void readObject(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"name", "boxes", "cylinders"});
    Object object;
    object.name = nameOf(view, "object");
    for (const JsonView& box : view.itemsOf("boxes")) {
      box.allowOnly({"center", "size", "yaw"});
      const Vec3 center = box.at("center").point3();
      object.boxes.push_back({lifted(places.toScene(plan(center)), center.z),
                              box.at("size").size3(), places.yawOf(box)});
    }
    for (const JsonView& cylinder : view.itemsOf("cylinders")) {
      cylinder.allowOnly({"base", "radius", "height"});
      const Vec3 base = cylinder.at("base").point3();
      object.cylinders.push_back({lifted(places.toScene(plan(base)), base.z),
                                  cylinder.at("radius").size(),
                                  cylinder.at("height").size()});
    }
    if (object.boxes.empty() && object.cylinders.empty())
      view.fail("has neither boxes nor cylinders");
    add(view, std::move(object));
  }

  /** @brief Reads objects repeated at several places, each [x, y] or [x, y, yaw]. */
  void readGroup(const JsonView& view, const ObjectPlaces& places)
  {
    view.allowOnly({"places", "objects"});
    if (++depth_ > kDeepestGroup)
      view.fail("is a group too deep within groups");
    const auto list = view.at("objects").items(1);
    for (const JsonView& place : view.at("places").items(1)) {
      ObjectFrame frame;
      const bool is_turned = place.items().size() == 3;
      if (is_turned)
        frame.yaw = place.point3().z * pi / 180.0;
      frame.origin = is_turned ? plan(place.point3()) : place.point2();
      readList(list, places.within(frame));
    }
    --depth_;
  }

  const Room* room_;
  std::vector<Object>& objects_;
  std::size_t parts_ = 0;
  int depth_ = 0;
};

} // namespace

std::vector<Object>
readObjects(const std::vector<JsonView>& list, const Room* room)
{
  std::vector<Object> objects;
  ObjectReader(room, objects).readList(list, ObjectPlaces(room));
  return objects;
}

} // namespace pcl::sedr::sim
