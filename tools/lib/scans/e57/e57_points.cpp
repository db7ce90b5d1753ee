// SPDX-License-Identifier: BSD-3-Clause
#include "e57_points.h"

#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr std::size_t batch = 1024; // rows whose values fit into a fast cache
using Column = std::array<double, batch>;

/** @brief Marks the field called `name` as wanted.
 * @return its number among these; -1 if it is missing or cannot be read */
int
want(const E57Scan& scan, const std::string& name, std::vector<std::size_t>& wanted)
{
  const int field = scan.find(name);
  if (field < 0 ||
      scan.fields[static_cast<std::size_t>(field)].kind == E57Field::Kind::Other)
    return -1;
  wanted.push_back(static_cast<std::size_t>(field));
  return static_cast<int>(wanted.size()) - 1;
}

/** @brief As above for three fields, which are all required; else three times -1. */
std::array<int, 3>
wantAll(const E57Scan& scan,
        const std::array<const char*, 3>& names,
        std::vector<std::size_t>& wanted)
{
  const std::size_t before = wanted.size();
  std::array<int, 3> found{};
  for (std::size_t k = 0; k < names.size(); ++k)
    found[k] = want(scan, names[k], wanted);
  if (std::find(found.begin(), found.end(), -1) != found.end()) {
    wanted.resize(before);
    found.fill(-1);
  }
  return found;
}

std::uint8_t
colourByte(double value, const std::pair<double, double>& limits)
{
  constexpr double most = 255;
  const double share = limits.second > limits.first
                           ? (value - limits.first) / (limits.second - limits.first)
                           : value / most;
  const double scaled = std::round(share * most);
  return scaled >= most ? std::uint8_t{255}
         : scaled > 0   ? static_cast<std::uint8_t>(scaled)
                        : std::uint8_t{0};
}

} // namespace

E57Points::Fields
E57Points::fieldsOf(const E57Scan& scan)
{
  Fields fields;
  auto& wanted = fields.wanted;
  fields.xyz = wantAll(scan, {"cartesianX", "cartesianY", "cartesianZ"}, wanted);
  fields.is_spherical = fields.xyz[0] < 0;
  if (fields.is_spherical)
    fields.xyz = wantAll(
        scan, {"sphericalRange", "sphericalAzimuth", "sphericalElevation"}, wanted);
  if (fields.xyz[0] < 0)
    throw ToolError("its points have neither cartesian nor spherical coordinates");
  fields.invalid = want(
      scan, fields.is_spherical ? "sphericalInvalidState" : "cartesianInvalidState",
      wanted);
  fields.intensity = want(scan, "intensity", wanted);
  fields.colour = wantAll(scan, {"colorBlue", "colorGreen", "colorRed"}, wanted);
  return fields;
}

E57Points::E57Points(const E57Pages& pages, const E57Scan& scan, std::size_t first_row)
    : scan_(scan)
    , first_row_(first_row)
    , fields_(fieldsOf(scan))
    , packets_(pages, scan_, fields_.wanted)
{}

void
E57Points::read(std::size_t first,
                std::size_t size,
                const E57Row& row,
                std::uint8_t* rows) const
{
  const std::vector<E57Values> values = packets_.read(first, first + size);
  constexpr std::size_t rows_at_once = 16 * batch;
  parallelBlocks(size, rows_at_once, 0, [&](std::size_t begin, std::size_t end) {
    Column intensity;
    for (; begin < end; begin += batch) {
      const std::size_t n = std::min(batch, end - begin);
      std::uint8_t* const to = rows + begin * row.size;
      placePoints(values, begin, n, row.size, to);
      if (hasColour() && row.colour > 0)
        placeColours(values, begin, n, row.size, to + row.colour);
      if (!hasIntensity() || row.intensity == 0)
        continue;
      values[static_cast<std::size_t>(fields_.intensity)].read(begin, n,
                                                               intensity.data());
      for (std::size_t i = 0; i < n; ++i) {
        const auto value = static_cast<float>(intensity[i]);
        std::memcpy(to + row.intensity + i * row.size, &value, sizeof value);
      }
    }
  });
}

void
E57Points::placePoints(const std::vector<E57Values>& values,
                       std::size_t first,
                       std::size_t n,
                       std::size_t row_size,
                       std::uint8_t* rows) const
{
  std::array<Column, 3> xyz;
  for (std::size_t axis = 0; axis < 3; ++axis)
    values[static_cast<std::size_t>(fields_.xyz[axis])].read(first, n,
                                                             xyz[axis].data());
  Column invalid;
  if (fields_.invalid >= 0)
    values[static_cast<std::size_t>(fields_.invalid)].read(first, n, invalid.data());
  const Eigen::Matrix3d turn = scan_.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector3d p(xyz[0][i], xyz[1][i], xyz[2][i]);
    if (fields_.is_spherical) {
      const double in_plan = p[0] * std::cos(p[2]);
      p = {in_plan * std::cos(p[1]), in_plan * std::sin(p[1]), p[0] * std::sin(p[2])};
    }
    if (scan_.has_pose)
      p = turn * p + scan_.translation;
    if (fields_.invalid >= 0 && invalid[i] != 0)
      p.setConstant(std::numeric_limits<double>::quiet_NaN());
    std::memcpy(rows + i * row_size, p.data(), sizeof p);
  }
}

void
E57Points::placeColours(const std::vector<E57Values>& values,
                        std::size_t first,
                        std::size_t n,
                        std::size_t row_size,
                        std::uint8_t* rows) const
{
  Column part;
  for (std::size_t k = 0; k < fields_.colour.size(); ++k) {
    values[static_cast<std::size_t>(fields_.colour[k])].read(first, n, part.data());
    const auto& limits =
        scan_.colour_limits[fields_.colour.size() - 1 - k]; // red first
    for (std::size_t i = 0; i < n; ++i)
      rows[i * row_size + k] = colourByte(part[i], limits);
  }
  for (std::size_t i = 0; i < n; ++i)
    rows[i * row_size + 3] = 0xff;
}

} // namespace pcl::sedr::tools
