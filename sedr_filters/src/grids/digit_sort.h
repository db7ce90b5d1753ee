// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::sedr {

/** @brief Sorts values by 32-bit keys with a stable radix sort. O(n) in time, with
 * memory for a second copy; sorted values are left as they are.
 * @param keyOf e.g. `[](const Candidate& c) { return orderOf(c.z); }` */
template <typename Value, typename KeyOf>
void
sortByDigits(std::vector<Value>& values, KeyOf keyOf)
{
  constexpr unsigned bits = 11;
  constexpr std::size_t digits = 3;
  const auto digitOf = [&](const Value& value, std::size_t digit) {
    return keyOf(value) >> bits * digit & ((1u << bits) - 1);
  };
  if (std::is_sorted(values.begin(), values.end(), [&](const Value& a, const Value& b) {
        return keyOf(a) < keyOf(b);
      }))
    return;
  std::vector<std::array<std::size_t, 1u << bits>> counts(digits);
  for (const Value& value : values)
    for (std::size_t d = 0; d < digits; ++d)
      ++counts[d][digitOf(value, d)];
  std::vector<Value> sorted(values.size());
  for (std::size_t d = 0; d < digits; ++d) {
    auto& place = counts[d];
    if (place[digitOf(values.front(), d)] == values.size())
      continue; // all values share this digit
    std::size_t next = 0;
    for (std::size_t& count : place) {
      const std::size_t own = count;
      count = next;
      next += own;
    }
    for (const Value& value : values)
      sorted[place[digitOf(value, d)]++] = value;
    values.swap(sorted);
  }
}

/** @brief Returns a key that increases with a finite number; the same for 0 and -0. */
inline std::uint32_t
orderOf(float number)
{
  const float value = number + 0.0f; // -0 becomes 0
  std::uint32_t key = 0;
  std::memcpy(&key, &value, sizeof key);
  return (key >> 31) != 0 ? ~key : key | 0x80000000u;
}

} // namespace pcl::sedr
