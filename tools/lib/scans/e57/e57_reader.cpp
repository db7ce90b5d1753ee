// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"
#include "run_tool.h"
#include "sedr_filters/src/base/parallel.h"
#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::sedr::tools {

namespace {

[[noreturn]] void
refuseE57(const std::string& path, const std::string& reason)
{
  throw ToolError("cannot read '" + path + "' as E57: " + reason);
}

/** @brief Calls `work`, and names the file in what it throws. */
template <typename Work>
auto
namingFile(const std::string& path, const Work& work)
{
  try {
    return work();
  }
  catch (const ToolError& error) {
    refuseE57(path, error.what());
  }
}

constexpr std::size_t batch = 1024; // rows whose values fit into a fast cache
using Column = std::array<double, batch>;

std::uint8_t
colourByte(double value, const std::pair<double, double>& limits)
{
  constexpr double most = 255;
  const double share = limits.second > limits.first
                           ? (value - limits.first) / (limits.second - limits.first)
                           : value / most;
  const double scaled = std::round(share * most);
  return scaled >= most ? std::uint8_t{255}
         : scaled > 0   ? static_cast<std::uint8_t>(scaled)
                        : std::uint8_t{0};
}

/** @brief Returns the field of each role, null for none. */
std::vector<const E57Field*>
fieldsOf(const E57Scan& scan)
{
  const auto find = [&](const std::string& name) {
    const E57Field* const field = scan.find(name);
    return field && field->kind != E57Field::Kind::Other ? field : nullptr;
  };
  const auto findAll = [&](const std::string& kind, const char* const(&names)[3]) {
    std::vector<const E57Field*> all;
    for (const char* name : names)
      all.push_back(find(kind + name));
    if (std::find(all.begin(), all.end(), nullptr) != all.end())
      all.assign(3, nullptr);
    return all;
  };
  const char* kind = "cartesian";
  std::vector<const E57Field*> fields = findAll(kind, {"X", "Y", "Z"});
  if (!fields[E57Points::X]) {
    kind = "spherical";
    fields = findAll(kind, {"Range", "Azimuth", "Elevation"});
  }
  if (!fields[E57Points::X])
    throw ToolError("its points have neither cartesian nor spherical coordinates");
  fields.push_back(find(std::string(kind) + "InvalidState"));
  fields.push_back(find("intensity"));
  const std::vector<const E57Field*> colour =
      findAll("color", {"Blue", "Green", "Red"});
  fields.insert(fields.end(), colour.begin(), colour.end());
  return fields;
}

void
placePoints(const E57Scan& scan,
            const std::vector<E57Values>& values,
            std::size_t first,
            std::size_t n,
            std::size_t row_size,
            std::uint8_t* rows)
{
  std::array<Column, 3> xyz;
  for (std::size_t axis = 0; axis < 3; ++axis)
    values[axis].read(first, n, xyz[axis].data());
  Column invalid;
  if (values[E57Points::Invalid].field)
    values[E57Points::Invalid].read(first, n, invalid.data());
  const bool is_spherical = values[E57Points::X].field->name == "sphericalRange";
  const Eigen::Matrix3d turn = scan.rotation.toRotationMatrix();
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector3d p(xyz[0][i], xyz[1][i], xyz[2][i]);
    if (is_spherical) {
      const double in_plan = p[0] * std::cos(p[2]);
      p = {in_plan * std::cos(p[1]), in_plan * std::sin(p[1]), p[0] * std::sin(p[2])};
    }
    if (scan.has_pose)
      p = turn * p + scan.translation;
    if (values[E57Points::Invalid].field && invalid[i] != 0)
      p.setConstant(std::numeric_limits<double>::quiet_NaN());
    std::memcpy(rows + i * row_size, p.data(), sizeof p);
  }
}

void
placeColours(const E57Scan& scan,
             const std::vector<E57Values>& values,
             std::size_t first,
             std::size_t n,
             std::size_t row_size,
             std::uint8_t* rows)
{
  Column part;
  for (std::size_t k = 0; k < 3; ++k) {
    values[E57Points::Blue + k].read(first, n, part.data());
    const auto& limits = scan.colour_limits[2 - k]; // red first
    for (std::size_t i = 0; i < n; ++i)
      rows[i * row_size + k] = colourByte(part[i], limits);
  }
  for (std::size_t i = 0; i < n; ++i)
    rows[i * row_size + 3] = 0xff;
}

} // namespace

std::vector<E57Entry>
listE57Scans(const std::string& path)
{
  const auto file = std::make_shared<const InputFile>(path);
  if (!looksLikeE57(*file))
    throw ToolError("'" + path + "' is no E57 file");
  return namingFile(path, [&] { return readE57Scans(E57Pages(file)); });
}

