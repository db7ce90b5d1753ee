// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "tool_error.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <utility>

namespace pcl::sedr::tools {

namespace po = boost::program_options;

namespace {

constexpr std::size_t help_column = 26;
constexpr double vast = 1e9; // larger limits are those of types and not printed

std::string
withUnit(const std::string& unit)
{
  return unit.empty() ? "" : " " + unit;
}

/** @brief Joins `left` and, from a fixed column on, `right`, broken into lines. */
std::string
helpLine(const std::string& left, const std::string& right)
{
  constexpr std::size_t width = 90;
  std::string text = "  " + left;
  text += text.size() + 2 > help_column ? "\n" + std::string(help_column, ' ')
                                        : std::string(help_column - text.size(), ' ');
  std::istringstream words(right);
  std::size_t column = help_column;
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > width) {
      text += "\n" + std::string(help_column, ' ');
      column = help_column;
    }
    text += (column == help_column ? "" : " ") + word;
  }
  return text + "\n";
}

/** @brief Returns Boost's error as a sentence. */
std::string
problemOf(const po::error& error)
{
  if (const auto* unknown = dynamic_cast<const po::unknown_option*>(&error))
    return "there is no option '" + unknown->get_option_name() + "'";
  if (const auto* twice = dynamic_cast<const po::multiple_occurrences*>(&error))
    return "option '" + twice->get_option_name() + "' is given more than once";
  if (const auto* syntax = dynamic_cast<const po::invalid_command_line_syntax*>(&error))
    if (syntax->kind() == po::invalid_syntax::missing_parameter)
      return "option '" + syntax->get_option_name() + "' needs a value";
  return error.what();
}

} // namespace

std::string
Range::text(const std::string& unit) const
{
  const auto number = [&](double value) {
    std::ostringstream text;
    text << value << withUnit(unit);
    return text.str();
  };
  const bool has_low = low > -vast;
  const bool has_high = high < vast;
  if (has_low && has_high)
    return open ? "above " + number(low) + " and at most " + number(high)
                : "from " + number(low) + " to " + number(high);
  if (has_low)
    return (open ? "above " : "at least ") + number(low);
  return has_high ? "at most " + number(high) : "";
}

Options::Options(std::string tool, std::string purpose)
    : tool_(std::move(tool))
    , purpose_(std::move(purpose))
{}

void
Options::file(const std::string& name, std::string& value, const std::string& help)
{
  files_.push_back({name, help, &value, nullptr, true});
}

void
Options::optionalFile(const std::string& name,
                      std::string& value,
                      const std::string& help)
{
  files_.push_back({name, help, &value, nullptr, false});
}

void
Options::files(const std::string& name,
               std::vector<std::string>& values,
               const std::string& help)
{
  files_.push_back({name, help, nullptr, &values, true});
}

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
                   bool whole,
                   const std::string& default_text,
                   const std::function<void(double)>& store)
{
  const std::string allowed = range.text();
  std::string about = help + (unit.empty() ? "" : " [" + unit + "]") + " (";
  about += allowed.empty() ? "" : allowed + "; ";
  about += "default " + default_text + ")";
  const auto read = [=](const std::string& given) {
    char* end = nullptr;
    const double value = std::strtod(given.c_str(), &end);
    if (given.empty() || *end != '\0' || !std::isfinite(value) ||
        (whole && value != std::floor(value)))
      throw ToolError("--" + name + " takes a " + (whole ? "whole " : "") + "number" +
                      (unit.empty() ? "" : " of " + unit) + ", not '" + given + "'");
    if (value > range.high && range.high >= vast) {
      std::ostringstream most;
      most << std::setprecision(std::numeric_limits<double>::max_digits10) << range.high
           << withUnit(unit);
      throw ToolError("--" + name + " must be at most " + most.str() + ", not " +
                      given);
    }
    if (!range.holds(value))
      throw ToolError("--" + name + " must be " + range.text(unit) + ", not " + given);
    store(value);
  };
  options_.push_back({name, about, true, read});
}

void
Options::text(const std::string& name,
              std::string& value,
              const std::string& help,
              const std::vector<std::string>& choices)
{
  std::string about = help + " (";
  about += choices.empty() ? "" : boost::join(choices, ", ") + "; ";
  about += "default " + (value.empty() ? "none" : value) + ")";
  const auto read = [name, &value, choices](const std::string& given) {
    if (!choices.empty() &&
        std::find(choices.begin(), choices.end(), given) == choices.end())
      throw ToolError("--" + name + " is one of " + boost::join(choices, ", ") +
                      ", not '" + given + "'");
    value = given;
  };
  options_.push_back({name, about, true, read});
}

void
Options::flag(const std::string& name, bool& value, const std::string& help)
{
  options_.push_back(
      {name, help, false, [&value](const std::string&) { value = true; }});
}

void
Options::read(const Option& option, const std::string& given) const
{
  const auto hint = hints_.find(option.name);
  try {
    option.read(given);
  }
  catch (const ToolError& error) {
    if (hint == hints_.end())
      throw;
    throw ToolError(error.what() + ("; " + hint->second), error.exitCode());
  }
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
    throw ToolError(problemOf(error) + "; " + tool_ + " -h tells all");
  }
  wants_version_ = given.count("version") != 0;
  if (given.count("help") != 0 || wants_version_)
    return false;

  const auto names = given.count("file") != 0
                         ? given["file"].as<std::vector<std::string>>()
                         : std::vector<std::string>();
  readFiles(names);
  for (const auto& option : options_)
    if (given.count(option.name) != 0)
      read(option, option.takes_value ? given[option.name].as<std::string>() : "");
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
Options::version() const
{
  return tool_ + " (SEDR) " SEDR_VERSION "\n";
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
  help += "\nExit code: 0 done; 1 bad use or unreadable input; 2 read, but nothing "
          "found.\n";
  return help;
}

} // namespace pcl::sedr::tools
