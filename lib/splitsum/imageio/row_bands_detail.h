#pragma once

#include <OpenImageIO/imageio.h>

#include <vector>

namespace splitsum {

/// Rows of the display window that are decoded in one go.
struct Band {
    int first_row;
    int row_count;
    bool has_data;  ///< otherwise they are black
};

/// The display window's rows in file order: black, those of the data window in steps that fall on
/// the file's own packets or tiles, black. A band has at most 64 rows, 32 where they are very long,
/// 256 for DWAB, one row of tiles for a file with tiles.
std::vector<Band> bands_of(const OIIO::ImageSpec& spec);

/// Rows by the file's own numbers.
struct FileRows {
    int begin;
    int end;
};

/// The rows of the file that hold a band: whole tiles where the file has tiles, whose first row may
/// lie above the display window.
FileRows file_rows_of(const OIIO::ImageSpec& spec, const Band& band);

}  // namespace splitsum
