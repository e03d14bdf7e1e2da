#include "write_exr.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>

#include <deque>

namespace splitsum::test_data {
namespace {

Imath::Box2i box_of(const Window& window, const Image& image) {
    if (window.width == 0) return {{0, 0}, {image.width - 1, image.height - 1}};
    return {{window.x, window.y}, {window.x + window.width - 1, window.y + window.height - 1}};
}

Imf::Compression compression_of(ExrCompression compression) {
    switch (compression) {
        case ExrCompression::none: return Imf::NO_COMPRESSION;
        case ExrCompression::zip: return Imf::ZIP_COMPRESSION;
        case ExrCompression::piz: return Imf::PIZ_COMPRESSION;
        case ExrCompression::dwaa: return Imf::DWAA_COMPRESSION;
    }
    return Imf::NO_COMPRESSION;
}

Imf::PixelType type_of(const ExrPlan& plan) { return plan.half ? Imf::HALF : Imf::FLOAT; }

Imf::Header header_of(const Image& image, const ExrPlan& plan) {
    Imf::Header header(box_of(plan.display, image), box_of(plan.data, image));
    header.compression() = compression_of(plan.compression);
    for (const ExrChannel& channel : plan.channels)
        header.channels().insert(channel.name, Imf::Channel(type_of(plan)));
    if (plan.chromaticities.size() == 8) {
        const auto& c = plan.chromaticities;
        Imf::addChromaticities(header, {{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}});
    }
    if (plan.tile_size > 0)
        header.setTileDescription(Imf::TileDescription(plan.tile_size, plan.tile_size));
    return header;
}

/// The channels' values in the file's type, with the frame buffer that points at them.
class Planes {
public:
    Planes(const Image& image, const ExrPlan& plan) : origin_(box_of(plan.data, image).min) {
        for (const ExrChannel& channel : plan.channels) {
            const auto value = [&](size_t i) {
                return channel.source < 0 ? channel.value
                                          : image.rgb[3 * i + static_cast<size_t>(channel.source)];
            };
            if (plan.half)
                add(channel.name, halves_.emplace_back(), image, value, Imf::HALF);
            else
                add(channel.name, floats_.emplace_back(), image, value, Imf::FLOAT);
        }
    }

    const Imf::FrameBuffer& frame_buffer() const { return frame_buffer_; }

private:
    template <class Number, class Value>
    void add(const std::string& name, std::vector<Number>& plane, const Image& image,
             const Value& value, Imf::PixelType type) {
        plane.resize(image.rgb.size() / 3);
        for (size_t i = 0; i < plane.size(); ++i) plane[i] = Number(value(i));
        const size_t row = sizeof(Number) * static_cast<size_t>(image.width);
        frame_buffer_.insert(name, Imf::Slice::Make(type, plane.data(), origin_, image.width,
                                                    image.height, sizeof(Number), row));
    }

    Imath::V2i origin_;
    std::deque<std::vector<half>> halves_;
    std::deque<std::vector<float>> floats_;
    Imf::FrameBuffer frame_buffer_;
};

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image, const ExrPlan& plan) {
    const Imf::Header header = header_of(image, plan);
    const Planes planes(image, plan);
    if (plan.tile_size > 0) {
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(planes.frame_buffer());
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        return;
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(planes.frame_buffer());
    file.writePixels(image.height);
}

void write_luminance_chroma_exr(const std::filesystem::path& path, const Image& image) {
    Imf::Array2D<Imf::Rgba> pixels(image.height, image.width);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto rgb = image.row(y).subspan(3 * static_cast<size_t>(x), 3);
            pixels[y][x] = Imf::Rgba(rgb[0], rgb[1], rgb[2]);
        }
    Imf::RgbaOutputFile file(path.c_str(), image.width, image.height, Imf::WRITE_YC);
    file.setFrameBuffer(&pixels[0][0], 1, static_cast<size_t>(image.width));
    file.writePixels(image.height);
}

void write_multi_part_exr(const std::filesystem::path& path, const Image& image) {
    ExrPlan depth, colors;
    depth.channels = {{"Z", -1, 10}};
    std::vector<Imf::Header> headers = {header_of(image, depth), header_of(image, colors)};
    headers[0].setName("depth");
    headers[1].setName("beauty");
    for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (const int part : {0, 1}) {
        const Planes planes(image, part == 0 ? depth : colors);
        Imf::OutputPart output(file, part);
        output.setFrameBuffer(planes.frame_buffer());
        output.writePixels(image.height);
    }
}

}  // namespace splitsum::test_data
