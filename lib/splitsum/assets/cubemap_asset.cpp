#include "splitsum/assets/cubemap_asset.h"

#include "splitsum/base/text.h"

namespace splitsum {

Result<CubemapAsset> cubemap_asset(std::span<const Cubemap> levels, PixelFormat format,
                                   const AssetFacts& facts) {
    if (!holds_colours(info_of(format)))
        return Error{ErrorKind::bad_argument, cat("a cubemap needs a format of three channels; ",
                                                  info_of(format).name, " has two")};
    CubemapAsset asset;
    asset.texture = texture_from_cubemaps(levels, format, asset.counts);
    asset.texture.metadata = metadata_of(facts);
    auto read_back = cubemaps_of(asset.texture);
    if (!read_back) return read_back.error();
    asset.levels = std::move(*read_back);
    return asset;
}

}  // namespace splitsum
