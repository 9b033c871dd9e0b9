// SPDX-License-Identifier: MIT
// E57: docs/formats/e57.md says what is read and what is made of it.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/formats/block_builder.hpp"
#include "scans/formats/e57_fields.hpp"
#include "scans/formats/e57_metadata.hpp"
#include "scans/formats/e57_pages.hpp"
#include "scans/formats/readers.hpp"

namespace planum::scans {

namespace {

constexpr std::size_t kBatch = 2048;                // records decoded at once
constexpr std::size_t kMostWaiting = 256ULL << 20U; // bytes of one field that run ahead of the others

[[noreturn]] void bad(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

/// Goes through the packets of a table and feeds them to its streams.
class PacketReader {
  public:
    PacketReader(const E57Pages& pages, std::uint64_t section_offset, std::vector<E57Stream>& streams)
        : pages_(&pages), streams_(&streams) {
        const std::uint64_t start = pages.logical_of(section_offset);
        std::array<char, 32> head{};
        pages.read(start, head);
        if (head[0] != 1) {
            bad(fmt::format("byte {}: no table of points starts here (section id {}, 1 expected)", section_offset,
                            static_cast<unsigned char>(head[0])));
        }
        const auto length = little_endian<std::uint64_t>(head.data() + 8);
        if (length < head.size() || length > pages.logical_size() - start) {
            bad(fmt::format("byte {}: a table of {} bytes does not fit into the file", section_offset, length));
        }
        end_ = start + length;
        // An empty table may name a place behind the last byte.
        if (length > head.size()) at_ = pages.logical_of(little_endian<std::uint64_t>(head.data() + 16));
        if (length == head.size() || at_ < start + head.size()) at_ = end_;
    }

    /// Feeds the next data packet; false at the end of the table.
    bool next() {
        while (end_ - at_ >= 4 && at_ < end_) {
            std::array<char, 4> head{};
            pages_->read(at_, head);
            const std::uint64_t length = little_endian<std::uint16_t>(head.data() + 2) + 1ULL;
            if (length < 4 || length % 4 != 0 || length > end_ - at_) {
                bad(fmt::format("packet at logical byte {}: length {} is impossible", at_, length));
            }
            const std::uint64_t packet = at_;
            at_ += length;
            if (head[0] == 0 || head[0] == 2) continue; // index, or filling
            if (head[0] != 1) {
                bad(fmt::format("packet at logical byte {}: unknown type {}", packet,
                                static_cast<unsigned char>(head[0])));
            }
            feed(packet, length);
            return true;
        }
        return false;
    }

  private:
    void feed(std::uint64_t packet, std::uint64_t length) {
        buffer_.resize(static_cast<std::size_t>(length));
        pages_->read(packet, buffer_);
        const std::size_t count = length >= 6 ? little_endian<std::uint16_t>(buffer_.data() + 4) : 0;
        if (count != streams_->size()) {
            bad(fmt::format("packet at logical byte {}: {} fields instead of {}", packet, count, streams_->size()));
        }
        std::size_t from = 6 + 2 * count;
        for (std::size_t i = 0; i < count; ++i) {
            if (6 + 2 * i + 2 > buffer_.size())
                bad(fmt::format("packet at logical byte {}: too short for its fields", packet));
            const std::size_t bytes = little_endian<std::uint16_t>(buffer_.data() + 6 + 2 * i);
            if (from > buffer_.size() || bytes > buffer_.size() - from) {
                bad(fmt::format("packet at logical byte {}: its fields are longer than the packet", packet));
            }
            E57Stream& stream = (*streams_)[i];
            if (bytes > 0) std::copy_n(buffer_.data() + from, bytes, stream.append(bytes));
            if (stream.waiting() > kMostWaiting) {
                bad(fmt::format("packet at logical byte {}: field {} runs ahead of the others by more than {} MB",
                                packet, stream.field().name, kMostWaiting >> 20U));
            }
            from += bytes;
        }
    }

    const E57Pages* pages_;
    std::vector<E57Stream>* streams_;
    std::vector<char> buffer_;
    std::uint64_t at_ = 0;
    std::uint64_t end_ = 0;
};

/// Which stream plays which part; nullptr: none does.
struct Parts {
    E57Stream* x = nullptr; ///< or range
    E57Stream* y = nullptr; ///< or azimuth
    E57Stream* z = nullptr; ///< or elevation
    E57Stream* state = nullptr;
    E57Stream* intensity = nullptr;
    E57Stream* intensity_invalid = nullptr;
    std::array<E57Stream*, 3> colour{};
    E57Stream* colour_invalid = nullptr;
    E57Stream* row = nullptr;
    E57Stream* column = nullptr;
    E57Stream* time = nullptr;
    std::vector<E57Stream*> others;
};

Parts parts_of(std::vector<E57Stream>& streams, const E57Cloud& cloud) {
    Parts parts;
    const Columns& has = cloud.header.has;
    const auto slot_of = [&](const std::string& name) -> E57Stream** {
        if (name == (cloud.cartesian ? "cartesianX" : "sphericalRange")) return &parts.x;
        if (name == (cloud.cartesian ? "cartesianY" : "sphericalAzimuth")) return &parts.y;
        if (name == (cloud.cartesian ? "cartesianZ" : "sphericalElevation")) return &parts.z;
        if (name == (cloud.cartesian ? "cartesianInvalidState" : "sphericalInvalidState")) return &parts.state;
        if (has.intensity && name == "intensity") return &parts.intensity;
        if (has.intensity && name == "isIntensityInvalid") return &parts.intensity_invalid;
        if (has.colour && name == "colorRed") return parts.colour.data();
        if (has.colour && name == "colorGreen") return &parts.colour[1];
        if (has.colour && name == "colorBlue") return &parts.colour[2];
        if (has.colour && name == "isColorInvalid") return &parts.colour_invalid;
        if (has.grid && name == "rowIndex") return &parts.row;
        if (has.grid && name == "columnIndex") return &parts.column;
        if (has.time && name == "timeStamp") return &parts.time;
        return nullptr;
    };
    for (E57Stream& stream : streams) {
        E57Stream** slot = slot_of(stream.field().name);
        if (slot != nullptr && *slot == nullptr) {
            *slot = &stream;
        } else {
            parts.others.push_back(&stream);
        }
    }
    return parts;
}

/// One batch of decoded records, column by column.
struct Batch {
    std::array<std::vector<double>, 3> place;
    std::array<std::vector<double>, 3> colour;
    std::vector<double> intensity;
    std::vector<double> time;
    std::vector<std::int64_t> state;
    std::vector<std::int64_t> no_intensity;
    std::vector<std::int64_t> no_colour;
    std::vector<std::int64_t> row;
    std::vector<std::int64_t> column;

    void take(Parts& parts, std::size_t count) {
        values(parts.x, place[0], count);
        values(parts.y, place[1], count);
        values(parts.z, place[2], count);
        for (std::size_t i = 0; i < 3; ++i) values(parts.colour[i], colour[i], count);
        values(parts.intensity, intensity, count);
        values(parts.time, time, count);
        integers(parts.state, state, count);
        integers(parts.intensity_invalid, no_intensity, count);
        integers(parts.colour_invalid, no_colour, count);
        integers(parts.row, row, count);
        integers(parts.column, column, count);
        for (E57Stream* stream : parts.others) stream->skip(count);
    }

  private:
    static void values(E57Stream* stream, std::vector<double>& out, std::size_t count) {
        out.resize(kBatch);
        if (stream != nullptr) stream->take_values(out.data(), count);
    }

    // Absent states read as 0: valid.
    static void integers(E57Stream* stream, std::vector<std::int64_t>& out, std::size_t count) {
        out.resize(kBatch);
        if (stream != nullptr) stream->take_integers(out.data(), count);
    }
};

class E57Reader final : public ScanReader {
  public:
    explicit E57Reader(std::unique_ptr<ByteSource> source) : source_(std::move(source)), pages_(*source_) {
        const E57FileHeader& header = pages_.header();
        E57Metadata metadata =
            parse_e57_xml(pages_.read_string(pages_.logical_of(header.xml_offset), header.xml_length));
        info_.format = ScanFormat::E57;
        info_.variant = "1.0";
        info_.guid = std::move(metadata.guid);
        info_.software = std::move(metadata.software);
        info_.created_at = std::move(metadata.created_at);
        info_.coordinate_system = std::move(metadata.coordinate_system);
        info_.notes = std::move(metadata.notes);
        parts_ = std::move(metadata.clouds);
        images_ = std::move(metadata.images);
        for (const E57Image& image : images_) info_.images.push_back(image.header);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            try {
                check_table(parts_[i]);
                if (parts_[i].header.has.grid && !parts_[i].grid_stated) find_grid(i);
            } catch (Error& e) {
                e.add_context(fmt::format("scan {}", i + 1));
                throw;
            }
            clouds_.push_back(parts_[i].header);
        }
    }

  protected:
    ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress) override {
        try {
            return read_table(parts_[cloud], sink, options, progress);
        } catch (Error& e) {
            e.add_context(fmt::format("scan {}", cloud + 1));
            throw;
        }
    }

