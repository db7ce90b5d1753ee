// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace pcl::sedr::tools {

/** @brief Parses the XML of an E57 file. Throws ToolError for more than 64 MiB, a
 * document type (whose entities may expand), more than 262,144 elements and attributes,
 * and nesting deeper than 64. */
boost::property_tree::ptree readE57Tree(const E57Pages& pages);

/** @brief What is known of an XML text before it is parsed. */
struct XmlShape {
  std::size_t nesting = 0;        ///< depth of its elements
  std::size_t parts = 0;          ///< number of its elements and attributes
  bool has_document_type = false; ///< or another declaration outside of comments
};

/** @brief Scans an XML text until its nesting exceeds `limit`. It works without a
 * parser, as a deep text would overflow the parser's stack. */
XmlShape shapeOf(const std::string& xml, std::size_t limit);

} // namespace pcl::sedr::tools
