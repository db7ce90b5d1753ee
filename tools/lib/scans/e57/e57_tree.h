// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <boost/property_tree/ptree.hpp>

namespace pcl::sedr::tools {

/** @brief Parses the XML of an E57 file; attributes are below "<xmlattr>". Throws
 * ToolError for more than 64 MiB, a document type (whose entities may expand), more
 * than 262,144 elements and attributes, and nesting deeper than 64. */
boost::property_tree::ptree readE57Tree(const E57Pages& pages);

} // namespace pcl::sedr::tools