    [[nodiscard]] std::string read_image_bytes(std::size_t image) const override;

  private:
    void check_table(const E57Cloud& cloud) const;
    void find_grid(std::size_t cloud);
    ReadSummary read_table(const E57Cloud& cloud, const PointSink& sink, const ReadOptions& options,
                           Progress& progress);
    static void emit(const E57Cloud& cloud, const Batch& batch, std::size_t count, BlockBuilder& builder);

    std::unique_ptr<ByteSource> source_;
    E57Pages pages_;
    std::vector<E57Cloud> parts_;
    std::vector<E57Image> images_;
};

std::vector<E57Stream> streams_of(const E57Cloud& cloud) {
    std::vector<E57Stream> streams;
    for (const E57Field& field : cloud.fields) streams.emplace_back(field);
    return streams;
}

// A table that cannot hold what it promises is refused before anything is read from it.
void E57Reader::check_table(const E57Cloud& cloud) const {
    const std::uint64_t records = cloud.header.records;
    if (records == 0 && cloud.points_offset == 0) return; // some programs write no table at all then
    std::uint64_t bits = 0;
    for (const E57Field& field : cloud.fields) bits += field.kind == E57Kind::String ? 8U : field.bits;
    if (records > pages_.logical_size() * 8U / std::max<std::uint64_t>(bits, 1)) {
        bad(fmt::format("{} records of {} bits do not fit into the file", records, bits));
    }
    std::vector<E57Stream> streams;
    const PacketReader only_the_header(pages_, cloud.points_offset, streams);
}

// Without stated bounds the grid is as large as the largest row and column in the table.
void E57Reader::find_grid(std::size_t index) {
    E57Cloud& cloud = parts_[index];
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
    const auto widen = [&](const PointBlock& block) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            rows = std::max<std::uint64_t>(rows, block.row[i]);
            columns = std::max<std::uint64_t>(columns, block.column[i]);
        }
    };
    ReadOptions all;
    all.misses = Misses::Keep;
    read_table(cloud, widen, all, Progress::none());
    cloud.header.has.grid = rows > 0 || columns > 0;
    cloud.header.rows = cloud.header.has.grid ? rows + 1 : 0;
    cloud.header.columns = cloud.header.has.grid ? columns + 1 : 0;
}

