// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns whether a name means the standard input: "-". */
inline bool
isStandardInput(const std::string& path)
{
  return path == "-";
}

/** @brief The bytes of a file, read where they are asked for; thread-safe.
 *
 * "-" is the standard input: a file that is redirected into the program is read in
 * place, what comes by a pipe is kept in memory, once per process. Throws ToolError if
 * the file is missing, empty, a folder, or has become shorter than it was. */
class InputFile {
public:
  explicit InputFile(const std::string& path);

  /** @brief Serves bytes that were unpacked from the file called `path`. */
  InputFile(const std::string& path, std::vector<std::uint8_t> unpacked);

  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  std::size_t size() const { return size_; }

  /** @brief Copies `size` bytes from `begin` on, which are within the file. */
  void read(std::size_t begin, std::size_t size, void* to) const;

  /** @brief Returns the number of type T at byte `begin`, in the machine's order. */
  template <typename T>
  T numberAt(std::size_t begin) const
  {
    T number{};
    read(begin, sizeof number, &number);
    return number;
  }

  bool beginsWith(std::string_view text) const;

private:
  std::string path_;
  int file_ = -1; ///< descriptor; -1: unpacked_ holds the bytes
  std::size_t size_ = 0;
  std::vector<std::uint8_t> unpacked_;
};

} // namespace pcl::sedr::tools
