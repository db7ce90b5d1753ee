// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "tool_error.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace pcl::sedr::tools {

namespace po = boost::program_options;

namespace {

constexpr double vast = 1e9; // larger limits are those of types and not printed

/** @brief Joins `left` and, from a fixed column on, `right`, broken into lines. */
std::string
helpLine(const std::string& left, const std::string& right)
{
  constexpr std::size_t indent = 26;
  constexpr std::size_t width = 90;
  const std::string margin(indent, ' ');
  std::string text = "  " + left;
  text += text.size() + 2 > indent ? "\n" + margin : margin.substr(text.size());
  std::istringstream words(right);
  std::size_t column = indent;
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > width) {
      text += "\n" + margin;
      column = indent;
    }
    text += (column == indent ? "" : " ") + word;
  }
  return text + "\n";
}

} // namespace

std::string
Range::text(const std::string& unit) const
{
  const auto number = [&](double value) {
    std::ostringstream text;
    text << value << (unit.empty() ? "" : " ") << unit;
    return text.str();
  };
  const bool has_low = low > -vast;
  const bool has_high = high < vast;
  if (has_low && has_high)
    return "from " + number(low) + " to " + number(high);
  if (has_low)
    return (open ? "above " : "at least ") + number(low);
  return has_high ? "at most " + number(high) : "";
}

Options::Options(std::string tool, std::string purpose)
    : tool_(std::move(tool))
    , purpose_(std::move(purpose))
{}

std::string
Options::textOf(double value)
{
  std::ostringstream text;
  text << value; // six digits, so that the float 0.05 is printed as 0.05
  return text.str();
}

void
Options::addNumber(const std::string& name,
                   const std::string& unit,
                   const std::string& help,
                   const Range& range,
                   bool is_whole,
                   const std::string& default_text,
                   const std::function<void(double)>& store)
{
  const std::string allowed = range.text();
  const auto read = [=](const std::string& given) {
    char* end = nullptr;
    const double value = std::strtod(given.c_str(), &end);
    if (given.empty() || *end != '\0' || !std::isfinite(value) ||
        (is_whole && value != std::floor(value)))
      throw ToolError("--" + name + " takes a " + (is_whole ? "whole " : "") +
                      "number" + (unit.empty() ? "" : " of " + unit) + ", not '" +
                      given + "'");
    if (!range.holds(value))
      throw ToolError("--" + name + " must be " +
                      (allowed.empty() ? "smaller" : range.text(unit)) + ", not " +
                      given);
    store(value);
  };
  options_.push_back({name,
                      help + (unit.empty() ? "" : " [" + unit + "]") + " (" + allowed +
                          (allowed.empty() ? "" : "; ") + "default " + default_text +
                          ")",
                      true, read});
}

void
Options::text(const std::string& name,
              std::string& value,
              const std::string& help,
              const std::vector<std::string>& choices)
{
  const std::string allowed = boost::join(choices, ", ");
  const auto read = [name, allowed, &value, choices](const std::string& given) {
    if (!choices.empty() &&
        std::find(choices.begin(), choices.end(), given) == choices.end())
      throw ToolError("--" + name + " is one of " + allowed + ", not '" + given + "'");
    value = given;
  };
  options_.push_back({name,
                      help + " (" + allowed + (allowed.empty() ? "" : "; ") +
                          "default " + (value.empty() ? "none" : value) + ")",
                      true, read});
}

void
Options::flag(const std::string& name, bool& value, const std::string& help)
{
  options_.push_back(
      {name, help, false, [&value](const std::string&) { value = true; }});
}

bool
Options::parse(int argc, const char* const* argv)
{
  po::options_description description;
  description.add_options()("help,h", "")("version", "");
  for (const auto& option : options_)
    option.takes_value
        ? description.add_options()(option.name.c_str(), po::value<std::string>(), "")
        : description.add_options()(option.name.c_str(), "");
  description.add_options()("file", po::value<std::vector<std::string>>(), "");
  po::positional_options_description positions;
  positions.add("file", -1);
  po::variables_map given;
  try {
    // Accepts -leaf for --leaf, like PCL's own programs.
    const int style = (po::command_line_style::default_style |
                       po::command_line_style::allow_long_disguise) &
                      ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv)
                  .options(description)
                  .positional(positions)
                  .style(style)
                  .run(),
              given);
  }
  catch (const po::error& error) {
    throw ToolError(std::string(error.what()) + "; " + tool_ + " -h tells all");
  }
  wants_version_ = given.count("version") != 0;
  if (given.count("help") != 0 || wants_version_)
    return false;
  readFiles(given.count("file") != 0 ? given["file"].as<std::vector<std::string>>()
                                     : std::vector<std::string>());
  for (const auto& option : options_)
    if (given.count(option.name) != 0)
      option.read(option.takes_value ? given[option.name].as<std::string>() : "");
  return true;
}

void
Options::readFiles(const std::vector<std::string>& names) const
{
  if (names.size() < files_.size() && files_[names.size()].is_needed)
    throw ToolError(files_[names.size()].name + " is missing; usage: " + usage());
  std::size_t in_list = names.size() + 1 - std::min(names.size() + 1, files_.size());
  const bool has_list = std::any_of(files_.begin(), files_.end(),
                                    [](const File& file) { return file.values; });
  if (in_list > 1 && !has_list)
    throw ToolError("'" + names[files_.size()] +
                    "' is one argument too many; usage: " + usage());
  auto name = names.begin();
  for (const File& file : files_)
    if (file.value && name != names.end())
      *file.value = *name++;
    else if (file.values)
      for (; in_list > 0; --in_list)
        file.values->push_back(*name++);
}

std::string
Options::usage() const
{
  std::string usage = tool_;
  for (const auto& file : files_)
    usage += file.is_needed ? " " + file.name + (file.values ? "..." : "")
                            : " [" + file.name + "]";
  return options_.empty() ? usage : usage + " [options]";
}

std::string
Options::answer() const
{
  return wants_version_ ? tool_ + " (SEDR) " SEDR_VERSION "\n" : help();
}

std::string
Options::help() const
{
  std::string help = purpose_ + "\n\nUsage: " + usage() + "\n\n";
  for (const auto& file : files_)
    help += helpLine(file.name, file.help);
  help += "\nOptions:\n";
  for (const auto& option : options_)
    help +=
        helpLine("--" + option.name + (option.takes_value ? " arg" : ""), option.help);
  help += helpLine("-h, --help", "prints this");
  help += helpLine("--version", "prints the version");
  return help + "\nExit code: 0 done; 1 bad use or unreadable input; 2 read, but "
                "nothing found.\n";
}

} // namespace pcl::sedr::tools
