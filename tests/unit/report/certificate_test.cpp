// A certificate must hold for the file it was made for, and for no other.
#include "splitsum/report/certificate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splitsum {
namespace {

struct Made {
    std::vector<Cubemap> levels = {Cubemap(4), Cubemap(2)};
    TextureAsset texture;
    std::vector<LevelAccount> accounts = {{"mirror"}, {"spectral", "", 9, 2.5e-5, 3}};
    std::vector<EncodeCounts> counts;
    std::vector<LevelCheck> checks;

    explicit Made(int64_t probes = 5) {
        float value = 0.1f;
        for (Cubemap& level : levels)
            for (Vec3& texel : level.texels)
                texel = Vec3(value, 2 * value, 3 * value), value *= 1.07f;
        levels[0].texels[7].x = 1e9f;
        texture = texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
        levels = *cubemaps_of(texture);
        texture.metadata = {{"splitsum.source", "sky.exr"}, {"KTXwriter", "anyone"}};
        for (const Cubemap& level : levels)
            checks.push_back({int(checks.size()),
                              level.face_size,
                              0,
                              {1.25e-4, 3e-3, 0.5, -2e-5, probes},
                              mean_radiance(level)});
        certify(texture, certificate_from(accounts, counts, checks, {1, 2, 3}));
    }

    std::vector<std::string> found() const {
        const auto certificate = certificate_of(texture.metadata);
        if (!certificate || !*certificate) return {"unreadable"};
        return contradictions(**certificate, texture, checks);
    }
};

TEST(Certificate, SaysWhatWasMadeAndMeasured) {
    const Made made;
    const auto certificate = certificate_of(made.texture.metadata);
    ASSERT_TRUE(certificate) << certificate.error().message;
    ASSERT_TRUE(*certificate);
    EXPECT_EQ((*certificate)->source_mean_radiance, Vec3d(1, 2, 3));
    ASSERT_EQ((*certificate)->levels.size(), 2u);
    const CertifiedLevel& level = (*certificate)->levels[1];
    EXPECT_FLOAT_EQ(float(level.error_bound), 2.5e-5f);
    EXPECT_EQ(level.clamped_negative, 3);
    EXPECT_EQ((*certificate)->levels[0].saturated, 1);
    EXPECT_EQ(level.figures.texels, 5);
    EXPECT_FLOAT_EQ(float(level.figures.rel_rms), 1.25e-4f);
    EXPECT_FLOAT_EQ(float(level.figures.max_rel), 3e-3f);
    EXPECT_FLOAT_EQ(float(level.figures.max_abs), 0.5f);
    EXPECT_FLOAT_EQ(float(level.figures.bias), -2e-5f);
    EXPECT_TRUE(made.found().empty());
}

TEST(Certificate, WithoutProbesHasNoFigures) {
    const Made made(0);
    EXPECT_FALSE(made.texture.metadata.contains("splitsum.certificate.rel_rms"));
    EXPECT_TRUE(made.found().empty());
}

TEST(Certificate, IsNotThereInOtherFiles) {
    const auto none = certificate_of({{"splitsum.source", "sky.exr"}});
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

TEST(Certificate, NoticesEveryBitOfTheTexels) {
    for (const size_t level : {0u, 1u})
        for (const size_t byte : {0u, 9u, 100u}) {
            Made made;
            made.texture.levels[level][byte] ^= std::byte{1};
            EXPECT_FALSE(made.found().empty()) << level << " " << byte;
        }
}

TEST(Certificate, NoticesAChangeOfEveryKeyThatIsOurs) {
    const Made made;
    for (const auto& [key, value] : made.texture.metadata) {
        Made changed;
        changed.texture.metadata[key] += " 1";
        EXPECT_EQ(changed.found().empty(), key == "KTXwriter") << key;
        Made without;
        without.texture.metadata.erase(key);
        EXPECT_EQ(without.found().empty(), key == "KTXwriter") << key;
    }
    Made longer;
    longer.texture.metadata["splitsum.more"] = "";
    EXPECT_FALSE(longer.found().empty());
}

// Texels that were swapped for others under a hash that was made anew.
TEST(Certificate, NoticesMeansAndFiguresThatAreNotTheLevels) {
    Made made;
    made.checks[1].mean_radiance.y *= 1 + 3e-6;
    ASSERT_EQ(made.found().size(), 1u);
    EXPECT_NE(made.found()[0].find("level 1: the mean radiance"), std::string::npos);
    for (double ErrorFigures::*figure : {&ErrorFigures::rel_rms, &ErrorFigures::max_rel,
                                         &ErrorFigures::max_abs, &ErrorFigures::bias}) {
        Made worse;
        worse.checks[0].figures.*figure *= 1.2;
        ASSERT_EQ(worse.found().size(), 1u);
        worse.checks[0].figures.*figure = std::nan("");
        EXPECT_EQ(worse.found().size(), 1u);
        worse.checks[0].figures.texels = 6;  // other probes, other figures
        EXPECT_TRUE(worse.found().empty());
    }
    made = Made();
    made.checks.pop_back();
    EXPECT_FALSE(made.found().empty());
}

TEST(Certificate, NamesTheKeyThatCannotBeRead) {
    Made made;
    made.texture.metadata["splitsum.certificate.rel_rms"] = "0.1 small";
    const auto garbled = certificate_of(made.texture.metadata);
    ASSERT_FALSE(garbled);
    EXPECT_EQ(garbled.error().kind, ErrorKind::unusable_input);
    EXPECT_NE(garbled.error().message.find("splitsum.certificate.rel_rms"), std::string::npos);
    made.texture.metadata["splitsum.certificate.rel_rms"] = "0.1";
    const auto shorter = certificate_of(made.texture.metadata);
    ASSERT_FALSE(shorter);
    EXPECT_NE(shorter.error().message.find("1 numbers"), std::string::npos);
}

}  // namespace
}  // namespace splitsum
