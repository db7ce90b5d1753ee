// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace pcl::sedr {

/** @brief Calls `f` with a value of the C++ type of `datatype`, a constant of
 * PCLPointField; does nothing for an unknown type. */
template <typename FunctionT>
void
withFieldType(std::uint8_t datatype, FunctionT f)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return f(std::int8_t{});
  case pcl::PCLPointField::BOOL: // any byte of a file is no bool
  case pcl::PCLPointField::UINT8:
    return f(std::uint8_t{});
  case pcl::PCLPointField::INT16:
    return f(std::int16_t{});
  case pcl::PCLPointField::UINT16:
    return f(std::uint16_t{});
  case pcl::PCLPointField::INT32:
    return f(std::int32_t{});
  case pcl::PCLPointField::UINT32:
    return f(std::uint32_t{});
  case pcl::PCLPointField::INT64:
    return f(std::int64_t{});
  case pcl::PCLPointField::UINT64:
    return f(std::uint64_t{});
  case pcl::PCLPointField::FLOAT32:
    return f(float{});
  case pcl::PCLPointField::FLOAT64:
    return f(double{});
  default:
    return;
  }
}

/** @brief Reads the number at `where`, of type `datatype`; NaN for an unknown type. */
inline double
readField(const std::uint8_t* where, std::uint8_t datatype)
{
  double value = std::numeric_limits<double>::quiet_NaN();
  withFieldType(datatype, [&](auto typed) {
    std::memcpy(&typed, where, sizeof typed);
    value = static_cast<double>(typed);
  });
  return value;
}

/** @brief Writes `value` to `where` as type `datatype`. Integers are rounded to the
 * nearest and clamped to the range; NaN becomes 0. */
inline void
writeField(std::uint8_t* where, std::uint8_t datatype, double value)
{
  withFieldType(datatype, [&](auto typed) {
    using T = decltype(typed);
    constexpr auto low = std::numeric_limits<T>::lowest();
    constexpr auto high = std::numeric_limits<T>::max();
    if constexpr (!std::is_integral<T>::value)
      typed = static_cast<T>(value);
    else if (value >= static_cast<double>(high)) // as a double perhaps above any T
      typed = high;
    else if (value <= static_cast<double>(low))
      typed = low;
    else
      typed = std::isnan(value) ? T{0} : static_cast<T>(std::round(value));
    std::memcpy(where, &typed, sizeof typed);
  });
}

/** @brief Returns the size of a `datatype` in bytes, 0 for an unknown type. */
inline std::size_t
fieldSize(std::uint8_t datatype)
{
  std::size_t size = 0;
  withFieldType(datatype, [&](auto typed) { size = sizeof typed; });
  return size;
}

/** @brief Appends the bytes of a value: little-endian, as all platforms of PCL are and
 * PLY, glTF and LAS ask for. */
template <typename T>
void
appendBytes(std::string& bytes, const T& value)
{
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace pcl::sedr
