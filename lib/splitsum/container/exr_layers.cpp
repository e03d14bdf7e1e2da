#include "splitsum/container/exr_layers.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "splitsum/base/text.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_memory_detail.h"
#include "splitsum/container/file_detail.h"

namespace splitsum {
namespace {

constexpr const char* channels[] = {"R", "G", "B"};

std::string channel_of(const ExrLayer& layer, int channel) {
    return layer.name.empty() ? channels[channel] : cat(layer.name, ".", channels[channel]);
}

Status check(std::span<const ExrLayer> layers) {
    if (layers.empty()) return Error{ErrorKind::bad_argument, "a file of layers needs one"};
    for (const ExrLayer& layer : layers)
        if (layer.picture->width != layers[0].picture->width ||
            layer.picture->height != layers[0].picture->height)
            return Error{ErrorKind::bad_argument, "the layers of a file must have one size"};
    return ok;
}

Imf::Header header_of(std::span<const ExrLayer> layers,
                      const std::map<std::string, std::string>& attributes) {
    Imf::Header header(layers[0].picture->width, layers[0].picture->height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrLayer& layer : layers)
        for (int c = 0; c < 3; ++c)
            header.channels().insert(channel_of(layer, c), Imf::Channel(Imf::FLOAT));
    for (const auto& [key, value] : attributes) header.insert(key, Imf::StringAttribute(value));
    return header;
}

Imf::FrameBuffer frame_buffer_of(std::span<const ExrLayer> layers) {
    Imf::FrameBuffer buffer;
    for (const ExrLayer& layer : layers)
        for (int c = 0; c < 3; ++c) {
            // OpenEXR wants bytes that it could change, and does not change what it writes.
            auto* first = const_cast<float*>(layer.picture->rgb.data()) + c;
            buffer.insert(channel_of(layer, c),
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), 3 * sizeof(float),
                                     3 * sizeof(float) * size_t(layer.picture->width)));
        }
    return buffer;
}

}  // namespace

Status write_exr_layers(std::span<const ExrLayer> layers,
                        const std::map<std::string, std::string>& attributes,
                        const std::filesystem::path& path) {
    if (const Status valid = check(layers); !valid) return valid;
    return write_encoded(path,
                         exr::guarded(ErrorKind::internal, [&]() -> Result<std::vector<std::byte>> {
                             exr::MemoryOutput stream;
                             {
                                 Imf::OutputFile file(stream, header_of(layers, attributes));
                                 file.setFrameBuffer(frame_buffer_of(layers));
                                 file.writePixels(layers[0].picture->height);
                             }
                             return stream.take();
                         }));
}

}  // namespace splitsum
