#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <new>
#include <thread>

#include "splitsum/base/parallel.h"
#include "splitsum/imageio/image_file.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr int width = 4;
constexpr int height = 300;  // several bands, the last one not full

/// A Radiance file of many rows whose pixels tell where they are.
class ManyRows : public testing::TestWithParam<int> {
protected:
    ManyRows() { write(height); }

    // The header claims every row. With exponent 136 a byte stands for itself.
    void write(int row_count) {
        std::ofstream file(path(), std::ios::binary);
        file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << height << " +X " << width << "\n";
        for (int y = 0; y < row_count; ++y)
            for (int x = 0; x < width; ++x)
                for (const int value : {y % 200 + 1, y / 200 + 1, 2 * x + 1, 136})
                    file.put(static_cast<char>(value));
    }

    static bool is_right(std::span<const float> rgb, int first_row) {
        for (size_t i = 0; i < rgb.size(); i += 3) {
            const int y = first_row + static_cast<int>(i) / 3 / width;
            const int x = static_cast<int>(i) / 3 % width;
            if (rgb[i] != float(y % 200 + 1) || rgb[i + 1] != float(y / 200 + 1) ||
                rgb[i + 2] != float(2 * x + 1))
                return false;
        }
        return true;
    }

    Status read(const RowSink& sink) {
        auto reader = ImageReader::open(path());
        if (!reader) return reader.error();
        return reader->read_rows([&](int first_row, int row_count, std::span<float> rgb) {
            EXPECT_EQ(first_row, next_row_) << "rows must come in order and once";
            EXPECT_EQ(rgb.size(), size_t(3 * width * row_count));
            EXPECT_TRUE(is_right(rgb, first_row)) << first_row;
            next_row_ += row_count;
            return sink(first_row, row_count, rgb);
        });
    }

    fs::path path() const { return folder_.path() / "rows.hdr"; }

    tests::TemporaryFolder folder_;
    ThreadLimit limit_{GetParam()};
    int next_row_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Threads, ManyRows, testing::Values(1, 2, 4));

// What the sink leaves in the rows must not show in later ones.
TEST_P(ManyRows, ComeFromTheTopDownAndAreTheSinksToChange) {
    const Status status = read([](int, int, std::span<float> rgb) -> Status {
        std::ranges::fill(rgb, -1.0f);
        return ok;
    });
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_EQ(next_row_, height);
}

TEST_P(ManyRows, BeforeTheEndOfACutFileAreDelivered) {
    write(200);
    const Status status = read([](int, int, std::span<float>) -> Status { return ok; });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::unreadable_input);
    EXPECT_GE(next_row_, 128);
    EXPECT_LE(next_row_, 200);
}

// The reader runs ahead and meets the end of the file while the sink still works on earlier rows.
TEST_P(ManyRows, EndWithTheErrorThatComesFirstFromTheTop) {
    write(130);
    const Status status = read([](int first_row, int, std::span<float>) -> Status {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        if (first_row == 0) return ok;
        return Error{ErrorKind::interrupted, "enough"};
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::interrupted);
    EXPECT_EQ(next_row_, 128) << "no rows after an error";
}

TEST_P(ManyRows, MayBeTakenByParallelLoops) {
    std::atomic<int> rows = 0;
    ASSERT_TRUE(read([&](int, int row_count, std::span<float>) -> Status {
        parallel_rows(row_count, [&](int) { ++rows; });
        return ok;
    }));
    EXPECT_EQ(rows, height);
}

TEST_P(ManyRows, WithASinkThatThrowsEndInAnError) {
    const Status status = read([](int first_row, int, std::span<float>) -> Status {
        if (first_row > 0) throw std::bad_alloc();
        return ok;
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::unreadable_input);
}

}  // namespace
}  // namespace splitsum
