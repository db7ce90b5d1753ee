// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_guid.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/string_generator.hpp>
#include <boost/uuid/uuid.hpp>

#include <algorithm>
#include <cstdint>

namespace pcl::sedr::ifc {

std::string
guidText(const unsigned char (&bytes)[16])
{
  constexpr const char* letters =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  std::string text;
  // The first byte gives two letters; every three further bytes give four.
  text += letters[bytes[0] >> 6];
  text += letters[bytes[0] & 63];
  for (int i = 1; i < 16; i += 3) {
    const std::uint32_t three = static_cast<std::uint32_t>(bytes[i]) << 16 |
                                static_cast<std::uint32_t>(bytes[i + 1]) << 8 |
                                bytes[i + 2];
    for (int shift = 18; shift >= 0; shift -= 6)
      text += letters[three >> shift & 63];
  }
  return text;
}

std::string
guidOf(const std::string& name)
{
  // The name space is SEDR's own, a random UUID.
  static const boost::uuids::uuid space =
      boost::uuids::string_generator()("6f1c2a54-3f0b-4c8e-9d27-5b6f0e7a9c31");
  const boost::uuids::uuid uuid = boost::uuids::name_generator_sha1(space)(name);
  unsigned char bytes[16];
  std::copy(uuid.begin(), uuid.end(), bytes);
  return guidText(bytes);
}

} // namespace pcl::sedr::ifc
