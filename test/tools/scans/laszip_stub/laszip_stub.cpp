// SPDX-License-Identifier: BSD-3-Clause
// A substitute for LASzip: "unpacks" a file that is marked as packed but is not.
#include "laszip/laszip_api.h"

#include <cstring>
#include <string>

namespace {

struct Stub {
  std::istream* stream = nullptr;
  std::uint32_t begin = 0;
  std::uint16_t record = 0;
  std::uint8_t format = 0;
  laszip_I64 next = 0;
  laszip_point point{};
  std::string error;
};

Stub&
of(laszip_POINTER pointer)
{
  return *static_cast<Stub*>(pointer);
}

template <typename T>
T
numberAt(std::istream& stream, std::streamoff place)
{
  T value{};
  stream.seekg(place);
  stream.read(reinterpret_cast<char*>(&value), sizeof value);
  return value;
}

laszip_I32
fail(Stub& stub, const char* reason)
{
  stub.error = reason;
  return 1;
}

} // namespace

laszip_I32
laszip_create(laszip_POINTER* pointer)
{
  *pointer = new Stub;
  return 0;
}

laszip_I32
laszip_destroy(laszip_POINTER pointer)
{
  delete static_cast<Stub*>(pointer);
  return 0;
}

laszip_I32
laszip_get_error(laszip_POINTER pointer, laszip_CHAR** error)
{
  *error = &of(pointer).error[0];
  return 0;
}

laszip_I32
laszip_open_reader_stream(laszip_POINTER pointer,
                          std::istream& stream,
                          laszip_BOOL* is_compressed)
{
  Stub& stub = of(pointer);
  stub.stream = &stream;
  stub.begin = numberAt<std::uint32_t>(stream, 96);
  stub.format = numberAt<std::uint8_t>(stream, 104);
  stub.record = numberAt<std::uint16_t>(stream, 105);
  *is_compressed = 1;
  stream.seekg(0, std::ios_base::end);
  return stream.tellg() > stub.begin ? 0 : fail(stub, "no chunk table");
}

laszip_I32
laszip_get_point_pointer(laszip_POINTER pointer, laszip_point** point)
{
  *point = &of(pointer).point;
  return 0;
}

laszip_I32
laszip_seek_point(laszip_POINTER pointer, laszip_I64 index)
{
  of(pointer).next = index;
  return 0;
}

laszip_I32
laszip_read_point(laszip_POINTER pointer)
{
  Stub& stub = of(pointer);
  constexpr std::uint8_t with_colour = 0x82;
  const std::streamoff place = stub.begin + stub.next * stub.record;
  stub.point.X = numberAt<laszip_I32>(*stub.stream, place);
  stub.point.Y = numberAt<laszip_I32>(*stub.stream, place + 4);
  stub.point.Z = numberAt<laszip_I32>(*stub.stream, place + 8);
  stub.point.intensity = numberAt<laszip_U16>(*stub.stream, place + 12);
  for (int k = 0; k < 3 && stub.format == with_colour; ++k)
    stub.point.rgb[k] = numberAt<laszip_U16>(*stub.stream, place + 20 + 2 * k);
  ++stub.next;
  if (*stub.stream)
    return 0;
  stub.stream->clear();
  return fail(stub, "chunk with index 7 is corrupt");
}

laszip_I32
laszip_close_reader(laszip_POINTER /*pointer*/)
{
  return 0;
}
