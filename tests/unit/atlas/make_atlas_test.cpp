#include "splitsum/atlas/make_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>
#include <set>

#include "splitsum/base/parallel.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

/// Small enough for sanitizers; every case is there.
AtlasPlan small_plan() { return {.sky_rows = 12, .face_size = 3, .many_rows = 64, .samples = 64}; }

Atlas run(const AtlasPlan& plan) {
    const tests::TemporaryFolder scratch;
    NoProgress progress;
    auto atlas = run_atlas(plan, scratch.path(), progress);
    EXPECT_TRUE(atlas) << atlas.error().message;
    return atlas ? std::move(*atlas) : Atlas{plan, {}};
}

const Atlas& small_atlas() {
    static const Atlas atlas = run(small_plan());
    return atlas;
}

const AtlasEntry& entry_of(const Atlas& atlas, const std::string& id) {
    const auto entry = std::ranges::find(atlas.entries, id, &AtlasEntry::id);
    EXPECT_NE(entry, atlas.entries.end()) << id;
    return *entry;
}

// What `method` did in every case whose rows are methods, "case, column: text" for those with `verdict`.
std::vector<std::string> verdicts(const Atlas& atlas, std::string_view method, Verdict verdict) {
    std::vector<std::string> found;
    for (const AtlasEntry& entry : atlas.entries)
        for (const AtlasRow& row : entry.table.rows)
            for (size_t i = 0; row.label == method && i < row.cells.size(); ++i)
                if (row.cells[i].verdict == verdict)
                    found.push_back(entry.id + ", " + entry.table.columns[i] + ": " +
                                    row.cells[i].text);
    return found;
}

void expect_no_blank() {
    EXPECT_GE(small_atlas().entries.size(), 25u);
    std::set<std::string> ids;
    for (const AtlasEntry& entry : small_atlas().entries) {
        SCOPED_TRACE(entry.id);
        EXPECT_TRUE(ids.insert(entry.id).second);
        EXPECT_FALSE(entry.title.empty() || entry.problem.empty() || entry.conduct.empty());
        EXPECT_FALSE(entry.table.rows.empty());
        for (const AtlasRow& row : entry.table.rows) {
            EXPECT_EQ(row.cells.size(), entry.table.columns.size()) << row.label;
            for (const AtlasCell& cell : row.cells) EXPECT_FALSE(cell.text.empty()) << row.label;
        }
    }
}

void expect_every_method_in_cases_about_light() {
    for (const char* id : {"roughness", "constant", "sun-1e6", "one-texel", "lit-poles", "rows-1",
                           "many-texels", "points", "bands", "edges", "threads"}) {
        const AtlasEntry& entry = entry_of(small_atlas(), id);
        ASSERT_EQ(entry.table.rows.size(), filter_methods().size()) << id;
        for (size_t i = 0; i < entry.table.rows.size(); ++i)
            EXPECT_EQ(entry.table.rows[i].label, filter_methods()[i].name) << id;
    }
}

// The promise: `auto` meets its accuracy, or refuses, and of the others none makes what is no light.
void expect_auto_to_fail_none() {
    EXPECT_EQ(verdicts(small_atlas(), "auto", Verdict::fails), std::vector<std::string>());
    EXPECT_EQ(verdicts(small_atlas(), "auto", Verdict::near), std::vector<std::string>());
    EXPECT_GT(verdicts(small_atlas(), "auto", Verdict::meets).size(), 100u);
}

void expect_nothing_but_light() {
    for (const AtlasEntry& entry : small_atlas().entries)
        for (const AtlasRow& row : entry.table.rows)
            for (const AtlasCell& cell : row.cells) {
                EXPECT_EQ(cell.text.find("values that are no light"), std::string::npos)
                    << entry.id << ", " << row.label << ": " << cell.text;
                if (cell.figures) {
                    EXPECT_TRUE(std::isfinite(cell.figures->rel_rms)) << entry.id << row.label;
                }
            }
}

// Cases that are not about methods: formats, files, windowed series and tables do what they must.
void expect_files_and_formats_as_they_must_be() {
    for (const char* id : {"formats", "files", "threads"})
        for (const AtlasRow& row : entry_of(small_atlas(), id).table.rows)
            for (const AtlasCell& cell : row.cells)
                EXPECT_TRUE(cell.verdict == Verdict::meets || cell.verdict == Verdict::refuses)
                    << id << ", " << row.label << ": " << cell.text;
    for (const AtlasRow& row : entry_of(small_atlas(), "harmonics").table.rows) {
        EXPECT_EQ(row.cells[1].verdict, Verdict::meets) << row.label;
        if (row.label != "1") {
            EXPECT_EQ(row.cells[0].verdict, Verdict::fails) << row.label;
        }
    }
    for (const char* id : {"grazing", "smooth-tables"})
        for (const AtlasCell& cell : entry_of(small_atlas(), id).table.rows.front().cells)
            EXPECT_EQ(cell.verdict, Verdict::meets) << id << ": " << cell.text;
}

// One test, because going through all cases takes seconds.
TEST(Atlas, KeepsItsPromises) {
    expect_no_blank();
    expect_every_method_in_cases_about_light();
    expect_auto_to_fail_none();
    expect_nothing_but_light();
    expect_files_and_formats_as_they_must_be();
}

