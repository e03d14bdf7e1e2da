// What a file's certificate promises is held against the file alone.
#include "splitsum/report/certificate_check.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

// A chain of two levels as a bake writes it, each texel of its own colour.
TextureAsset certified_chain() {
    std::vector<Cubemap> levels = {Cubemap(4), Cubemap(2)};
    float value = 0.1f;
    for (Cubemap& level : levels)
        for (Vec3& texel : level.texels) texel = Vec3(value, 2 * value, 3 * value), value *= 1.07f;
    std::vector<EncodeCounts> counts;
    TextureAsset texture = texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
    AssetFacts facts;
    facts.perceptual_roughness = {0, 1};
    texture.metadata = metadata_of(facts);
    const auto checks = check_asset(*cubemaps_of(texture), facts, {});
    const std::vector<LevelAccount> accounts = {{"mirror"}, {"spectral", "", 9, 2.5e-5, 3}};
    certify(texture, certificate_from(accounts, counts, checks, {1, 2, 3}));
    return texture;
}

TEST(CertificateCheck, HoldsForWhatWasCertified) {
    EXPECT_EQ(broken_certificate(certified_chain()), std::vector<std::string>());
}

TEST(CertificateCheck, NoticesABitAKeyAndAMissingLevel) {
    TextureAsset bit = certified_chain();
    bit.levels[1][3] ^= std::byte{1};
    EXPECT_FALSE(broken_certificate(bit).empty());

    TextureAsset key = certified_chain();
    key.metadata["splitsum.exposure_stops"] = "1.5";
    EXPECT_FALSE(broken_certificate(key).empty());

    TextureAsset level = certified_chain();
    level.levels.pop_back();
    EXPECT_FALSE(broken_certificate(level).empty());
}

TEST(CertificateCheck, DoesNotHoldWhereThereIsNone) {
    TextureAsset texture = certified_chain();
    std::erase_if(texture.metadata, [](const auto& entry) {
        return entry.first.starts_with("splitsum.certificate.");
    });
    EXPECT_EQ(broken_certificate(texture).size(), 1u);
    texture = certified_chain();
    texture.metadata.erase("splitsum.certificate.probes");
    EXPECT_FALSE(broken_certificate(texture).empty());
}

}  // namespace
}  // namespace splitsum