ReadSummary E57Reader::read_table(const E57Cloud& cloud, const PointSink& sink, const ReadOptions& options,
                                  Progress& progress) {
    BlockBuilder builder(cloud.header, sink, options);
    if (cloud.header.records == 0) return builder.finish();
    std::vector<E57Stream> streams = streams_of(cloud);
    Parts parts = parts_of(streams, cloud);
    PacketReader packets(pages_, cloud.points_offset, streams);
    Batch batch;
    Meter meter(progress, cloud.header.records);
    std::uint64_t done = 0;
    while (done < cloud.header.records) {
        std::uint64_t ready = std::min<std::uint64_t>(kBatch, cloud.header.records - done);
        for (const E57Stream& stream : streams) ready = stream.available(ready);
        if (ready == 0) {
            meter.at(done);
            if (packets.next()) continue;
            bad(fmt::format("the table ends after {} of {} records", done, cloud.header.records));
        }
        batch.take(parts, static_cast<std::size_t>(ready));
        emit(cloud, batch, static_cast<std::size_t>(ready), builder);
        done += ready;
    }
    return builder.finish();
}

std::uint64_t grid_index(std::int64_t value, std::int64_t first, std::uint64_t count, std::uint64_t record,
                         std::string_view what) {
    const std::uint64_t index = static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(first);
    if (index >= count) {
        bad(fmt::format("record {}: {} {} is outside of the {} that the header states", record, what, value, count));
    }
    return index;
}

