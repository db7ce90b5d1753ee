// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr {

/** @brief Appends the bytes of a value: little-endian, as all platforms of PCL are and
 * PLY, glTF and LAS ask for. */
template <typename T>
void
append(std::string& bytes, const T& value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace pcl::sedr
