// SPDX-License-Identifier: BSD-3-Clause
#include "e57_reader.h"

#include "run_tool.h"
#include "tool_error.h"

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

} // namespace pcl::sedr::tools