ScanContent
openE57(const InputFilePtr& file, const ScanSettings& settings)
{
  ScanContent content;
  content.points = std::make_unique<E57Reader>(file, settings);
  return content;
}

E57Reader::E57Reader(const InputFilePtr& file, const ScanSettings& settings)
    : path_(file->path())
    , pages_(namingFile(path_, [&] { return std::make_unique<E57Pages>(file); }))
{
  const std::vector<E57Entry> entries =
      namingFile(path_, [&] { return readE57Scans(*pages_); });
  if (entries.empty())
    refuseE57(path_, "it holds no scan");
  if (settings.scan > entries.size())
    throw ToolError("'" + path_ + "' has no scan " + std::to_string(settings.scan) +
                    ", it holds " + std::to_string(entries.size()));
  for (const E57Entry& entry : entries)
    if (settings.scan == 0 || entry.scan.number == settings.scan)
      open(entry, settings.skip_broken);
  for (const E57Entry& entry : entries)
    if (settings.scan == 0 && !scans_.empty() && entry.problem.empty() &&
        entry.scan.points == 0)
      warnOnce(entry.scan.title() + " of '" + path_ + "' has 0 points");
  for (const char* axis : {"x", "y", "z"})
    row_.add(axis, pcl::PCLPointField::FLOAT64);
  for (const auto& [role, name] :
       {std::pair(E57Points::Intensity, "intensity"), {E57Points::Blue, "rgb"}})
    if (std::any_of(scans_.begin(), scans_.end(),
                    [role = role](const auto& scan) { return scan->has(role); }))
      row_.add(name, pcl::PCLPointField::FLOAT32);
}

void
E57Reader::open(const E57Entry& entry, bool skip_broken)
{
  try {
    if (!entry.problem.empty())
      throw ToolError(entry.problem);
    if (entry.scan.points == 0)
      return;
    constexpr std::uint64_t most = 0x7fffffff; // of an index
    if (entry.scan.points > most)
      throw ToolError("it is said to have " + std::to_string(entry.scan.points) +
                      " points, more than " + std::to_string(most) +
                      " cannot be indexed");
    auto scan = std::make_unique<const E57Points>(*pages_, entry.scan, size_);
    if (skip_broken)
      scan->streams.check();
    size_ = scan->end;
    scans_.push_back(std::move(scan));
  }
  catch (const ToolError& error) {
    const std::string title = entry.scan.title();
    if (!skip_broken)
      refuseE57(path_, title + ": " + error.what());
    warnOnce(title + " of '" + path_ + "' is left out: " + error.what());
  }
}

void
E57Reader::read(Chunk& chunk) const
{
  const auto& scan = *std::find_if(scans_.begin(), scans_.end(), [&](const auto& one) {
    return chunk.first < one->end;
  });
  chunk.size = std::min(chunk.size, scan->end - chunk.first);
  chunk.rows.assign(chunk.size * row_.size, 0); // where the scan lacks a field
  try {
    scan->read(chunk.first - scan->begin, chunk.size, row_, chunk.rows.data());
  }
  catch (const ToolError& error) {
    refuseE57(path_, scan->scan.title() + ": " + error.what());
  }
}

std::vector<ScanStation>
E57Reader::stations() const
{
  std::vector<ScanStation> stations;
  for (const auto& scan : scans_) {
    if (!scan->scan.has_pose)
      return {};
    stations.push_back({scan->begin, scan->scan.translation, scan->scan.rotation});
  }
  return stations;
}

E57Points::E57Points(const E57Pages& pages, const E57Scan& of, std::size_t first_row)
    : scan(of)
    , begin(first_row)
    , end(first_row + of.points)
    , fields(fieldsOf(scan))
    , streams(pages, scan, fields)
{}

void
E57Points::read(std::size_t first,
                std::size_t size,
                const StoredRow& row,
                std::uint8_t* rows) const
{
  const StoredField* const intensity = has(Intensity) ? row.find("intensity") : nullptr;
  const StoredField* const colour = has(Blue) ? row.find("rgb") : nullptr;
  const std::vector<E57Values> values = streams.read(first, first + size);
  constexpr std::size_t rows_at_once = 16 * batch;
  parallelBlocks(size, rows_at_once, 0, [&](std::size_t from, std::size_t past) {
    Column column;
    for (; from < past; from += batch) {
      const std::size_t n = std::min(batch, past - from);
      std::uint8_t* const to = rows + from * row.size;
      placePoints(scan, values, from, n, row.size, to);
      if (colour)
        placeColours(scan, values, from, n, row.size, to + colour->offset);
      if (!intensity)
        continue;
      values[Intensity].read(from, n, column.data());
      for (std::size_t i = 0; i < n; ++i) {
        const auto value = static_cast<float>(column[i]);
        std::memcpy(to + intensity->offset + i * row.size, &value, sizeof value);
      }
    }
  });
}

} // namespace pcl::sedr::tools
