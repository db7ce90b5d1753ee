// SPDX-License-Identifier: BSD-3-Clause
#include "e57_tree.h"

#include "tool_error.h"

#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

/** @brief What is known of an XML text before it is parsed. */
struct XmlShape {
  std::size_t nesting = 0;        ///< depth of its elements
  std::size_t parts = 0;          ///< number of its elements and attributes
  bool has_document_type = false; ///< or another declaration outside of comments
};

/** @brief Returns one past the end of `text` from `position` on, or the end of the
 * XML. */
std::size_t
past(const std::string& xml, const char* text, std::size_t position)
{
  const std::size_t found = xml.find(text, position);
  return found == std::string::npos ? xml.size()
                                    : found + std::string::traits_type::length(text);
}

/** @brief Returns one past the `>` that ends the opening tag at `position`, read as
 * rapidxml reads it: quotes within a name are part of it, and others begin a value only
 * behind `=`. Counts its attributes. */
std::size_t
pastOpeningTag(const std::string& xml, std::size_t position, std::size_t& attributes)
{
  const auto isBlank = [](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
  };
  position = std::min(xml.find_first_of(" \t\r\n/>?", position), xml.size());
  char before = 0; // the last one that is no blank
  for (; position < xml.size() && xml[position] != '>'; ++position) {
    const char c = xml[position];
    if (before == '=' && (c == '"' || c == '\'')) {
      position = std::min(xml.find(c, position + 1), xml.size() - 1);
      ++attributes;
    }
    if (!isBlank(c))
      before = c;
  }
  return std::min(position + 1, xml.size());
}

/** @brief Scans an XML text until its nesting exceeds `limit`. */
XmlShape
shapeOf(const std::string& xml, std::size_t limit)
{
  XmlShape shape;
  std::size_t depth = 0;
  const auto begins = [&](std::size_t at, const char* text) {
    return xml.compare(at, std::string::traits_type::length(text), text) == 0;
  };
  for (std::size_t at = xml.find('<');
       at != std::string::npos && shape.nesting <= limit; at = xml.find('<', at)) {
    if (begins(at, "<!--"))
      at = past(xml, "-->", at + 4);
    else if (begins(at, "<![CDATA["))
      at = past(xml, "]]>", at);
    else if (begins(at, "<?"))
      at = past(xml, "?>", at + 2);
    else if (begins(at, "<!")) {
      shape.has_document_type = true;
      at = past(xml, ">", at);
    }
    else if (begins(at, "</")) {
      depth -= std::min<std::size_t>(depth, 1);
      at = past(xml, ">", at);
    }
    else {
      shape.nesting = std::max(shape.nesting, depth + 1);
      ++shape.parts;
      at = pastOpeningTag(xml, at + 1, shape.parts);
      if (at < 2 || xml[at - 2] != '/')
        ++depth;
    }
  }
  return shape;
}

} // namespace

boost::property_tree::ptree
readE57Tree(const E57Pages& pages)
{
  constexpr std::uint64_t largest = std::uint64_t{1} << 26;
  constexpr std::size_t deepest = 64;
  if (pages.xmlSize() > largest)
    throw ToolError("its XML is said to have " + std::to_string(pages.xmlSize()) +
                    " bytes, more than the " + std::to_string(largest) +
                    " that are taken for sane");
  std::string xml(static_cast<std::size_t>(pages.xmlSize()), '\0');
  pages.read(pages.xmlBegin(), xml.size(), xml.data());
  // Some writers include the padding of the last page.
  xml.erase(xml.find_last_not_of(std::string("\0 \t\r\n", 5)) + 1);
  const XmlShape shape = shapeOf(xml, deepest);
  if (shape.has_document_type)
    throw ToolError("its XML defines a document type, which E57 does not have");
  if (shape.nesting > deepest)
    throw ToolError("the elements of its XML are nested deeper than " +
                    std::to_string(deepest));
  // Boost takes up to 400 bytes for an attribute that has four in the file.
  constexpr std::size_t most = std::size_t{1} << 18;
  if (shape.parts > most)
    throw ToolError("its XML has " + std::to_string(shape.parts) +
                    " elements and attributes, more than the " + std::to_string(most) +
                    " that are taken for sane");
  boost::property_tree::ptree tree;
  std::istringstream stream(xml);
  try {
    boost::property_tree::read_xml(stream, tree,
                                   boost::property_tree::xml_parser::no_comments);
  }
  catch (const boost::property_tree::xml_parser_error& error) {
    throw ToolError("line " + std::to_string(error.line()) +
                    " of its XML cannot be read: " + error.message());
  }
  return tree;
}

} // namespace pcl::sedr::tools
