// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief The GlobalId of an IFC object that is known by a name: the name's UUID of
 * version 5 (RFC 4122), in the 22 letters that IFC writes it with. The same name gives
 * the same one, always. */
std::string guidOf(const std::string& name);

/** @brief 16 bytes as IFC writes them: base 64 with letters of its own, the first one
 * of two bits. */
std::string guidText(const unsigned char (&bytes)[16]);

} // namespace ifc
} // namespace sedr
} // namespace pcl
