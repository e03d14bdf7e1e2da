#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>

#include "splitsum/base/parallel.h"
#include "splitsum/panorama/panorama.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

const fs::path test_data = SPLITSUM_TEST_DATA;

/// Keeps the rows that are streamed, and counts how often they were taken back.
struct Collected {
    std::vector<float> rgb;
    int restarts = 0;
    int bands = 0;
};

Result<Panorama> stream(const fs::path& path, const PanoramaOptions& options, Collected& rows,
                        Progress& progress) {
    int next_row = 0;
    return stream_panorama(
        path, options,
        [&](int first_row, int row_count, std::span<const float> rgb) {
            EXPECT_EQ(first_row, next_row);
            next_row += row_count;
            rows.rgb.insert(rows.rgb.end(), rgb.begin(), rgb.end());
            ++rows.bands;
        },
        [&] {
            rows.rgb.clear();
            next_row = 0;
            ++rows.restarts;
        },
        progress);
}

Result<Panorama> stream(const fs::path& path, const PanoramaOptions& options, Collected& rows) {
    NoProgress progress;
    return stream(path, options, rows, progress);
}

void expect_same(const fs::path& path, const PanoramaOptions& options) {
    SCOPED_TRACE(path);
    NoProgress progress;
    const auto read = read_panorama(path, options, progress);
    Collected rows;
    const auto streamed = stream(path, options, rows);
    ASSERT_EQ(bool(read), bool(streamed));
    if (!read) {
        EXPECT_EQ(streamed.error().kind, read.error().kind);
        EXPECT_EQ(streamed.error().message, read.error().message);
        return;
    }
    EXPECT_EQ(rows.rgb, read->pixels.rgb);
    EXPECT_EQ(streamed->source, read->source);
    EXPECT_EQ(streamed->source_hash, read->source_hash);
    EXPECT_EQ(streamed->color_space, read->color_space);
    EXPECT_EQ(streamed->exposure_stops, read->exposure_stops);
    EXPECT_EQ(streamed->notes, read->notes);
    EXPECT_EQ(streamed->repaired, read->repaired);
}

PanoramaOptions developing() {
    PanoramaOptions options;
    options.color_space = "ACEScg";
    options.exposure_stops = -1.25;
    options.repair = true;
    return options;
}

// Good and bad files of every kind, as they are and with everything that can be done to them.
TEST(StreamPanorama, GivesWhatReadingGives) {
    int count = 0;
    for (const int threads : {1, 4}) {
        const ThreadLimit limit(threads);
        for (const char* folder : {"reading", "unusable", "malformed", "panoramas"})
            for (const auto& entry : fs::directory_iterator(test_data / folder)) {
                expect_same(entry.path(), {});
                expect_same(entry.path(), developing());
                ++count;
            }
    }
    EXPECT_GT(count, 50);
}

/// 300 rows, several bands, as a Portable Float Map: a line of text for each of kind, size and byte
/// order, then rows from the bottom up. Every value differs from its neighbours.
class LargeFile : public testing::Test {
protected:
    static constexpr int height = 300;

    void write_with(float value, int x, int y) {
        std::ofstream file(path(), std::ios::binary);
        file << "PF\n" << 2 * height << " " << height << "\n-1.0\n";
        for (int row = height - 1; row >= 0; --row)
            for (int i = 0; i < 6 * height; ++i) {
                const float plain = 0.25f + float(i) + 0.001f * float(row);
                const float here = row == y && i == 3 * x + 1 ? value : plain;
                file.write(reinterpret_cast<const char*>(&here), sizeof here);
            }
    }
    fs::path path() const { return folder_.path() / "large.pfm"; }

    tests::TemporaryFolder folder_;
};

TEST_F(LargeFile, TakesRowsBackWhereADefectComesLate) {
    write_with(std::numeric_limits<float>::quiet_NaN(), 17, 205);
    Collected rows;
    const auto refused = stream(path(), {}, rows);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unusable_input);
    EXPECT_NE(refused.error().message.find("1 NaN (first at x 17, y 205)"), std::string::npos)
        << refused.error().message;
    EXPECT_EQ(rows.restarts, 1);
    EXPECT_TRUE(rows.rgb.empty());

    PanoramaOptions options;
    options.repair = true;
    rows = {};
    const auto repaired = stream(path(), options, rows);
    ASSERT_TRUE(repaired) << repaired.error().message;
    EXPECT_EQ(rows.restarts, 1);
    EXPECT_EQ(repaired->found.nan.count, 1);
    expect_same(path(), options);
}

TEST(StreamPanorama, MayHaveToKeepWhatIsToBeRepaired) {
    PanoramaOptions options;
    const auto streamed = panorama_size(test_data / "panoramas/lopsided.exr", options);
    options.repair = true;
    const auto repaired = panorama_size(test_data / "panoramas/lopsided.exr", options);
    ASSERT_TRUE(streamed && repaired);
    EXPECT_EQ(repaired->reading_bytes - streamed->reading_bytes,
              int64_t{12} * streamed->width * streamed->height);
}

TEST_F(LargeFile, RefusesWhatTheExposureMakesInfinite) {
    write_with(3e38f, 400, 299);
    PanoramaOptions options;
    options.exposure_stops = 2;
    Collected rows;
    const auto refused = stream(path(), options, rows);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("x 400, y 299"), std::string::npos)
        << refused.error().message;
}

TEST_F(LargeFile, IsStreamedInSeveralBands) {
    write_with(1, 0, 0);
    expect_same(path(), {});
    Collected rows;
    ASSERT_TRUE(stream(path(), {}, rows));
    EXPECT_GE(rows.bands, 3);
    EXPECT_EQ(rows.restarts, 0);
}

class StopAfter final : public Progress {
public:
    explicit StopAfter(int rows) : rows_(rows) {}
    void begin(std::string_view, int) override {}
    void advance(int steps) override { done_ += steps; }
    bool cancelled() const override { return done_ >= rows_; }

private:
    int rows_;
    int done_ = 0;
};

TEST_F(LargeFile, StopsWhenAsked) {
    write_with(1, 0, 0);
    for (const int threads : {1, 4}) {
        const ThreadLimit limit(threads);
        StopAfter progress(64);
        Collected rows;
        const auto stopped = stream(path(), {}, rows, progress);
        ASSERT_FALSE(stopped);
        EXPECT_EQ(stopped.error().kind, ErrorKind::interrupted);
        EXPECT_EQ(rows.bands, 1);
        EXPECT_EQ(rows.restarts, 0);
    }
}

}  // namespace
}  // namespace splitsum
