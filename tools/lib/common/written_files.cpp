// SPDX-License-Identifier: BSD-3-Clause
#include "written_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

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

} // namespace pcl::sedr::tools
