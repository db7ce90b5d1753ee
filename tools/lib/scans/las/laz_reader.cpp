// SPDX-License-Identifier: BSD-3-Clause
// Reads LAZ by the C interface of LASzip; compiled if CMake finds that library.
#include "las_reader.h"
#include "tool_error.h"

#include <laszip/laszip_api.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <mutex>
#include <streambuf>

namespace pcl::sedr::tools {

namespace {

/** @brief A mapped file as the stream that LASzip reads. */
class MappedBytes : public std::streambuf {
public:
  explicit MappedBytes(const MappedFile& file)
  {
    // Reading does not modify the bytes.
    auto* const begin =
        const_cast<char*>(reinterpret_cast<const char*>(file.data())); // NOLINT
    setg(begin, begin, begin + file.size());
  }

protected:
  pos_type seekoff(off_type offset,
                   std::ios_base::seekdir from,
                   std::ios_base::openmode) override
  {
    const off_type base = from == std::ios_base::beg   ? 0
                          : from == std::ios_base::end ? egptr() - eback()
                                                       : gptr() - eback();
    const off_type place = base + offset;
    if (place < 0 || place > egptr() - eback())
      return pos_type(off_type(-1));
    setg(eback(), eback() + place, egptr());
    return pos_type(place);
  }

  pos_type seekpos(pos_type place, std::ios_base::openmode mode) override
  {
    return seekoff(off_type(place), std::ios_base::beg, mode);
  }
};

/** @brief Reads the points of a LAZ file sequentially from any one on. */
class LazStream {
public:
  LazStream(const MappedFile& file, const std::string& path)
      : file_(file)
      , path_(path)
      , bytes_(file)
      , stream_(&bytes_)
  {
    if (laszip_create(&laszip_) != 0)
      throw ToolError("cannot read '" + path_ + "' as LAZ: LASzip does not start");
    laszip_BOOL is_compressed = 0;
    if (laszip_open_reader_stream(laszip_, stream_, &is_compressed) != 0 ||
        laszip_get_point_pointer(laszip_, &point_) != 0) {
      const std::string reason = problem();
      laszip_destroy(laszip_);
      throw ToolError(reason);
    }
  }

  ~LazStream()
  {
    laszip_close_reader(laszip_);
    laszip_destroy(laszip_);
  }

  LazStream(const LazStream&) = delete;
  LazStream& operator=(const LazStream&) = delete;

  /** @brief Returns the number of the next point. */
  std::size_t next() const { return next_; }

  void goTo(std::size_t row)
  {
    if (row != next_)
      check(laszip_seek_point(laszip_, static_cast<laszip_I64>(row)), row);
    next_ = row;
  }

  LasPoint nextPoint()
  {
    check(laszip_read_point(laszip_), next_);
    ++next_;
    LasPoint point;
    point.whole = {point_->X, point_->Y, point_->Z};
    point.intensity = point_->intensity;
    std::copy_n(point_->rgb, point.colour.size(), point.colour.begin());
    return point;
  }

private:
  void check(laszip_I32 result, std::size_t row)
  {
    if (result == 0)
      return;
    next_ = std::numeric_limits<std::size_t>::max(); // not usable to continue
    file_.checkWhole();
    throw ToolError(problem() + ", at point " + std::to_string(row));
  }

  std::string problem() const
  {
    laszip_CHAR* text = nullptr;
    laszip_get_error(laszip_, &text);
    return "cannot read '" + path_ +
           "' as LAZ: LASzip says: " + (text && *text ? text : "nothing");
  }

  const MappedFile& file_;
  std::string path_;
  MappedBytes bytes_;
  std::istream stream_;
  laszip_POINTER laszip_ = nullptr;
  laszip_point* point_ = nullptr;
  std::size_t next_ = 0;
};

/** @brief The points of a LAZ file, see LasRows. Each reading thread uses its own
 * stream, which is kept for the next one. */
class LazReader : public PointReader {
public:
  LazReader(const MappedFile& file, const std::string& path, const LasHeader& header)
      : file_(file)
      , path_(path)
      , header_(header)
      , rows_(header)
  {
    constexpr std::size_t max_looked_at = 10000;
    std::unique_ptr<LazStream> stream = takeStream(0);
    for (std::size_t i = 0;
         header_.colour_offset > 0 && i < std::min(size(), max_looked_at); ++i)
      rows_.lookAt(stream->nextPoint());
    idle_.push_back(std::move(stream));
  }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return rows_.fields();
  }

  std::size_t size() const override { return static_cast<std::size_t>(header_.points); }

  void read(std::size_t first, std::size_t size, std::uint8_t* rows) const override
  {
    std::unique_ptr<LazStream> stream = takeStream(first);
    stream->goTo(first);
    for (std::size_t i = 0; i < size; ++i)
      rows = rows_.write(stream->nextPoint(), rows);
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(stream));
  }

  /** @brief Assumes equal bytes per point. */
  std::size_t placeOf(std::size_t row) const override
  {
    const double share = static_cast<double>(row) / static_cast<double>(size());
    const auto begin = static_cast<std::size_t>(header_.begin);
    return begin + static_cast<std::size_t>(static_cast<double>(file_.size() - begin) *
                                            std::min(share, 1.0));
  }

private:
  /** @brief Returns a stream shortly before a row, or a new one. */
  std::unique_ptr<LazStream> takeStream(std::size_t row) const
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      auto best = idle_.end();
      for (auto at = idle_.begin(); at != idle_.end(); ++at)
        if ((*at)->next() <= row &&
            (best == idle_.end() || (*at)->next() > (*best)->next()))
          best = at;
      if (best == idle_.end() && !idle_.empty())
        best = idle_.begin();
      if (best != idle_.end()) {
        std::unique_ptr<LazStream> stream = std::move(*best);
        idle_.erase(best);
        return stream;
      }
    }
    return std::make_unique<LazStream>(file_, path_);
  }

  const MappedFile& file_;
  std::string path_;
  LasHeader header_;
  LasRows rows_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<LazStream>> idle_;
};

} // namespace

std::shared_ptr<const PointReader>
openLaz(const MappedFile& file, const std::string& path, const LasHeader& header)
{
  return std::make_shared<LazReader>(file, path, header);
}

} // namespace pcl::sedr::tools
