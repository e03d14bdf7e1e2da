#pragma once

#include <string_view>

namespace splitsum {

/// What a run did about one output.
enum class Outcome {
    baked,
    from_cache,  ///< copied from the content cache
    up_to_date,  ///< nothing had to be done
    failed,
    not_begun,  ///< nothing was done: only asked about, or the run was stopped before
};

/// As reports and events name it: "baked", "from_cache", ...
constexpr std::string_view name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::baked: return "baked";
        case Outcome::from_cache: return "from_cache";
        case Outcome::up_to_date: return "up_to_date";
        case Outcome::failed: return "failed";
        case Outcome::not_begun: return "not_begun";
    }
    return "";
}

}  // namespace splitsum
