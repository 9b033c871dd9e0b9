// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "core/base/progress.hpp"
#include "scans/formats/byte_source.hpp"
#include "scans/formats/cloud_header.hpp"
#include "scans/formats/point_block.hpp"

namespace planum::scans {

enum class Misses {
    Skip, ///< only points that are somewhere
    Keep, ///< every record, with its validity: for the scanner's grid
};

struct ReadOptions {
    Misses misses = Misses::Skip;
    std::size_t block_points = 16384; ///< at most so many in one block
};

struct OpenOptions {
    /// XYZ and CSV: what the columns are, e.g. "x,y,z,-,intensity"; empty: guess, and say the guess in
    /// ScanFileInfo::column_guess.
    std::string columns;
};

/// One scan file: what it says about itself, then the points of each cloud as a stream of blocks.
/// Memory is bounded by the block size whatever the file's size (PCD binary_compressed excepted,
/// which is one compressed piece by its nature).
///
/// Every failure to make sense of the bytes is Error{BadInput} that names the page, record or line, and the file
/// where it was opened by its path.
class ScanReader {
  public:
    ScanReader() = default;
    ScanReader(const ScanReader&) = delete;
    ScanReader& operator=(const ScanReader&) = delete;
    virtual ~ScanReader() = default;

    [[nodiscard]] const ScanFileInfo& info() const noexcept { return info_; }

    [[nodiscard]] const std::vector<CloudHeader>& clouds() const noexcept { return clouds_; }

    /// Streams one cloud. Throws Usage when there is no such cloud, Cancelled, BadInput, Io; what the
    /// sink throws passes through.
    ReadSummary read(std::size_t cloud, const PointSink& sink, const ReadOptions& options, Progress& progress);

    /// The bytes of an embedded JPEG or PNG file. Throws Usage when there is no such image.
    [[nodiscard]] std::string read_image(std::size_t image) const;

    /// Failures to make sense of the bytes name this file from now on.
    void name_in_errors(const std::filesystem::path& file) { file_ = file.string(); }

  protected:
    virtual ReadSummary read_cloud(std::size_t cloud, const PointSink& sink, const ReadOptions& options,
                                   Progress& progress) = 0;
    [[nodiscard]] virtual std::string read_image_bytes(std::size_t image) const;

    ScanFileInfo info_;
    std::vector<CloudHeader> clouds_;

  private:
    void add_file(Error& error) const;

    std::string file_; ///< empty: bytes of no file
};

/// Opens a file by its content where the format has a mark, else by its ending. Throws BadInput with
/// the known endings when it is none of ours, and with what to do for LAZ.
[[nodiscard]] std::unique_ptr<ScanReader> open_scan(const std::filesystem::path& file, const OpenOptions& options,
                                                    Progress& progress);

/// The same for bytes of a known format. `companion` is the text of the .pose file of a .3d file.
[[nodiscard]] std::unique_ptr<ScanReader> open_scan(std::unique_ptr<ByteSource> source, ScanFormat format,
                                                    const OpenOptions& options, Progress& progress,
                                                    std::optional<std::string> companion = std::nullopt);

/// What the bytes or, failing that, the ending (with dot, any case) say; nullopt: none of ours.
[[nodiscard]] std::optional<ScanFormat> guess_format(const ByteSource& source, std::string_view ending);

/// "PTX", "E57", …
[[nodiscard]] std::string_view format_name(ScanFormat format) noexcept;

/// The day of a scan by the nearest folder above it that is named by its date (`2025-06-01`, also
/// with words behind a blank, '_' or '-').
[[nodiscard]] std::optional<std::string> day_of_folder(const std::filesystem::path& file);

} // namespace planum::scans