/// A method that is what `spectral` is but for one thing.
class Wrong final : public PreparedFilter {
public:
    using Change = void (*)(const Directions& directions, std::span<Vec3> out);
    Wrong(std::unique_ptr<PreparedFilter> right, Change change)
        : right_(std::move(right)), change_(change) {}

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        right_->evaluate(lobe_index, directions, out);
        change_(directions, out);
    }
    LevelAccount account(size_t lobe_index) const override { return right_->account(lobe_index); }

private:
    std::unique_ptr<PreparedFilter> right_;
    Change change_;
};

template <Wrong::Change change>
std::unique_ptr<PreparedFilter> prepare_wrong(const FilterSource& source,
                                              std::span<const Lobe> lobes, const FilterPlan& plan) {
    const auto spectral = find_filter_method("spectral", LobeKind::ggx);
    return std::make_unique<Wrong>(spectral->prepare(source, lobes, plan), change);
}

void brighter(const Directions&, std::span<Vec3> out) {
    for (Vec3& light : out) light *= 1.001f;
}

void nan_above(const Directions& directions, std::span<Vec3> out) {
    for (size_t i = 0; i < out.size(); ++i)
        if (directions.towards[i].y > 0.9) out[i].y = NAN;
}

void bright_face(const Directions& directions, std::span<Vec3> out) {
    for (size_t i = 0; i < out.size(); ++i)
        if (face_point_towards(directions.towards[i]).face == 4) out[i] *= 1.5f;
}

// A method that misses its accuracy by little, one with NaN near a pole, and one with a seam: each is
// noticed, where it was planted and in the cases that are about it.
TEST(Atlas, NoticesPlantedFailures) {
    const FilterMethod planted[] = {
        {"brighter", "a thousandth too bright", true, true, prepare_wrong<brighter>},
        {"nan", "NaN above", true, true, prepare_wrong<nan_above>},
        {"seam", "a face too bright", true, true, prepare_wrong<bright_face>},
        {"diffuse", "filters diffuse light alone", false, true, prepare_wrong<brighter>}};
    AtlasPlan plan = small_plan();
    plan.methods = planted;
    plan.pictures = false;
    const Atlas atlas = run(plan);
    EXPECT_GT(verdicts(atlas, "brighter", Verdict::near).size(), 80u);
    const auto nans = verdicts(atlas, "nan", Verdict::fails);
    EXPECT_GT(nans.size(), 80u);
    EXPECT_TRUE(std::ranges::any_of(
        nans, [](const std::string& text) { return text.find("no light") != text.npos; }));
    for (const AtlasCell& cell : entry_of(atlas, "edges").table.rows[2].cells |
                                     std::views::drop(1))  // the mirror is no method's
        EXPECT_EQ(cell.verdict, Verdict::fails) << cell.text;
    EXPECT_GT(verdicts(atlas, "diffuse", Verdict::refuses).size(), 60u);
}

TEST(Atlas, IsWrittenTheSameForAnyNumberOfThreads) {
    AtlasPlan plan = small_plan();
    plan.methods = plan.methods.first(4);
    const auto files_with = [&](int threads) {
        const ThreadLimit limit(threads);
        const tests::TemporaryFolder folder;
        NoProgress progress;
        const auto atlas = make_atlas(plan, folder / "out", progress);
        EXPECT_TRUE(atlas) << atlas.error().message;
        std::vector<std::string> files;
        for (const auto& [name, bytes] : tests::snapshot_of(folder.path())) files.push_back(bytes);
        return files;
    };
    const auto one = files_with(1), many = files_with(3);
    ASSERT_EQ(one.size(), 3u);  // .csv, .html, .json and no scratch
    EXPECT_TRUE(one == many);
    EXPECT_NE(one[1].find("<!doctype html>"), std::string::npos);
    EXPECT_EQ(one[1].find("http"), std::string::npos);  // self-contained
    const auto json = nlohmann::json::parse(one[2]);
    EXPECT_GE(json["cases"].size(), 25u);
    size_t cells = 0;
    for (const auto& entry : json["cases"])
        for (const auto& row : entry["rows"]) cells += row["cells"].size();
    EXPECT_EQ(static_cast<size_t>(std::ranges::count(one[0], '\n')), 1 + cells);
}

TEST(Atlas, SaysWhatPlanWouldWork) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    AtlasPlan plan = small_plan();
    plan.face_size = 0;
    const auto atlas = make_atlas(plan, folder.path(), progress);
    ASSERT_FALSE(atlas);
    EXPECT_EQ(atlas.error().kind, ErrorKind::bad_argument);
    EXPECT_TRUE(tests::snapshot_of(folder.path()).empty());
}

TEST(Atlas, LeavesNothingWhenInterrupted) {
    struct Impatient final : Progress {
        void begin(std::string_view, int) override {}
        void advance(int) override { stop = true; }
        bool cancelled() const override { return stop; }
        std::atomic<bool> stop = false;
    } progress;
    const tests::TemporaryFolder folder;
    const auto atlas = make_atlas(small_plan(), folder / "out", progress);
    ASSERT_FALSE(atlas);
    EXPECT_EQ(atlas.error().kind, ErrorKind::interrupted);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace splitsum
