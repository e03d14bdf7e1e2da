#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/filter_tables.h"
#include "splitsum/filter/spectrum.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The light to be filtered.
struct FilterSource {
    /// `shared` are tables to be used for other lights too; without them, new ones.
    FilterSource(const Environment& light, std::shared_ptr<FilterTables> shared = nullptr)
        : environment(light),
          tables(shared ? std::move(shared) : std::make_shared<FilterTables>()) {}

    const Environment& environment;
    std::shared_ptr<FilterTables> tables;

    /// Of the light itself, where `environment` is an average of it (a large panorama that was
    /// streamed); null where the environment is the light.
    const Spectrum* spectrum = nullptr;
    std::span<const Cubemap> mirrors{};  ///< likewise: area-filtered, one for each mirror_sizes
};

}  // namespace splitsum
