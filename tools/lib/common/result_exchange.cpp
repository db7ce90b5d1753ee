// SPDX-License-Identifier: BSD-3-Clause
#include "result_exchange.h"

#include "run_tool.h"
#include "tool_error.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>
#include <system_error>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

bool
isWithin(const fs::path& folder, const fs::path& name)
{
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  const fs::path parent = fs::weakly_canonical((folder / name).parent_path(), error);
  const auto beyond =
      std::mismatch(whole.begin(), whole.end(), parent.begin(), parent.end()).first;
  return !error && name.is_relative() && name.has_filename() && beyond == whole.end();
}

std::vector<std::string>
writtenFiles(const fs::path& folder)
{
  std::ifstream stream(folder / "report.json", std::ios::binary);
  const auto report = nlohmann::json::parse(stream, nullptr, false);
  std::vector<std::string> names;
  if (!report.is_object() || report.value("format", nlohmann::json()) != "sedr-report")
    return names;
  names.emplace_back("report.html"); // pcl_sedr_report may have made it
  for (const auto& name : report.value("files", nlohmann::json::array()))
    if (name.is_string() && isWithin(folder, name.get<std::string>()))
      names.push_back(fs::path(name.get<std::string>()).lexically_normal().string());
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

constexpr const char* journal_name = "exchange.json";

fs::path
journalOf(const fs::path& folder)
{
  return folder / hidden_folder / journal_name;
}

[[noreturn]] void
fail(const fs::path& folder, const std::string& reason)
{
  throw ToolError(
      "the results in '" + folder.string() +
      "' are partly those of an earlier run, which cannot be mended: " + reason);
}

/** @brief Waits until a file, or the entries of a folder, are on the disk.
 * @return 0 or errno */
int
sync(const fs::path& path)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // Some file systems cannot sync folders.
  const int problem = file < 0 || (fsync(file) != 0 && errno != EINVAL) ? errno : 0;
  if (file >= 0)
    close(file);
  return problem;
}

void
syncOrThrow(const fs::path& path)
{
  if (const int problem = sync(path); problem != 0)
    throw ToolError("cannot write '" + path.string() + "': " + std::strerror(problem));
}

/** @brief Returns the folders of files, and the one in which all are. */
std::set<fs::path>
foldersOf(const fs::path& folder, const std::vector<std::string>& names)
{
  std::set<fs::path> folders{folder};
  for (const auto& name : names)
    folders.insert((folder / name).parent_path());
  return folders;
}

/** @brief Returns whether the report in a folder tells of edits by hand. */
bool
isEdited(const fs::path& folder)
{
  std::ifstream stream(folder / "report.json", std::ios::binary);
  const auto report = nlohmann::json::parse(stream, nullptr, false);
  return report.is_object() && !report.value("edits", nlohmann::json()).empty();
}

/** @brief Keeps a plan that is newer than the report of its run, or edited by hand, as
 * floorplan.json~, or floorplan.json~~ if there is one already, ... */
void
keepEdited(const fs::path& folder)
{
  const std::string name = "floorplan.json";
  std::error_code error;
  const auto written = fs::last_write_time(folder / "report.json", error);
  if (error ||
      !(fs::last_write_time(folder / name, error) > written || isEdited(folder)))
    return;
  std::string kept = name + "~";
  while (fs::exists(fs::symlink_status(folder / kept, error)))
    kept += "~";
  const std::string edited =
      "'" + (folder / name).string() + "' was changed after the run before";
  if (rename((folder / name).c_str(), (folder / kept).c_str()) != 0)
    fail(folder, edited + " and cannot be kept: " + std::strerror(errno));
  warnOnce(edited + ": it is kept as " + kept + "; copied over " + name +
           " it comes back, and pcl_floorplan_edit writes the rest anew");
}

/** @brief Returns names of a journal, which anybody may have written. */
std::vector<std::string>
namesOf(const fs::path& folder, const nlohmann::json& journal, const char* key)
{
  std::vector<std::string> names;
  for (const auto& name : journal.value(key, nlohmann::json::array()))
    if (!name.is_string() || !isWithin(folder, name.get<std::string>()))
      fail(folder, "'" + journalOf(folder).string() + "' names a file elsewhere");
    else
      names.push_back(name);
  return names;
}

