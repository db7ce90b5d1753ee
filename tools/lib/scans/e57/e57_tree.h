// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Parses the XML of an E57 file. Throws ToolError for more than 64 MiB, a
 * document type (whose entities may expand), and nesting deeper than 64. */
boost::property_tree::ptree readE57Tree(const E57Pages& pages);

/** @brief Returns the nesting depth of an XML text, at most `limit` + 1. It works
 * without a parser, as a deep text would overflow the parser's stack. */
std::size_t nestingOf(const std::string& xml, std::size_t limit);

} // namespace tools
} // namespace sedr
} // namespace pcl
