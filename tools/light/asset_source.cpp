#include "light/asset_source.h"

#include "splitsum/base/text.h"

namespace splitsum::tools {

Result<AssetSource> read_asset_source(const std::filesystem::path& panorama,
                                      const std::optional<AssetFacts>& facts,
                                      const ReadingOptions& options, Progress& progress) {
    PanoramaOptions reading = options.plan();
    if (facts && !options.exposure_given()) reading.exposure_stops = facts->source.exposure_stops;
    auto read = read_panorama(panorama, reading, progress);
    if (!read) return read.error();
    AssetSource source{std::move(*read), false, {}};
    source.notes = source.panorama.notes;
    source.is_source = facts && facts->source.hash == source.panorama.source_hash;
    if (facts && !source.is_source)
        source.notes.push_back(cat("the asset says it was made from ", facts->source.name, ", ",
                                   facts->source.hash, "; this panorama is ",
                                   source.panorama.source_hash));
    return source;
}

}  // namespace splitsum::tools