/** @brief Finishes an exchange under the lock of the hidden folder, which is waited for
 * while the run itself goes on with it. */
void
finishOfKilledRun(const fs::path& folder)
{
  const fs::path part = folder / hidden_folder;
  const int lock = open(part.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const std::unique_ptr<const int, void (*)(const int*)> closing(
      &lock, [](const int* file) { close(*file); });
  if (lock < 0 || flock(lock, LOCK_EX) != 0)
    fail(folder, std::strerror(errno));
  if (faccessat(lock, journal_name, F_OK, 0) != 0)
    return;
  finishExchange(folder);
  std::error_code error;
  fs::remove_all(part, error);
}

} // namespace

void
beginExchange(const fs::path& folder,
              const std::vector<std::string>& moved,
              const std::vector<std::string>& removed)
{
  const fs::path part = folder / hidden_folder;
  for (const auto& name : moved)
    syncOrThrow(part / name);
  const fs::path draft = part / "exchange.part";
  std::ofstream stream(draft, std::ios::binary);
  stream << nlohmann::json{{"moved", moved}, {"removed", removed}};
  stream.close();
  if (!stream)
    throw ToolError("cannot write '" + draft.string() + "': the disk may be full");
  syncOrThrow(draft);
  for (const fs::path& each : foldersOf(part, moved))
    syncOrThrow(each);
  if (rename(draft.c_str(), journalOf(folder).c_str()) != 0)
    throw ToolError("cannot write '" + journalOf(folder).string() +
                    "': " + std::strerror(errno));
  sync(part); // a failure now must not undo the decision
}

bool
isExchangeBegun(const fs::path& folder)
{
  return access(journalOf(folder).c_str(), F_OK) == 0;
}

void
finishExchange(const fs::path& folder)
{
  const fs::path part = folder / hidden_folder;
  std::ifstream stream(journalOf(folder), std::ios::binary);
  const auto journal = nlohmann::json::parse(stream, nullptr, false);
  if (!journal.is_object())
    fail(folder, "'" + journalOf(folder).string() + "' is no journal of pcl_sedr");
  std::vector<std::string> moved = namesOf(folder, journal, "moved");
  // The report is the last, as it tells when the old results were written.
  std::stable_partition(moved.begin(), moved.end(),
                        [](const auto& name) { return name != "report.json"; });
  const std::vector<std::string> removed = namesOf(folder, journal, "removed");
  std::error_code error;
  const auto isKept = [](const std::string& name) { return name.back() == '~'; };
  const bool is_edit = std::any_of(moved.begin(), moved.end(), isKept) ||
                       std::any_of(removed.begin(), removed.end(), isKept);
  if (!is_edit && // which keeps the plan before by itself
      (fs::exists(part / "floorplan.json", error) ||
       std::count(removed.begin(), removed.end(), "floorplan.json") > 0))
    keepEdited(folder);
  for (const auto& name : moved) {
    if (!fs::exists(part / name, error))
      continue; // it has been moved
    fs::create_directories((folder / name).parent_path(), error);
    if (rename((part / name).c_str(), (folder / name).c_str()) != 0)
      fail(folder, std::strerror(errno));
  }
  for (const auto& name : removed)
    unlink((folder / name).c_str());
  for (const fs::path& each : foldersOf(folder, removed))
    if (each != folder)
      rmdir(each.c_str()); // only if it is empty
  for (const fs::path& each : foldersOf(folder, moved))
    sync(each);
  if (unlink(journalOf(folder).c_str()) != 0 && errno != ENOENT)
    fail(folder, std::strerror(errno));
}

void
finishExchanges(const std::vector<std::string>& arguments)
{
  for (const std::string& argument : arguments)
    for (const fs::path& folder :
         {fs::path(argument),
          fs::absolute(fs::path(argument) / "..").lexically_normal()})
      if (isExchangeBegun(folder))
        finishOfKilledRun(folder);
}

} // namespace pcl::sedr::tools
