// Pictures that other programs add to a bake: they are no part of it, and never show an older one.
#include <gtest/gtest.h>

#include <optional>

#include "splitsum/bake/bake.h"
#include "splitsum/library/bake_library.h"
#include "splitsum/library/merge.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

class DrawnFiles : public testing::TestWithParam<bool> {
protected:
    DrawnFiles() {
        std::string bytes = "PF\n16 8\n-1.0\n";
        for (int i = 0; i < 16 * 8 * 3; ++i) {
            const float value = 0.25f + float(i * 3 % 11);
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
        job_.panorama = {folder_ / "sky.pfm", "sky"};
        tests::write_bytes(job_.panorama.file, bytes);
        job_.plan.specular.face_size = 8;
        job_.plan.specular.levels = 2;
        job_.plan.irradiance.face_size = 4;
        job_.plan.probes = 2;
        run_.folder = folder_ / "out";
        run_.table.plan.size = 8;
        if (GetParam()) {
            cache_ = std::move(*ContentCache::open(folder_ / "cache", 1 << 24));
            run_.cache = &*cache_;
        }
    }

    Outcome bake() {
        LibraryObserver nobody;
        NoProgress progress;
        const auto summary = bake_library({&job_, 1}, run_, nobody, progress);
        EXPECT_TRUE(summary);
        return summary->items[0].outcome;
    }

    void draw() {
        for (const std::string& name : drawn_files())
            tests::write_bytes(run_.folder / "sky" / name, "drawn later");
    }

    bool is_drawn(const std::string& name) const {
        return tests::bytes_of(run_.folder / "sky" / name) == "drawn later";
    }

    tests::TemporaryFolder folder_;
    std::optional<ContentCache> cache_;
    LibraryJob job_;
    LibraryRun run_;
};

INSTANTIATE_TEST_SUITE_P(WithAndWithoutCache, DrawnFiles, testing::Bool());

TEST_P(DrawnFiles, StayWhileTheBakeIsUpToDate) {
    job_.plan.picture = false;
    ASSERT_EQ(bake(), Outcome::baked);
    draw();
    EXPECT_EQ(bake(), Outcome::up_to_date);
    for (const std::string& name : drawn_files()) EXPECT_TRUE(is_drawn(name)) << name;
    NoProgress progress;
    const auto check = check_merged({&job_, 1}, run_.table, run_.folder, progress);
    ASSERT_TRUE(check);
    EXPECT_EQ(check->complete, 1);
}

TEST_P(DrawnFiles, GoWhenSomethingElseIsBaked) {
    job_.plan.picture = false;
    ASSERT_EQ(bake(), Outcome::baked);
    draw();
    job_.plan.specular.levels = 3;
    ASSERT_EQ(bake(), Outcome::baked);
    for (const std::string& name : drawn_files())
        EXPECT_FALSE(fs::exists(run_.folder / "sky" / name)) << name;
    if (!cache_) return;
    draw();
    job_.plan.specular.levels = 2;
    ASSERT_EQ(bake(), Outcome::from_cache);
    for (const std::string& name : drawn_files())
        EXPECT_FALSE(fs::exists(run_.folder / "sky" / name)) << name;
}

// What the bake itself draws comes with it.
TEST_P(DrawnFiles, GiveWayToTheContactSheetOfTheNewBake) {
    ASSERT_EQ(bake(), Outcome::baked);
    draw();
    job_.plan.specular.levels = 3;
    ASSERT_EQ(bake(), Outcome::baked);
    EXPECT_TRUE(fs::exists(run_.folder / "sky/contact.png"));
    EXPECT_FALSE(is_drawn("contact.png"));
    EXPECT_FALSE(fs::exists(run_.folder / "sky/preview.png"));
}

}  // namespace
}  // namespace splitsum
