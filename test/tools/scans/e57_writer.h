// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace programs {

/** A field of the points of an E57 file and its stream. */
struct E57TestField {
  std::string name;
  std::string attributes; ///< of the XML, including the type
  unsigned bits = 0;
  std::vector<std::uint64_t> stored; ///< the bits of each value

  /** Returns a field of float or double values. */
  template <typename T>
  static E57TestField ofReals(const std::string& name, const std::vector<T>& values)
  {
    const bool is_single = sizeof(T) == 4;
    E57TestField field{name,
                       is_single ? "type=\"Float\" precision=\"single\""
                                 : "type=\"Float\"",
                       8 * sizeof(T),
                       {}};
    for (const T value : values)
      std::memcpy(&field.stored.emplace_back(0), &value, sizeof value);
    return field;
  }

  /** Returns a field of whole numbers from `minimum` to `maximum`.
   * @param scaling such as `scale="0.001" offset="5"`; empty: Integer */
  static E57TestField ofIntegers(const std::string& name,
                                 const std::vector<std::int64_t>& values,
                                 std::int64_t minimum,
                                 std::int64_t maximum,
                                 const std::string& scaling = "")
  {
    E57TestField field{name,
                       std::string("type=\"") +
                           (scaling.empty() ? "Integer" : "ScaledInteger") +
                           "\" minimum=\"" + std::to_string(minimum) + "\" maximum=\"" +
                           std::to_string(maximum) + "\" " + scaling,
                       0,
                       {}};
    const auto low = static_cast<std::uint64_t>(minimum);
    for (std::uint64_t range = static_cast<std::uint64_t>(maximum) - low; range > 0;
         range >>= 1)
      ++field.bits;
    for (const std::int64_t value : values)
      field.stored.push_back(static_cast<std::uint64_t>(value) - low);
    return field;
  }

  std::string stream() const
  {
    std::string bytes((stored.size() * bits + 7) / 8, '\0');
    for (std::size_t i = 0; i < stored.size(); ++i)
      for (unsigned b = 0; b < bits; ++b)
        if ((stored[i] >> b & 1) != 0) {
          const std::size_t at = i * bits + b;
          bytes[at / 8] = static_cast<char>(bytes[at / 8] | 1 << at % 8);
        }
    return bytes;
  }
};

/** Writes E57 files for tests, bit by bit according to the standard. */
class E57Writer {
public:
  std::size_t packet_bytes = 1000; ///< approximate bytes of the streams in a packet
  bool is_uneven = false; ///< true: streams end at different points in each packet
  bool has_index = false; ///< true: adds index and empty packets
  std::string extra_xml;  ///< of the root element

  /** @param inner_xml pose, limits, ... */
  void addScan(const std::string& name,
               const std::vector<E57TestField>& fields,
               const std::string& inner_xml = "",
               long long claimed_points = -1)
  {
    const std::uint64_t section = bytes_.size();
    std::string packets = packetsOf(fields);
    put<std::uint64_t>(1); // the kind of section, and reserved bytes
    put<std::uint64_t>(32 + packets.size());
    put<std::uint64_t>(physical(section + 32));
    put<std::uint64_t>(0);
    bytes_ += packets;
    const auto points = claimed_points >= 0 ? static_cast<std::size_t>(claimed_points)
                                            : fields.front().stored.size();
    xml_ << "<vectorChild type=\"Structure\"><name type=\"String\"><![CDATA[" << name
         << "]]></name>" << inner_xml
         << "<points type=\"CompressedVector\" fileOffset=\"" << physical(section)
         << "\" recordCount=\"" << points << "\"><prototype type=\"Structure\">";
    for (const E57TestField& field : fields)
      xml_ << '<' << field.name << ' ' << field.attributes << "/>";
    xml_ << "</prototype></points></vectorChild>";
  }

  static std::string
  pose(double w, double x, double y, double z, double tx, double ty, double tz)
  {
    std::ostringstream xml;
    xml.precision(17);
    const auto number = [&](const char* name, double value) {
      xml << '<' << name << " type=\"Float\">" << value << "</" << name << '>';
    };
    xml << "<pose type=\"Structure\"><rotation type=\"Structure\">";
    number("w", w);
    number("x", x);
    number("y", y);
    number("z", z);
    xml << "</rotation><translation type=\"Structure\">";
    number("x", tx);
    number("y", ty);
    number("z", tz);
    xml << "</translation></pose>";
    return xml.str();
  }

