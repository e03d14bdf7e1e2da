#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace splitsum {

/// An option and its value, and where a manifest gives it.
struct Setting {
    std::string option;  ///< the long name without dashes
    std::string value;   ///< as typed behind "--option="; of a flag "true" or "false"
    bool is_flag = false;
    std::filesystem::path file;
    int line = 0;  ///< from 1
};

/// "bake.toml:12".
std::string place_of(const Setting& setting);

/// Both, in the order of their names; of an option that both have, that of `above`. Each must have
/// an option once and be in that order.
std::vector<Setting> overlaid(const std::vector<Setting>& above, const std::vector<Setting>& below);

}  // namespace splitsum
