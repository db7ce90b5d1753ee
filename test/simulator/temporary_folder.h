// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace pcl::sedr::sim::test {

/** @brief An empty folder that is removed with its owner. */
class TemporaryFolder {
public:
  TemporaryFolder()
  {
    std::string name =
        (std::filesystem::temp_directory_path() / ("sedr_test_" + std::string(6, 'X')))
            .string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no temporary folder");
    path_ = name;
  }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/** @brief Returns all bytes of a file; empty if it does not exist. */
inline std::string
bytesOf(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace pcl::sedr::sim::test