Validity validity_of(std::int64_t state) noexcept {
    if (state == 0) return Validity::Valid;
    return state == 1 ? Validity::DirectionOnly : Validity::Invalid;
}

void E57Reader::emit(const E57Cloud& cloud, const Batch& batch, std::size_t count, BlockBuilder& builder) {
    const CloudHeader& header = cloud.header;
    const double colour_scale =
        255.0 / (cloud.colour.maximum > cloud.colour.minimum ? cloud.colour.maximum - cloud.colour.minimum : 255.0);
    const std::uint64_t rows = cloud.grid_stated ? header.rows : 0xFFFFFFFFULL;
    const std::uint64_t columns = cloud.grid_stated ? header.columns : 0xFFFFFFFFULL;
    for (std::size_t i = 0; i < count; ++i) {
        const Validity validity = validity_of(batch.state[i]);
        if (validity != Validity::Valid && !builder.keeps_misses()) {
            builder.miss(validity);
            continue;
        }
        const double a = batch.place[0][i];
        const double b = batch.place[1][i];
        const double c = batch.place[2][i];
        if (cloud.cartesian) {
            builder.set_place(a, b, c);
        } else {
            const double flat = a * std::cos(c);
            builder.set_place(flat * std::cos(b), flat * std::sin(b), a * std::sin(c));
        }
        if (header.has.grid) {
            builder.set_grid(grid_index(batch.row[i], cloud.first_row, rows, builder.records(), "row"),
                             grid_index(batch.column[i], cloud.first_column, columns, builder.records(), "column"));
        }
        if (header.has.intensity) {
            builder.set_intensity(batch.no_intensity[i] != 0 ? header.intensity.offset : batch.intensity[i],
                                  header.intensity);
        }
        if (header.has.colour) {
            const auto channel = [&](std::size_t k) {
                return batch.no_colour[i] != 0 ? 0.0 : (batch.colour[k][i] - cloud.colour.minimum) * colour_scale;
            };
            builder.set_colour(channel(0), channel(1), channel(2));
        }
        if (header.has.time) builder.block.time[builder.slot()] = batch.time[i];
        if (validity == Validity::Valid) {
            builder.commit();
        } else {
            builder.miss(validity);
        }
    }
}

std::string E57Reader::read_image_bytes(std::size_t image) const {
    const E57Image& wanted = images_[image];
    const std::uint64_t start = pages_.logical_of(wanted.offset);
    std::array<char, 16> head{};
    pages_.read(start, head);
    const auto length = little_endian<std::uint64_t>(head.data() + 8);
    if (head[0] != 0 || length < head.size() || wanted.header.bytes > length - head.size()) {
        bad(fmt::format("image '{}': no image of {} bytes at byte {}", wanted.header.name, wanted.header.bytes,
                        wanted.offset));
    }
    return pages_.read_string(start + head.size(), wanted.header.bytes);
}

} // namespace

std::unique_ptr<ScanReader> make_e57_reader(std::unique_ptr<ByteSource> source) {
    return std::make_unique<E57Reader>(std::move(source));
}

} // namespace planum::scans