  /** Returns the whole file. */
  std::string file() const
  {
    return fileWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root "
                    "type=\"Structure\" xmlns=\"http://www.astm.org/COMMIT/E57/"
                    "2010-e57-v1.0\"><data3D type=\"Vector\">" +
                    xml_.str() + "</data3D>" + extra_xml + "</e57Root>");
  }

  /** Returns the file with another XML. */
  std::string fileWith(const std::string& xml) const
  {
    std::string logical = bytes_ + xml;
    const std::uint64_t pages = (logical.size() + payload - 1) / payload;
    logical.resize(pages * payload, '\0');
    std::string head = "ASTM-E57";
    const auto add = [&head](auto value) {
      head.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    add(std::uint32_t{1});
    add(std::uint32_t{0});
    add(pages * page);
    add(physical(bytes_.size()));
    add(std::uint64_t{xml.size()});
    add(page);
    logical.replace(0, head.size(), head);
    std::string whole;
    for (std::uint64_t p = 0; p < pages; ++p)
      whole += sealed(logical.substr(p * payload, payload));
    return whole;
  }

  /** Returns a page's bytes followed by their checksum from Boost.CRC. */
  static std::string sealed(std::string bytes)
  {
    boost::crc_optimal<32, 0x1edc6f41, 0xffffffff, 0xffffffff, true, true> crc;
    crc.process_bytes(bytes.data(), bytes.size());
    const std::uint32_t sum = crc.checksum();
    for (int k = 3; k >= 0; --k)
      bytes += static_cast<char>(sum >> 8 * k & 0xff);
    return bytes;
  }

  static constexpr std::uint64_t page = 1024;
  static constexpr std::uint64_t payload = page - 4;

private:
  static std::uint64_t physical(std::uint64_t logical)
  {
    return logical / payload * page + logical % payload;
  }

  template <typename T>
  void put(T value)
  {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  static void putShort(std::string& bytes, std::size_t value)
  {
    bytes += static_cast<char>(value & 0xff);
    bytes += static_cast<char>(value >> 8 & 0xff);
  }

  static void fillUp(std::string& packet)
  {
    packet.resize((packet.size() + 3) / 4 * 4, '\0');
    packet[2] = static_cast<char>((packet.size() - 1) & 0xff);
    packet[3] = static_cast<char>((packet.size() - 1) >> 8 & 0xff);
  }

  std::string packetsOf(const std::vector<E57TestField>& fields) const
  {
    std::vector<std::string> streams;
    std::vector<std::size_t> done(fields.size(), 0); // written bytes of each
    std::size_t total = 0;
    for (const E57TestField& field : fields) {
      streams.push_back(field.stream());
      total += streams.back().size();
    }
    const std::size_t packets = std::max<std::size_t>(1, total / packet_bytes);
    std::string all;
    for (std::size_t p = 0; total > 0; ++p) {
      std::string packet("\1\0\0\0", 4);
      std::string content;
      putShort(packet, fields.size());
      for (std::size_t f = 0; f < fields.size(); ++f) {
        const std::size_t left = streams[f].size() - done[f];
        std::size_t part = p < packets ? left / (packets - p) : left;
        if (is_uneven && p % fields.size() == f)
          part /= 3;
        if (p + 1 >= packets)
          part = left;
        part = std::min<std::size_t>(part, 60000 / fields.size());
        putShort(packet, part);
        content += streams[f].substr(done[f], part);
        done[f] += part;
        total -= part;
      }
      packet += content;
      fillUp(packet);
      all += packet;
      if (has_index && p % 3 == 1) {
        std::string other(std::string("\0\0\0\0\1", 5) + std::string(27, '\0'));
        fillUp(other);
        std::string empty("\2\0\0\0\0\0\0\0", 8);
        fillUp(empty);
        all += other + empty;
      }
    }
    return all;
  }

  std::string bytes_ = std::string(48, '\0');
  std::ostringstream xml_;
};

} // namespace programs
