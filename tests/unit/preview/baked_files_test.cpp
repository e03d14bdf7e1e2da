#include "splitsum/preview/baked_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/container/containers.h"
#include "splitsum/report/harmonics_file.h"
#include "splitsum/table/split_sum_lookup.h"
#include "support/temporary_folder.h"
#include "unit/preview/direction_sky.h"

namespace splitsum {
namespace {

using tests::direction_sky;

AssetFacts facts(AssetFacts::Kind kind) {
    AssetFacts facts;
    facts.kind = kind;
    facts.source = {"sky.exr", "xxh3-128:00112233445566778899aabbccddeeff", "lin_rec709"};
    facts.source.exposure_stops = -1.5;
    facts.orientation.rotate_degrees = 30;
    facts.curve.kind = RoughnessCurve::Kind::filament;
    if (kind == AssetFacts::Kind::specular)
        facts.perceptual_roughness = roughness_of_levels(facts.curve, 3);
    return facts;
}

/// A bake of small assets, written by hand.
class BakedFilesTest : public testing::Test {
protected:
    BakedFilesTest() {
        write_cube({direction_sky(16, 0), direction_sky(8, 1), direction_sky(4, 2)},
                   facts(AssetFacts::Kind::specular), files_.specular);
        write_cube({direction_sky(8, 5)}, facts(AssetFacts::Kind::irradiance), files_.irradiance);
        write_table(TablePlan{}, files_.table);
    }

    void write_cube(const std::vector<Cubemap>& levels, const AssetFacts& said,
                    const std::filesystem::path& path, PixelFormat format = PixelFormat::rgba32f) {
        std::filesystem::create_directories(path.parent_path());
        std::vector<EncodeCounts> counts;
        TextureAsset texture = texture_from_cubemaps(levels, format, counts);
        texture.metadata = metadata_of(said);
        ASSERT_TRUE(write_texture(texture, path));
    }

    void write_table(const TablePlan& plan, const std::filesystem::path& path) {
        Table table = blank_table(4, 4, 2);
        for (size_t i = 0; i < table.values.size(); ++i) table.values[i] = 0.01f * float(i);
        EncodeCounts counts;
        TextureAsset texture = texture_from_table(table, PixelFormat::rg32f, counts);
        AssetFacts said;
        said.kind = AssetFacts::Kind::table;
        said.table.plan = plan;
        texture.metadata = metadata_of(said);
        ASSERT_TRUE(write_texture(texture, path));
    }

    void expect_refused(const BakedFiles& files, ErrorKind kind, const std::string& says) {
        const auto baked = read_baked(files);
        ASSERT_FALSE(baked) << says;
        EXPECT_EQ(baked.error().kind, kind) << baked.error().message;
        EXPECT_NE(baked.error().message.find(says), std::string::npos) << baked.error().message;
    }

