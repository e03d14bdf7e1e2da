#pragma once

#include <string>

namespace splitsum {

/// What a manifest may say after the name of an option.
enum class OptionType {
    flag,            ///< true or false
    number,          ///< a number
    text,            ///< text in quotes
    number_or_text,  ///< either, such as 256 or "auto"
    number_list,     ///< a list of numbers, or text, such as [0, 0.5, 1] or "linear"
    path,            ///< text: a file or a folder, relative to the manifest that names it
};

/// Where an option may be given.
enum class OptionPlace {
    panorama,      ///< for each panorama, and as a default of many
    run,           ///< once, as it holds for the whole run: in the defaults of the first manifest
    command_line,  ///< nowhere in a manifest
};

/// An option that the program has. The manifest module knows none itself.
struct KnownOption {
    std::string name;  ///< its long name without dashes
    OptionType type = OptionType::text;
    OptionPlace place = OptionPlace::panorama;
};

}  // namespace splitsum
