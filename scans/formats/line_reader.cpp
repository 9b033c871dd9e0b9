// SPDX-License-Identifier: MIT
#include "scans/formats/line_reader.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace planum::scans {

LineReader::LineReader(const ByteSource& source, std::uint64_t offset, std::uint64_t first_line, std::uint64_t window)
    : source_(&source), window_offset_(std::min(offset, source.size())), read_to_(window_offset_),
      number_(first_line - 1) {
    const std::uint64_t left = source.size() - window_offset_;
    buffer_.resize(static_cast<std::size_t>(std::min(left, window + kLongest)) + 1);
    next_ = filled_ = line_ = line_end_ = buffer_.data();
}

// Moves what is left to the front and fills the window; false when the file has no more.
bool LineReader::refill() {
    const std::uint64_t left = source_->size() - read_to_;
    if (left == 0) return false;
    const auto kept = static_cast<std::size_t>(filled_ - next_);
    std::memmove(buffer_.data(), next_, kept);
    window_offset_ = read_to_ - kept;
    const std::size_t room = buffer_.size() - 1 - kept;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left, room));
    source_->read(read_to_, {buffer_.data() + kept, count});
    read_to_ += count;
    next_ = buffer_.data();
    filled_ = next_ + kept + count;
    buffer_[kept + count] = '\n'; // so that number parsing ends
    return true;
}

bool LineReader::next() {
    while (true) {
        const auto length = static_cast<std::size_t>(filled_ - next_);
        const void* found = length == 0 ? nullptr : std::memchr(next_, '\n', length);
        const bool too_long = found == nullptr && length > kLongest;
        if (found == nullptr && !too_long && refill()) continue;
        if (length == 0) return false;
        ++number_;
        const char* stop = found != nullptr ? static_cast<const char*>(found) : filled_;
        if (static_cast<std::size_t>(stop - next_) > kLongest) {
            fail(fmt::format("longer than {} bytes, this is no table of points", kLongest));
        }
        line_ = next_;
        line_end_ = stop;
        next_ = found != nullptr ? stop + 1 : stop;
        if (line_end_ > line_ && line_end_[-1] == '\r') --line_end_;
        return true;
    }
}

std::uint64_t LineReader::skip(std::uint64_t lines) {
    std::uint64_t done = 0;
    while (done < lines) {
        const auto length = static_cast<std::size_t>(filled_ - next_);
        const void* found = length == 0 ? nullptr : std::memchr(next_, '\n', length);
        if (found != nullptr) {
            next_ = static_cast<const char*>(found) + 1;
            ++done;
            continue;
        }
        if (length > kLongest) {
            number_ += done + 1;
            fail(fmt::format("longer than {} bytes, this is no table of points", kLongest));
        }
        if (refill()) continue;
        if (length > 0) ++done; // the last line has no end
        next_ = filled_;
        break;
    }
    number_ += done;
    return done;
}

void LineReader::fail(std::string_view message) const {
    throw Error(ErrorCode::BadInput, fmt::format("line {}: {}", number_, message));
}

} // namespace planum::scans
