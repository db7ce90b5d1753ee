// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr::ifc {

/** @brief Returns the GlobalId for a name: the UUID of version 5 (RFC 4122) in the 22
 * letters of IFC. The same name always gives the same GlobalId. */
std::string guidOf(const std::string& name);

/** @brief Encodes 16 bytes in IFC's own base 64, of which the first letter holds two
 * bits. */
std::string guidText(const unsigned char (&bytes)[16]);

} // namespace pcl::sedr::ifc
