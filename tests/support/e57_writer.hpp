// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scans/formats/crc32c.hpp"

namespace planum::test {

/// One column of an E57 table: its prototype element and its values, packed as the type asks.
struct E57Column {
    std::string element; ///< `<cartesianX type="Float"/>`
    std::string bytes;   ///< the whole byte stream
};

/// Packs integers above `minimum` with `bits` bits each, lowest bit first.
inline std::string pack_bits(std::span<const std::int64_t> values, std::int64_t minimum, unsigned bits) {
    std::string out((values.size() * bits + 7) / 8, '\0');
    std::size_t at = 0;
    for (const std::int64_t value : values) {
        const std::uint64_t raw = static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(minimum);
        for (unsigned b = 0; b < bits; ++b, ++at) {
            if (((raw >> b) & 1U) != 0)
                out[at / 8] = static_cast<char>(static_cast<unsigned char>(out[at / 8]) | (1U << (at % 8)));
        }
    }
    return out;
}

template<class T>
std::string pack_floats(std::span<const double> values) {
    std::string out(values.size() * sizeof(T), '\0');
    for (std::size_t i = 0; i < values.size(); ++i) {
        const T value = static_cast<T>(values[i]);
        std::memcpy(out.data() + i * sizeof(T), &value, sizeof(T));
    }
    return out;
}

inline void put_number(std::string& out, std::uint64_t value, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i)));
}

/// A small E57 file, written from the layout and from nothing of the reader's.
class E57Writer {
  public:
    struct Scan {
        std::vector<E57Column> columns;
        std::uint64_t records = 0;
        std::string extra;               ///< further elements: pose, indexBounds, …
        std::size_t packet_bytes = 3000; ///< of all columns together in one packet, about
    };

    void add_scan(const Scan& scan) {
        pad();
        const std::uint64_t section = logical_.size();
        std::string packets;
        std::vector<std::size_t> taken(scan.columns.size(), 0);
        std::size_t total = 1;
        for (const E57Column& column : scan.columns) total += column.bytes.size();
        while (true) {
            std::string lengths;
            std::string body;
            for (std::size_t i = 0; i < scan.columns.size(); ++i) {
                // Pieces of unlike length, so that the columns drift apart from packet to packet.
                const std::string& bytes = scan.columns[i].bytes;
                const std::size_t piece =
                    std::min(bytes.size() - taken[i], scan.packet_bytes * bytes.size() / total + 7 * i + 1);
                put_number(lengths, piece, 2);
                body += bytes.substr(taken[i], piece);
                taken[i] += piece;
            }
            if (body.empty()) break;
            std::string packet;
            put_number(packet, scan.columns.size(), 2);
            packet += lengths + body;
            while (packet.size() % 4 != 0) packet.push_back('\0');
            packets.push_back('\1');
            packets.push_back('\0');
            put_number(packets, packet.size() + 4 - 1, 2);
            packets += packet;
        }
        logical_.push_back('\1');
        logical_.append(7, '\0');
        put_number(logical_, 32 + packets.size(), 8);
        put_number(logical_, physical(section + 32), 8);
        put_number(logical_, 0, 8);
        logical_ += packets;
        std::string prototype;
        for (const E57Column& column : scan.columns) prototype += column.element;
        scans_ +=
            fmt::format("<vectorChild type=\"Structure\">{}<points type=\"CompressedVector\" fileOffset=\"{}\" "
                        "recordCount=\"{}\">"
                        "<prototype type=\"Structure\">{}</prototype><codecs type=\"Vector\"/></points></vectorChild>",
                        scan.extra, physical(section), scan.records, prototype);
    }

    void add_image(const std::string& bytes, const std::string& type) {
        pad();
        const std::uint64_t section = logical_.size();
        logical_.append(8, '\0');
        put_number(logical_, 16 + bytes.size(), 8);
        logical_ += bytes;
        images_ +=
            fmt::format("<vectorChild type=\"Structure\"><name type=\"String\"><![CDATA[picture]]></name>"
                        "<visualReferenceRepresentation type=\"Structure\"><{}Image type=\"Blob\" fileOffset=\"{}\" "
                        "length=\"{}\"/>"
                        "<imageWidth type=\"Integer\">2</imageWidth><imageHeight type=\"Integer\">1</imageHeight>"
                        "</visualReferenceRepresentation></vectorChild>",
                        type, physical(section), bytes.size());
    }

    [[nodiscard]] std::string finish() {
        pad();
        const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?><e57Root type=\"Structure\" "
                                "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\"><guid "
                                "type=\"String\"><![CDATA[own]]></guid>"
                                "<data3D type=\"Vector\">" +
                                scans_ + "</data3D><images2D type=\"Vector\">" + images_ + "</images2D></e57Root>";
        const std::uint64_t xml_at = logical_.size();
        logical_ += xml;
        logical_.resize((logical_.size() + 1019) / 1020 * 1020, '\0');
        std::string head = "ASTM-E57";
        put_number(head, 1, 4);
        put_number(head, 0, 4);
        put_number(head, logical_.size() / 1020 * 1024, 8);
        put_number(head, physical(xml_at), 8);
        put_number(head, xml.size(), 8);
        put_number(head, 1024, 8);
        std::copy(head.begin(), head.end(), logical_.begin());
        return with_checksums(logical_);
    }

    static std::string with_checksums(const std::string& logical) {
        std::string file;
        file.reserve(logical.size() / 1020 * 1024);
        for (std::size_t at = 0; at < logical.size(); at += 1020) {
            file.append(logical, at, 1020);
            const std::uint32_t crc = scans::crc32c({logical.data() + at, 1020});
            for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<char>(crc >> shift));
        }
        return file;
    }

  private:
    static std::uint64_t physical(std::uint64_t logical) { return logical / 1020 * 1024 + logical % 1020; }

    void pad() {
        while (logical_.size() % 4 != 0) logical_.push_back('\0');
    }

    std::string logical_ = std::string(48, '\0');
    std::string scans_;
    std::string images_;
};

} // namespace planum::test
