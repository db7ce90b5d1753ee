// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
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

/** @brief The members of a part of a plan, which is written or read in their order: one
 * description serves both. Those that cannot be read throw a std::exception. */
class PartFields {
public:
  /** @brief Writes to an object. */
  explicit PartFields(nlohmann::ordered_json* out)
      : out_(out)
  {}

  /** @brief Reads an object. */
  explicit PartFields(const nlohmann::ordered_json& in)
      : in_(&in)
  {}

  bool areRead() const { return in_ != nullptr; }

  template <typename T>
  void needed(const char* name, T& value)
  {
    areRead() ? static_cast<void>(in_->at(name).get_to(value)) : told(name, value);
  }

  /** @brief A member that keeps its value if it is missing. */
  template <typename T>
  void optional(const char* name, T& value, bool is_written = true)
  {
    if (areRead() ? in_->contains(name) : is_written)
      needed(name, value);
  }

  /** @brief A member that follows from others: it is not read. */
  template <typename T>
  void told(const char* name, const T& value)
  {
    if (!areRead())
      (*out_)[name] = value;
  }

  /** @brief An integer, see wholeFrom(). */
  void
  whole(const char* name, std::uint32_t& value, std::uint32_t least, const char* what);

  /** @brief How the edges of an opening were seen. */
  void edges(std::array<OpeningEdge, 4>& edges);

  /** @brief The ids of the rooms of a storey. */
  void rooms(std::vector<std::uint32_t>& ids);

  /** @brief The ids of both rooms of a thing such as "a stair"; 0: outside. */
  void rooms(std::array<std::uint32_t, 2>& ids, const std::string& of_what);

private:
  nlohmann::ordered_json* out_ = nullptr;
  const nlohmann::ordered_json* in_ = nullptr;
};

void describe(PartFields& fields, ElementEvidence& evidence);
void describe(PartFields& fields, SurfaceAccuracy& accuracy);
void describe(PartFields& fields, PlanElement& element);
void describe(PartFields& fields, PlanSlab& slab);
void describe(PartFields& fields, PlanDetail& detail);
void describe(PartFields& fields, PlanNiche& niche);
void describe(PartFields& fields, OpeningWall& wall);
void describe(PartFields& fields, OpeningEdge& edge);
void describe(PartFields& fields, PlanOpening& opening);
void describe(PartFields& fields, PlanStorey& storey);
void describe(PartFields& fields, PlanStair& stair);
void describe(PartFields& fields, PlanFlight& flight);

template <typename Part,
          typename = decltype(describe(std::declval<PartFields&>(),
                                       std::declval<Part&>()))>
void
to_json(nlohmann::ordered_json& json, Part part)
{
  json = nlohmann::ordered_json::object();
  PartFields fields(&json);
  describe(fields, part);
}

template <typename Part,
          typename = decltype(describe(std::declval<PartFields&>(),
                                       std::declval<Part&>()))>
void
from_json(const nlohmann::ordered_json& json, Part& part)
{
  PartFields fields(json);
  describe(fields, part);
}

void to_json(nlohmann::ordered_json& json, const PlanLoop& loop);
void from_json(const nlohmann::ordered_json& json, PlanLoop& loop);

/** @brief Writes stairs. Unknown rooms become 0, outside; stairs from there to there
 * are left out. */
nlohmann::ordered_json stairsToJson(const Floorplan& plan);

/** @brief Adds the doorways of versions 1 and 2, unless they are among the openings or
 * of no size. Their kind is not known. */
void addDoorways(const nlohmann::ordered_json& json, Floorplan& plan);

/** @brief Writes a slab with the members that only facets have. */
nlohmann::ordered_json facetToJson(const PlanSlab& slab);

} // namespace pcl::sedr
