// SPDX-License-Identifier: BSD-3-Clause
// The part of LASzip's C interface that the LAZ reader calls, for machines without that
// library: see ../laszip_stub.cpp. Names and types are those of LASzip 3.
#pragma once

#include <cstdint>
#include <istream>

using laszip_BOOL = int;
using laszip_CHAR = char;
using laszip_I32 = std::int32_t;
using laszip_I64 = std::int64_t;
using laszip_U16 = std::uint16_t;
using laszip_POINTER = void*;

struct laszip_point {
  laszip_I32 X;
  laszip_I32 Y;
  laszip_I32 Z;
  laszip_U16 intensity;
  laszip_U16 rgb[4];
};

extern "C" {
laszip_I32 laszip_create(laszip_POINTER* pointer);
laszip_I32 laszip_destroy(laszip_POINTER pointer);
laszip_I32 laszip_get_error(laszip_POINTER pointer, laszip_CHAR** error);
laszip_I32 laszip_get_point_pointer(laszip_POINTER pointer, laszip_point** point);
laszip_I32 laszip_seek_point(laszip_POINTER pointer, laszip_I64 index);
laszip_I32 laszip_read_point(laszip_POINTER pointer);
laszip_I32 laszip_close_reader(laszip_POINTER pointer);
}

laszip_I32 laszip_open_reader_stream(laszip_POINTER pointer,
                                     std::istream& stream,
                                     laszip_BOOL* is_compressed);
