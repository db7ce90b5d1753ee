// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_editor.h>

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace pcl::sedr {

std::string
withNames(const std::string& json, const RoomNames& names)
{
  nlohmann::ordered_json plan = nlohmann::ordered_json::parse(json);
  plan.erase("names");
  for (const auto& [room, name] : names)
    plan["names"][std::to_string(room)] = name;
  return plan.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

RoomNames
namesFromJson(const std::string& json)
{
  RoomNames names;
  const auto plan = nlohmann::json::parse(json, nullptr, false);
  if (plan.is_object() && plan.contains("names") && plan["names"].is_object())
    for (const auto& [room, name] : plan["names"].items())
      if (name.is_string())
        names[static_cast<std::uint32_t>(std::strtoul(room.c_str(), nullptr, 10))] =
            name.get<std::string>();
  return names;
}

} // namespace pcl::sedr
