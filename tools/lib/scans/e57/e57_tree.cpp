// SPDX-License-Identifier: BSD-3-Clause
#include "e57_tree.h"

#include "tool_error.h"

#include <expat.h>

#include <memory>
#include <vector>

namespace pcl::sedr::tools {

namespace {

using Tree = boost::property_tree::ptree;

/** @brief A tree that grows while its text is parsed. */
struct GrowingTree {
  Tree tree;
  std::vector<Tree*> open{&tree}; ///< the element that is read, behind those around it
  std::size_t parts = 0;          ///< elements and attributes
  std::string problem;
  XML_Parser parser = nullptr;

  void refuse(const std::string& reason)
  {
    problem = reason;
    XML_StopParser(parser, XML_FALSE);
  }

  void begin(const char* name, const char** attributes)
  {
    constexpr std::size_t deepest = 64;
    constexpr std::size_t most = std::size_t{1} << 18; // each may take 400 bytes
    if (open.size() > deepest)
      return refuse("the elements of its XML are nested deeper than " +
                    std::to_string(deepest));
    Tree& element = open.back()->push_back({name, Tree()})->second;
    open.push_back(&element);
    if (*attributes)
      element.push_back({"<xmlattr>", Tree()});
    for (++parts; *attributes; attributes += 2, ++parts)
      element.front().second.push_back({attributes[0], Tree(attributes[1])});
    if (parts > most)
      refuse("its XML has more than " + std::to_string(most) +
             " elements and attributes");
  }
};

GrowingTree&
growing(void* data)
{
  return *static_cast<GrowingTree*>(data);
}

/** @param encoding null: as the text says, or UTF-8 */
GrowingTree
parsed(const std::string& xml, const char* encoding)
{
  GrowingTree result;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(encoding), &XML_ParserFree);
  result.parser = parser.get();
  XML_SetUserData(parser.get(), &result);
  XML_SetElementHandler(
      parser.get(),
      [](void* data, const char* name, const char** attributes) {
        growing(data).begin(name, attributes);
      },
      [](void* data, const char*) { growing(data).open.pop_back(); });
  XML_SetCharacterDataHandler(parser.get(), [](void* data, const char* text, int size) {
    growing(data).open.back()->data().append(text, static_cast<std::size_t>(size));
  });
  XML_SetStartDoctypeDeclHandler(parser.get(), [](void* data, const char*, const char*,
                                                  const char*, int) {
    growing(data).refuse("its XML defines a document type, which E57 does not have");
  });
  if (XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), XML_TRUE) ==
          XML_STATUS_ERROR &&
      result.problem.empty())
    result.problem = "line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) +
                     " of its XML cannot be read: " +
                     XML_ErrorString(XML_GetErrorCode(parser.get()));
  return result;
}

} // namespace

Tree
readE57Tree(const E57Pages& pages)
{
  constexpr std::uint64_t largest = std::uint64_t{1} << 26;
  if (pages.xmlSize() > largest)
    throw ToolError("its XML is said to have " + std::to_string(pages.xmlSize()) +
                    " bytes, more than the " + std::to_string(largest) +
                    " that are taken for sane");
  std::string xml(static_cast<std::size_t>(pages.xmlSize()), '\0');
  pages.read(pages.xmlBegin(), xml.size(), xml.data());
  // Some writers include the padding of the last page.
  xml.erase(xml.find_last_not_of(std::string("\0 \t\r\n", 5)) + 1);
  GrowingTree result = parsed(xml, nullptr);
  if (!result.problem.empty()) // some write names in the encoding of their machine
    if (GrowingTree other = parsed(xml, "ISO-8859-1"); other.problem.empty())
      return std::move(other.tree);
  throwProblem(result.problem);
  return std::move(result.tree);
}

} // namespace pcl::sedr::tools