    tests::TemporaryFolder folder_;
    BakedFiles files_{folder_ / "dusk/red/specular.ktx2", folder_ / "dusk/red/irradiance.ktx2",
                      folder_ / "brdf.ktx2"};
};

TEST_F(BakedFilesTest, AreFoundInAFolder) {
    for (const char* spelling : {"dusk/red", "dusk/red/", "dusk/../dusk/red"}) {
        const BakedFiles found = files_of_bake(folder_ / spelling);
        for (const auto& [file, meant] : {std::pair(found.specular, files_.specular),
                                          {found.irradiance, files_.irradiance},
                                          {found.table, files_.table}})
            EXPECT_TRUE(std::filesystem::equivalent(file, meant)) << file;
    }
    write_table(TablePlan{}, folder_ / "dusk/brdf.ktx2");
    EXPECT_EQ(files_of_bake(folder_ / "dusk/red").table, folder_ / "dusk/brdf.ktx2");
    EXPECT_EQ(files_of_bake("there/is/none").table.filename(), "brdf.ktx2");
}

// Of the same texels, within the steps of each format.
TEST_F(BakedFilesTest, AreReadFromEveryContainerAndFormat) {
    struct Stored {
        PixelFormat format;
        const char* file;
        double tolerance;
    };
    const Stored stored[] = {
        {PixelFormat::rgba32f, "a.ktx2", 1e-6}, {PixelFormat::rgba16f, "b.ktx2", 4e-3},
        {PixelFormat::rgb9e5, "c.ktx2", 2e-2},  {PixelFormat::b10g11r11, "d.ktx2", 0.1},
        {PixelFormat::rgba16f, "e.exr", 4e-3},  {PixelFormat::rgba32f, "f.exr", 1e-6}};
    for (const Stored& as : stored) {
        files_.specular = folder_ / as.file;
        write_cube({direction_sky(16, 0), direction_sky(8, 1), direction_sky(4, 2)},
                   facts(AssetFacts::Kind::specular), files_.specular, as.format);
        const auto baked = read_baked(files_);
        ASSERT_TRUE(baked) << baked.error().message;
        ASSERT_EQ(baked->light.specular.size(), 3u);
        for (int level = 0; level < 3; ++level) {
            const Cubemap meant = direction_sky(16 >> level, level);
            for (size_t i = 0; i < meant.texels.size(); ++i)
                ASSERT_LT(length(baked->light.specular[size_t(level)].texels[i] - meant.texels[i]),
                          as.tolerance)
                    << as.file;
        }
        EXPECT_EQ(baked->light.curve.kind, RoughnessCurve::Kind::filament);
        EXPECT_EQ(baked->facts.source.exposure_stops, -1.5);
        EXPECT_TRUE(baked->notes.empty());
    }
}

TEST_F(BakedFilesTest, DivideStoredIrradianceByPi) {
    const auto per_pi = read_baked(files_);
    ASSERT_TRUE(per_pi);
    AssetFacts said = facts(AssetFacts::Kind::irradiance);
    said.stores_irradiance = true;
    Cubemap irradiance = direction_sky(8, 5);
    for (Vec3& texel : irradiance.texels) texel *= std::numbers::pi_v<float>;
    write_cube({irradiance}, said, files_.irradiance);
    const auto stored = read_baked(files_);
    ASSERT_TRUE(stored);
    for (size_t i = 0; i < irradiance.texels.size(); ++i)
        EXPECT_LT(length(stored->light.irradiance.texels[i] - per_pi->light.irradiance.texels[i]),
                  1e-5);
}

TEST_F(BakedFilesTest, TakeHarmonicsForDiffuseLight) {
    IrradianceHarmonics series;
    series.order = 1;
    series.coefficients = {Vec3d(3), Vec3d(0.1, 0, 0), Vec3d(0, 0.2, 0), Vec3d(0, 0, 0.3)};
    files_.irradiance = folder_ / "harmonics.json";
    ASSERT_TRUE(write_harmonics(series, facts(AssetFacts::Kind::irradiance), files_.irradiance));
    const auto baked = read_baked(files_);
    ASSERT_TRUE(baked) << baked.error().message;
    const Cubemap& cubemap = baked->light.irradiance;
    for (const int face : {0, 1, 2, 3, 4, 5})
        EXPECT_LT(length(Vec3d(cubemap.at(face, 3, 5)) -
                         evaluate(series, direction_of_texel(face, 3, 5, cubemap.face_size))),
                  1e-6);
}

TEST_F(BakedFilesTest, OfDifferentPanoramasAreNoted) {
    AssetFacts turned = facts(AssetFacts::Kind::irradiance), brighter = turned, another = turned;
    turned.orientation.rotate_degrees = 31;
    brighter.source.exposure_stops = 2;
    another.source.hash[12] = 'f';
    for (const AssetFacts& said : {turned, brighter, another}) {
        write_cube({direction_sky(8, 5)}, said, files_.irradiance);
        const auto baked = read_baked(files_);
        ASSERT_TRUE(baked);
        ASSERT_EQ(baked->notes.size(), 1u);
        EXPECT_NE(baked->notes[0].find("another panorama"), std::string::npos);
    }
}

TEST_F(BakedFilesTest, OfAnotherMaskingTermAreNoted) {
    for (const SmithTermInfo& term : smith_terms()) {
        TablePlan plan;
        plan.geometry = term.term;
        write_table(plan, files_.table);
        const auto baked = read_baked(files_);
        ASSERT_TRUE(baked) << baked.error().message;
        EXPECT_EQ(baked->notes.size(), term.term == TablePlan{}.geometry ? 0u : 1u);
    }
}

TEST_F(BakedFilesTest, OfTheWrongKindAreRefused) {
    const BakedFiles good = files_;
    expect_refused({good.irradiance, good.irradiance, good.table}, ErrorKind::unusable_input,
                   "is irradiance, not a specular chain");
    expect_refused({good.specular, good.specular, good.table}, ErrorKind::unusable_input,
                   "is a specular chain, not irradiance");
    expect_refused({good.specular, good.irradiance, good.irradiance}, ErrorKind::unusable_input,
                   "not a table");
    expect_refused({folder_ / "absent.ktx2", good.irradiance, good.table},
                   ErrorKind::unreadable_input, "absent.ktx2");
    TablePlan edge;
    edge.layout = TexelLayout::edge;
    write_table(edge, files_.table);
    expect_refused(good, ErrorKind::unusable_input, "splitsum-brdf");
}

TEST_F(BakedFilesTest, ThatDoNotSayWhatTheyAreAreRefused) {
    std::vector<EncodeCounts> counts;
    const std::vector<Cubemap> levels = {direction_sky(4, 0)};
    const TextureAsset texture = texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
    ASSERT_TRUE(write_texture(texture, files_.specular));
    expect_refused(files_, ErrorKind::unusable_input, "does not say what its texels mean");
    AssetFacts said = facts(AssetFacts::Kind::specular);
    write_cube({direction_sky(8, 0), direction_sky(4, 1)}, said, files_.specular);
    expect_refused(files_, ErrorKind::unusable_input, "2 levels and names 3 roughness values");
}

}  // namespace
}  // namespace splitsum
