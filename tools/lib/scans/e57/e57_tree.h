// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The XML of an E57 file as a tree. Refused are more than 64 MiB, a document
 * type (which may define entities that grow), and elements nested deeper than 64. */
boost::property_tree::ptree readE57Tree(const E57Pages& pages);

/** @brief How deep the elements of an XML text are nested, at most `limit` + 1: as much
 * as can be told without a parser, which a deep text would lead out of its stack. */
std::size_t nestingOf(const std::string& xml, std::size_t limit);

} // namespace tools
} // namespace sedr
} // namespace pcl
