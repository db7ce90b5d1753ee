// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstdio>
#include <sstream>
#include <string>

namespace pcl::sedr {

/** @brief Formats a number with six significant digits for a message: std::to_string()
 * writes 1e-300 as 0.000000 and 1e300 with 301 digits. */
inline std::string
numberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/** @brief Returns a text for values as printf() writes it. */
template <typename... Values>
std::string
formatText(const char* format, Values... values)
{
  const int size = std::snprintf(nullptr, 0, format, values...);
  std::string text(static_cast<std::size_t>(size), ' ');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/** @brief Formats a number with fixed decimals, independent of the locale. */
inline std::string
decimalText(double value, int decimals)
{
  char text[400]; // the largest double has 309 digits before its point
  const auto end = std::to_chars(text, text + sizeof text, value,
                                 std::chars_format::fixed, decimals);
  std::string result(text, end.ptr);
  return result.find_first_not_of("-0.") == std::string::npos && result[0] == '-'
             ? result.substr(1)
             : result;
}

/** @brief Formats a share in whole percent. */
inline std::string
percentText(double share)
{
  return decimalText(100 * share, 0) + " %";
}

/** @brief Formats a number with fixed decimals, without trailing zeros. */
inline std::string
shortDecimalText(double value, int decimals)
{
  std::string text = decimalText(value, decimals);
  if (text.find('.') == std::string::npos)
    return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text;
}

/** @brief Checks whether a text is a day of the calendar as ISO 8601 writes it,
 * 2024-05-31. */
inline bool
isDate(const std::string& text)
{
  int year = 0, month = 0, day = 0;
  char rest = 0;
  if (text.size() != 10 || text.find_first_not_of("0123456789-") != std::string::npos ||
      std::sscanf(text.c_str(), "%4d-%2d-%2d%c", &year, &month, &day, &rest) != 3 ||
      month < 1 || month > 12 || day < 1)
    return false;
  const bool is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return day <= (month == 2 ? 28 + is_leap : 30 + (month + month / 8) % 2);
}

} // namespace pcl::sedr
