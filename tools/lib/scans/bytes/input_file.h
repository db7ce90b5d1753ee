// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
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

/** @brief Takes a line from the front of a text. It ends with a line feed, a carriage
 * return, both, or the text.
 * @return false if the text is empty */
bool takeLine(std::string_view& text, std::string_view& line);

/** @brief Reads a file, such as a header, line by line. */
class LineReader {
public:
  explicit LineReader(const InputFile& file, std::size_t begin = 0)
      : file_(file)
      , end_(begin)
  {}

  /** @brief Reads the next line without its end; it is valid until the next call. One
   * of more than a MiB comes in parts. Returns false at the end of the file. */
  bool next(std::string_view& line);

  /** @brief Returns the byte where the next line begins. */
  std::size_t position() const { return end_ - rest_.size(); }

private:
  const InputFile& file_;
  std::string buffer_;
  std::string_view rest_; ///< of the buffer
  std::size_t end_;       ///< byte of the file after the buffer
};

/** @brief Splits a line at blanks and tabs. */
std::vector<std::string_view> wordsOf(std::string_view line);

/** @brief Reads a number as std::from_chars does, but one too large for a double as
 * infinite and one too small as 0. */
std::from_chars_result readNumber(const char* begin, const char* end, double& value);

/** @brief Reads a word that is a number as a whole, of any type. */
template <typename T>
bool
isNumber(std::string_view word, T& value)
{
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

} // namespace pcl::sedr::tools
