// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scene/scenes.h"

#include "json_view.h"
#include "scene_parts.h"
#include "simulator/check/scene_check.h"

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace pcl::sedr::sim {

namespace {

using nlohmann::json;

constexpr const char* kFormat = "sedr-scene";
constexpr std::size_t kVersion = 1;

/** @brief Parses the document; rejects repeated keys, which would hide a value.
 */
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
      throw std::invalid_argument("the key " + value.dump() +
                                  " is given twice in one object");
    return true;
  };
  try {
    return json::parse(text, watch);
  }
  catch (const json::exception& error) {
    const std::string reason = error.what();
    const std::size_t start = reason.find("] "); // after the exception's number
    throw std::invalid_argument(
        "no JSON: " + (start == std::string::npos ? reason : reason.substr(start + 2)));
  }
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

std::string
readSceneText(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()))
    throw std::invalid_argument("Cannot read the scene file " + path.string());
  return text.str();
}

Scene
parseScene(const std::string& text, const std::string& source)
{
  try {
    const json document = parseDocument(text);
    JsonView::Seen seen;
    const JsonView view(document, seen);
    const Scene scene = readScene(view);
    view.rejectUnknownKeys();
    const auto problems = problemsOf(scene);
    if (!problems.empty())
      throw std::invalid_argument(problems.front());
    return scene;
  }
  catch (const std::invalid_argument& error) {
    throw std::invalid_argument(source + ": " + error.what());
  }
}

} // namespace pcl::sedr::sim
