// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

/** @brief Vectors are arrays of numbers. */
template <int size>
struct nlohmann::adl_serializer<Eigen::Matrix<double, size, 1>> {
  using Vector = Eigen::Matrix<double, size, 1>;

  static void to_json(nlohmann::ordered_json& json, const Vector& vector)
  {
    json = std::vector<double>(vector.data(), vector.data() + size);
  }

  static void from_json(const nlohmann::ordered_json& json, Vector& vector)
  {
    if (!json.is_array() || json.size() != std::size_t{size})
      throw std::invalid_argument(std::to_string(size) + " numbers are needed, not " +
                                  json.dump());
    for (std::size_t k = 0; k < std::size_t{size}; ++k)
      vector[static_cast<Eigen::Index>(k)] = json.at(k).get<double>();
  }
};

namespace pcl::sedr {

/** @brief Name and version of the format of floorplan.json. Versions 1 (with level
 * ceilings and vertical walls only) and 2 may have doorways beside openings. */
constexpr const char* floorplan_format_name = "sedr-floorplan";
constexpr int floorplan_format_version = 3;

/** @brief Reads the origin of a plan or a report.json; (0, 0, 0) if there is none.
 * @return false if there is an origin that is not three numbers */
bool readOrigin(const nlohmann::ordered_json& json, Origin& origin);

/** @brief Writes how a scan was levelled; angles in degrees. */
nlohmann::ordered_json levellingToJson(const Levelling& levelling);

/** @brief Reads an integer of at least `least` that fits 32 bits. */
std::uint32_t
wholeFrom(const nlohmann::ordered_json& json, std::uint32_t least, const char* what);

std::vector<std::uint32_t> roomsFrom(const nlohmann::ordered_json& json,
                                     std::uint32_t least);

template <typename T>
void
readIfThere(const nlohmann::ordered_json& json, const char* name, T& value)
{
  if (json.contains(name))
    value = json.at(name).get<T>();
}

/** @brief Writes stairs. Unknown rooms become 0, outside; stairs from there to there
 * are left out. */
nlohmann::ordered_json stairsToJson(const Floorplan& plan);

/** @brief Adds the doorways of versions 1 and 2, unless they are among the openings or
 * of no size. Their kind is not known. */
void addDoorways(const nlohmann::ordered_json& json, Floorplan& plan);

// The parts of a plan; those that cannot be read throw a std::exception with the
// reason.
void to_json(nlohmann::ordered_json& json, const PlanElement& element);
void to_json(nlohmann::ordered_json& json, const PlanLoop& loop);
void to_json(nlohmann::ordered_json& json, const PlanSlab& slab);
void to_json(nlohmann::ordered_json& json, const PlanNiche& niche);
void to_json(nlohmann::ordered_json& json, const PlanOpening& opening);
void to_json(nlohmann::ordered_json& json, const PlanStorey& storey);
void to_json(nlohmann::ordered_json& json, const PlanStair& stair);
void to_json(nlohmann::ordered_json& json, const PlanFlight& flight);
void from_json(const nlohmann::ordered_json& json, PlanElement& element);
void from_json(const nlohmann::ordered_json& json, PlanLoop& loop);
void from_json(const nlohmann::ordered_json& json, PlanSlab& slab);
void from_json(const nlohmann::ordered_json& json, PlanDetail& detail);
void from_json(const nlohmann::ordered_json& json, PlanNiche& niche);
void from_json(const nlohmann::ordered_json& json, PlanOpening& opening);
void from_json(const nlohmann::ordered_json& json, PlanStorey& storey);
void from_json(const nlohmann::ordered_json& json, PlanStair& stair);
void from_json(const nlohmann::ordered_json& json, PlanFlight& flight);

/** @brief Writes a slab with the members that only facets have. */
nlohmann::ordered_json facetToJson(const PlanSlab& slab);

} // namespace pcl::sedr
