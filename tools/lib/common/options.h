// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The valid values of a numeric option. */
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false; ///< whether `low` itself is excluded

  static Range above(double low)
  {
    return {low, std::numeric_limits<double>::infinity(), true};
  }

  static Range atLeast(double low)
  {
    return {low, std::numeric_limits<double>::infinity(), false};
  }

  static Range between(double low, double high) { return {low, high, false}; }

  bool holds(double value) const
  {
    return (open ? value > low : value >= low) && value <= high;
  }

  /** @brief Returns "above 0", "at least 1", "from 0 to 1"; empty without limits. */
  std::string text(const std::string& unit = "") const;
};

/** @brief The command line of a tool. Every option is declared once, with its unit; the
 * variable's value is the default.
 * @code
 * pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
 * std::string input, output;
 * double leaf = grid.getLeafSize().x();
 * Options options("pcl_parallel_voxel_grid", "Thins a cloud to one point a voxel.");
 * options.file("INPUT.pcd", input, "cloud to thin");
 * options.file("OUTPUT.pcd", output, "thinned cloud");
 * options.number("leaf", leaf, "m", "edge of a voxel", Range::above(0));
 * return runTool(options, argc, argv, [&] { ... return Done; });
 * @endcode
 * An option may begin with one dash, as in PCL's programs. Errors in a command line are
 * thrown as ToolError with one sentence. */
class Options {
public:
  Options(std::string tool, std::string purpose);

  /** @brief Declares a required file or folder; the order of calls is that of the
   * arguments. */
  void file(const std::string& name, std::string& value, const std::string& help);

  /** @brief Declares an optional last file; excludes files(). */
  void
  optionalFile(const std::string& name, std::string& value, const std::string& help);

  /** @brief Declares a list of one or more files or folders at this position among
   * those of file(). At most one list is allowed. */
  void files(const std::string& name,
             std::vector<std::string>& values,
             const std::string& help);

  /** @brief Declares a number, `--name 0.05`, of the type of `value`; `unit` may be
   * empty. */
  template <typename NumberT>
  void number(const std::string& name,
              NumberT& value,
              const std::string& unit,
              const std::string& help,
              Range range = Range())
  {
    addNumber<NumberT>(name, unit, help, range, textOf(static_cast<double>(value)),
                       [&value](NumberT v) { value = v; });
  }

  /** @brief Declares a number that a stage holds: `get` returns the default, `set`
   * takes what is given, in units of `scale`. Both are members of the stage. */
  template <typename StageT, typename GetT, typename SetT>
  void parameter(const std::string& name,
                 StageT& stage,
                 GetT get,
                 SetT set,
                 const std::string& unit,
                 const std::string& help,
                 Range range = Range(),
                 double scale = 1)
  {
    using NumberT = std::decay_t<decltype((stage.*get)())>;
    addNumber<NumberT>(name, unit, help, range,
                       textOf(static_cast<double>((stage.*get)()) / scale),
                       [&stage, set, scale](NumberT v) {
                         if constexpr (std::is_floating_point<NumberT>::value)
                           v = static_cast<NumberT>(v * scale);
                         (stage.*set)(v);
                       });
  }

  /** @brief Declares --threads and --seed of a stage. */
  template <typename StageT>
  void threads(StageT& stage)
  {
    parameter("threads", stage, &StageT::getNumberOfThreads,
              &StageT::setNumberOfThreads, "", "threads to use, 0 = all processors");
  }
  template <typename StageT>
  void seed(StageT& stage)
  {
    parameter("seed", stage, &StageT::getSeed, &StageT::setSeed, "",
              "seed of the random samples", Range::atLeast(0));
  }

  /** @brief Declares a number without a default; `otherwise` describes its absence in
   * the help. */
  template <typename NumberT>
  void optionalNumber(const std::string& name,
                      std::optional<NumberT>& value,
                      const std::string& unit,
                      const std::string& help,
                      const std::string& otherwise,
                      Range range = Range())
  {
    addNumber<NumberT>(name, unit, help, range, otherwise,
                       [&value](NumberT v) { value = v; });
  }

  /** @brief Declares a text, `--name text`; one of `choices` unless that is empty. */
  void text(const std::string& name,
            std::string& value,
            const std::string& help,
            const std::vector<std::string>& choices = {});

  /** @brief Declares a switch, `--name`, which sets `value`. */
  void flag(const std::string& name, bool& value, const std::string& help);

  /** @brief Adds what every refusal of an option's value ends with. */
  void hint(const std::string& name, const std::string& text) { hints_[name] = text; }

  /** @brief Reads the command line into the variables.
   * @return false if -h, --help or --version was given; answer() then returns the
   * text */
  bool parse(int argc, const char* const* argv);

  /** @brief Returns purpose, usage, files and options with units and defaults. */
  std::string help() const;

  /** @brief Returns name and version, one line. */
  std::string version() const;

  std::string answer() const { return wants_version_ ? version() : help(); }

  const std::string& tool() const { return tool_; }

private:
  struct File {
    std::string name;
    std::string help;
    std::string* value;               ///< null for a list
    std::vector<std::string>* values; ///< null unless a list
    bool is_needed = true;
  };
  struct Option {
    std::string name;
    std::string help; ///< complete, with unit and default
    bool takes_value;
    std::function<void(const std::string&)> read;
  };

  static std::string textOf(double value);

  template <typename NumberT>
  void addNumber(const std::string& name,
                 const std::string& unit,
                 const std::string& help,
                 Range range,
                 const std::string& default_text,
                 const std::function<void(NumberT)>& store)
  {
    static_assert(std::is_arithmetic<NumberT>::value, "an option of numbers");
    constexpr bool whole = std::is_integral<NumberT>::value;
    range.low = std::max(range.low,
                         static_cast<double>(std::numeric_limits<NumberT>::lowest()));
    // Up to 2^53, doubles represent all integers.
    range.high =
        std::min({range.high, static_cast<double>(std::numeric_limits<NumberT>::max()),
                  whole ? 9007199254740992.0 : range.high});
    addNumber(name, unit, help, range, whole, default_text,
              [store](double v) { store(static_cast<NumberT>(v)); });
  }

  void addNumber(const std::string& name,
                 const std::string& unit,
                 const std::string& help,
                 const Range& range,
                 bool whole,
                 const std::string& default_text,
                 const std::function<void(double)>& store);

  void read(const Option& option, const std::string& given) const;

  std::string usage() const;

  /** @brief Assigns the file names of the command line. */
  void readFiles(const std::vector<std::string>& names) const;

  std::string tool_;
  std::string purpose_;
  std::vector<File> files_;
  std::vector<Option> options_;
  std::map<std::string, std::string> hints_;
  bool wants_version_ = false;
};

} // namespace pcl::sedr::tools
