// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace pcl::sedr::benchmark {

/** @brief Formats numbers as std::printf does, as text of at most 95 characters. */
template <typename... Numbers>
std::string
formatted(const char* format, Numbers... numbers)
{
  char text[96];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

} // namespace pcl::sedr::benchmark
