#include "splitsum/container/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

Image picture(float first) {
    Image image(5, 3);
    for (size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = first + 0.37f * float(i);
    return image;
}

// Row by row, as OpenEXR's own reader finds it.
std::vector<float> channel_in(const std::filesystem::path& file, const std::string& name) {
    Imf::InputFile input(file.c_str());
    std::vector<float> values(15);
    EXPECT_NE(input.header().channels().findChannel(name), nullptr) << name;
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()),
                                   sizeof(float), 5 * sizeof(float)));
    input.setFrameBuffer(buffer);
    input.readPixels(0, 2);
    return values;
}

void expect_channel(const std::filesystem::path& file, const std::string& name, const Image& image,
                    size_t channel) {
    const auto values = channel_in(file, name);
    for (size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(values[i], image.rgb[3 * i + channel]) << name << " " << i;
}

TEST(ExrLayers, AreFoundByOpenExrUnderTheirNames) {
    const tests::TemporaryFolder folder;
    const Image baked = picture(1), truth = picture(-70000);
    const ExrLayer layers[] = {{"baked", &baked}, {"truth", &truth}};
    const auto path = folder / "layers.exr";
    const Status written = write_exr_layers(layers, {{"software", "a test"}}, path);
    ASSERT_TRUE(written) << written.error().message;
    for (size_t c = 0; c < 3; ++c) {
        const char* const names[] = {"R", "G", "B"};
        expect_channel(path, std::string("baked.") + names[c], baked, c);
        expect_channel(path, std::string("truth.") + names[c], truth, c);
    }
    const Imf::InputFile input(path.c_str());
    EXPECT_EQ(input.header().typedAttribute<Imf::StringAttribute>("software").value(), "a test");
}

TEST(ExrLayers, OneWithoutANameIsAPlainPicture) {
    const tests::TemporaryFolder folder;
    const Image image = picture(2);
    const ExrLayer layer{"", &image};
    ASSERT_TRUE(write_exr_layers({&layer, 1}, {}, folder / "plain.exr"));
    expect_channel(folder / "plain.exr", "R", image, 0);
    expect_channel(folder / "plain.exr", "B", image, 2);
}

TEST(ExrLayers, RefusesWhatIsNoFileOfLayers) {
    const tests::TemporaryFolder folder;
    const Image image = picture(2), other(5, 4);
    const ExrLayer different[] = {{"a", &image}, {"b", &other}};
    for (const Status& status : {write_exr_layers({}, {}, folder / "a.exr"),
                                 write_exr_layers(different, {}, folder / "a.exr")}) {
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().kind, ErrorKind::bad_argument);
    }
    const Status unwritable = write_exr_layers({different, 1}, {}, folder / "absent/a.exr");
    ASSERT_FALSE(unwritable);
    EXPECT_EQ(unwritable.error().kind, ErrorKind::unwritable_output);
    EXPECT_TRUE(tests::snapshot_of(folder.path()).empty());
}

}  // namespace
}  // namespace splitsum
