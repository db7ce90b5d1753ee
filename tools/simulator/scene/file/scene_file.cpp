// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"
#include "json_view.h"
#include "simulator/mesh/scene_mesh.h"
#include "simulator/scene/scene.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace pcl::sedr::sim {

namespace {

void
checkStation(const Scene& scene, const Vec3& station, const std::string& name)
{
  const Vec2 place = plan(station);
  const std::uint32_t number = roomAt(scene, station);
  if (number == 0 || !scene.rooms[number - 1].contains(place))
    fail(name, placeText(place), " is in no room");
  const Room& room = scene.rooms[number - 1];
  if (station.z() <= room.floorAt(place) || station.z() >= room.ceilingAt(place))
    fail(name, placeText(place), " is not between floor and ceiling");
  for (const Object& object : scene.furniture)
    for (const Prism& part : object.parts)
      if (station.z() >= part.low && station.z() <= part.high &&
          loopOf(part.corners).contains(place))
        fail(name, placeText(place), " is in the ", object.name);
}

/** @brief See parseScene(). */
void
checkScene(const Scene& scene)
{
  meshOf(scene);
  for (std::size_t i = 0; i < scene.scanners.size(); ++i)
    for (std::size_t k = 0; k < scene.scanners[i].stations.size(); ++k)
      checkStation(scene, scene.scanners[i].stations[k],
                   placeOf("scanners", i) + ": station " + std::to_string(k));
}

using nlohmann::json;

constexpr const char* kFormat = "sedr-scene";
constexpr std::size_t kVersion = 1;

/** @brief Parses the document; rejects repeated keys, which would hide a value. */
json
parseDocument(const std::string& text)
{
  std::vector<std::set<std::string>> keys; // keys of the open objects
  const auto watch = [&keys](int, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start)
      keys.emplace_back();
    if (event == json::parse_event_t::object_end)
      keys.pop_back();
    if (event == json::parse_event_t::key &&
        !keys.back().insert(value.get<std::string>()).second)
      fail("the key ", value.dump(), " is given twice in one object");
    return true;
  };
  try {
    return json::parse(text, watch);
  }
  catch (const json::exception& error) {
    const std::string reason = error.what();
    const std::size_t start = reason.find("] "); // after the exception's number
    fail("no JSON: ", start == std::string::npos ? reason : reason.substr(start + 2));
  }
}

constexpr std::size_t kMostStations = 10'000;
constexpr std::size_t kMostRays = 100'000'000;
constexpr double kLowest = -1e5; ///< below every room

/** @brief Reads stations at equal steps along a path, at a height above the floor below
 * them; they sway up and down. */
std::vector<Vec3>
readWalk(const JsonView& view, const Scene& scene)
{
  const auto corners = view.at("path").items(2);
  std::vector<Element> legs;
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    legs.push_back(segment(corners[i].point2(), corners[i + 1].point2()));
    total += legs.back().length();
  }
  const std::size_t count = view.at("count").count(1, kMostStations);
  const double height = view.at("height").size();
  const double sway = view.numberOr("sway", 0.0);
  const double floor = view.numberOr("floor", kLowest);
  std::vector<Vec3> stations;
  for (std::size_t i = 0; i < count; ++i) {
    const auto step = static_cast<double>(i);
    double s = total * step / static_cast<double>(std::max<std::size_t>(count, 2) - 1);
    auto leg = legs.begin();
    for (; leg + 1 != legs.end() && s > leg->length(); ++leg)
      s -= leg->length();
    const Vec2 place = leg->pointAt(std::min(s, leg->length()));
    double z = height + sway * std::sin(2.1 * step);
    if (const std::uint32_t room = roomAt(scene, lifted(place, floor)))
      z += scene.rooms[room - 1].floorAt(place);
    stations.push_back(lifted(place, z));
  }
  return stations;
}

std::vector<Vec3>
readStations(const JsonView& view, const Scene& scene)
{
  const auto list = view.find("stations");
  const auto walk = view.find("walk");
  if (list.has_value() == walk.has_value())
    view.fail("must have either \"stations\" or a \"walk\"");
  if (walk)
    return readWalk(*walk, scene);
  std::vector<Vec3> stations;
  for (const JsonView& station : list->items(1))
    stations.push_back(station.point3());
  if (stations.size() > kMostStations)
    list->fail("has more than " + std::to_string(kMostStations) + " stations");
  return stations;
}

Scanner
readScanner(const JsonView& view, const Scene& scene)
{
  Scanner scanner;
  scanner.stations = readStations(view, scene);
  scanner.rays_per_station = view.at("rays").count(1, kMostRays);
  scanner.jitter = view.numberOr("jitter", scanner.jitter, 0.0, 1.0);
  scanner.max_range =
      view.numberOr("max_range", scanner.max_range, JsonView::kSmallest);
  scanner.noise = view.at("noise").number(0.0, 1.0);
  return scanner;
}

Scene
readScene(const JsonView& view)
{
  if (view.at("format").text() != kFormat)
    view.at("format").fail(std::string("must be \"") + kFormat + '"');
  view.at("version").count(kVersion, kVersion);
  Scene scene;
  scene.name = view.at("name").text();
  scene.summary = view.at("summary").text();
  readRooms(view.at("rooms"), scene);
  for (Object& object : readObjects(view.itemsOf("outside"), nullptr))
    scene.outside.push_back(std::move(object));
  for (const JsonView& scanner : view.at("scanners").items(1))
    scene.scanners.push_back(readScanner(scanner, scene));
  if (const auto placement = view.find("placement")) {
    scene.placement.yaw = placement->numberOr("yaw", 0.0);
    if (const auto shift = placement->find("shift"))
      scene.placement.shift = shift->point3();
  }
  return scene;
}

} // namespace

Scene
parseScene(const std::string& text, const std::string& source)
{
  try {
    const json document = parseDocument(text);
    JsonView::Seen seen;
    const JsonView view(document, seen);
    const Scene scene = readScene(view);
    view.rejectUnknownKeys();
    checkScene(scene);
    return scene;
  }
  catch (const std::invalid_argument& error) {
    fail(source, ": ", error.what());
  }
}

std::vector<Scene>
allScenes()
{
  std::vector<Scene> scenes;
  for (const BuiltInScene& scene : builtInScenes())
    scenes.push_back(parseScene(scene.text, scene.name));
  return scenes;
}

std::string
sceneText(const std::string& name_or_path)
{
  if (std::filesystem::path(name_or_path).extension() == ".json") {
    std::ifstream file(name_or_path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf()))
      fail("Cannot read the scene file ", name_or_path);
    return text.str();
  }
  std::string known;
  for (const BuiltInScene& scene : builtInScenes()) {
    if (scene.name == name_or_path)
      return scene.text;
    known += (known.empty() ? "" : ", ") + scene.name;
  }
  fail("There is no scene '", name_or_path, "'; known are ", known,
       ", and files that end in .json");
}

Scene
sceneNamed(const std::string& name_or_path)
{
  return parseScene(sceneText(name_or_path), name_or_path);
}

} // namespace pcl::sedr::sim
