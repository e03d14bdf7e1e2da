#include "splitsum/atlas/image_bytes.h"

#include <bit>
#include <cstdint>
#include <functional>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

void append(std::string& bytes, uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
}

void append(std::string& bytes, float value) { append(bytes, std::bit_cast<uint32_t>(value), 4); }

void append_attribute(std::string& bytes, const char* name, const char* type,
                      const std::string& value) {
    bytes.append(name) += '\0';
    bytes.append(type) += '\0';
    append(bytes, value.size(), 4);
    bytes += value;
}

std::string box(const ExrWindow& window) {
    std::string bytes;
    for (const int corner :
         {window.x, window.y, window.x + window.width - 1, window.y + window.height - 1})
        append(bytes, static_cast<uint32_t>(corner), 4);
    return bytes;
}

enum class ExrNumber : uint32_t { half = 1, single = 2 };

std::string channel_list(const std::vector<std::string>& names, ExrNumber type) {
    std::string bytes;
    for (const std::string& name : names) {
        bytes += name + '\0';
        append(bytes, static_cast<uint32_t>(type), 4);
        append(bytes, 0, 4);  // not perceptually linear, and padding
        append(bytes, 1, 4);  // every pixel of a row
        append(bytes, 1, 4);  // and every row
    }
    return bytes + '\0';
}

std::string header(const std::string& channels, const ExrWindow& data, const ExrWindow& display) {
    std::string one, bytes;
    append(one, 1.0f);
    append(bytes, 20000630, 4);
    append(bytes, 2, 4);
    append_attribute(bytes, "channels", "chlist", channels);
    append_attribute(bytes, "compression", "compression", std::string(1, '\0'));
    append_attribute(bytes, "dataWindow", "box2i", box(data));
    append_attribute(bytes, "displayWindow", "box2i", box(display));
    append_attribute(bytes, "lineOrder", "lineOrder", std::string(1, '\0'));
    append_attribute(bytes, "pixelAspectRatio", "float", one);
    append_attribute(bytes, "screenWindowCenter", "v2f", std::string(8, '\0'));
    append_attribute(bytes, "screenWindowWidth", "float", one);
    return bytes + '\0';
}

// The header, where each row begins, and the rows; row(y) returns the bytes of all its channels.
std::string whole_file(const std::string& head, const ExrWindow& data,
                       const std::function<std::string(int y)>& row) {
    std::string offsets, rows;
    const size_t first = head.size() + 8 * static_cast<size_t>(data.height);
    for (int y = 0; y < data.height; ++y) {
        const std::string values = row(y);
        append(offsets, first + rows.size(), 8);
        append(rows, static_cast<uint32_t>(data.y + y), 4);
        append(rows, values.size(), 4);
        rows += values;
    }
    return head + offsets + rows;
}

}  // namespace

std::string pfm_bytes(const Image& image) {
    std::string bytes = cat("PF\n", image.width, " ", image.height, "\n-1.0\n");
    for (int y = image.height - 1; y >= 0; --y)
        for (const float value : image.row(y)) append(bytes, value);
    return bytes;
}

std::string exr_bytes(const Image& pixels, const std::vector<ExrPlane>& planes,
                      const ExrWindow& data, const ExrWindow& display) {
    std::vector<std::string> names;
    for (const ExrPlane& plane : planes) names.push_back(plane.name);
    const std::string head = header(channel_list(names, ExrNumber::single), data, display);
    return whole_file(head, data, [&](int y) {
        std::string values;
        for (const ExrPlane& plane : planes)
            for (int x = 0; x < data.width; ++x)
                append(values, plane.channel < 0
                                   ? plane.value
                                   : pixels.row(y)[static_cast<size_t>(3 * x + plane.channel)]);
        return values;
    });
}

std::string overflowed_half_exr_bytes(int width, int height) {
    constexpr uint32_t one_half = 0x3800, infinity = 0x7c00;
    const ExrWindow window{0, 0, width, height};
    const std::string head = header(channel_list({"B", "G", "R"}, ExrNumber::half), window, window);
    return whole_file(head, window, [&](int y) {
        std::string values;
        for (int i = 0; i < 3 * width; ++i)
            append(values, y == 0 && i == 2 * width ? infinity : one_half, 2);
        return values;
    });
}

}  // namespace splitsum
