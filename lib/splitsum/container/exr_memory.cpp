#include <OpenEXR/IexBaseExc.h>

#include <algorithm>
#include <cstring>

#include "splitsum/container/exr_memory_detail.h"

namespace splitsum::exr {

void MemoryOutput::write(const char data[], int count) {
    const uint64_t end = position_ + static_cast<uint64_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, data, static_cast<size_t>(count));
    position_ = end;
}

bool MemoryInput::read(char data[], int count) {
    const auto wanted = static_cast<uint64_t>(std::max(count, 0));
    if (position_ > bytes_.size() || wanted > bytes_.size() - position_)
        throw Iex::InputExc("Unexpected end of file.");
    std::memcpy(data, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
}

}  // namespace splitsum::exr
