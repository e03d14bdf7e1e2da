#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "splitsum/manifest/manifest.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {

/// Options of every type and place, as a program might have them.
inline const std::vector<KnownOption>& some_options() {
    static const std::vector<KnownOption> options = {
        {"size", OptionType::number, OptionPlace::panorama},
        {"exposure", OptionType::number, OptionPlace::panorama},
        {"rotate", OptionType::number, OptionPlace::panorama},
        {"repair", OptionType::flag, OptionPlace::panorama},
        {"verify", OptionType::flag, OptionPlace::panorama},
        {"layer", OptionType::text, OptionPlace::panorama},
        {"roughness", OptionType::number_list, OptionPlace::panorama},
        {"ocio-config", OptionType::path, OptionPlace::panorama},
        {"table-size", OptionType::number_or_text, OptionPlace::run},
        {"threads", OptionType::number, OptionPlace::run},
        {"output", OptionType::path, OptionPlace::run},
        {"force", OptionType::flag, OptionPlace::command_line},
    };
    return options;
}

/// Manifests in a folder of their own.
class Manifests {
public:
    /// Writes the file and reads it.
    Result<Manifest> read(const std::string& name, const std::string& text) const {
        write(name, text);
        return read_manifest(folder_ / name, some_options());
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        write_bytes(folder_ / name, text);
    }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

    /// The message of the error without the folder, "" if there is none.
    std::string message_of(const std::string& name, const std::string& text) const {
        const auto manifest = read(name, text);
        return manifest ? "" : shortened(manifest.error().message);
    }
    std::string shortened(std::string text) const {
        const std::string folder = folder_.path().string() + "/";
        for (size_t at = 0; (at = text.find(folder)) != std::string::npos;)
            text.erase(at, folder.size());
        return text;
    }

    /// What a manifest says, without lines: equal for twins in the two notations.
    std::string essence_of(const Manifest& manifest) const {
        std::string text = "run" + essence_of(manifest.run) + "\n";
        for (const ManifestPanorama& panorama : manifest.panoramas) {
            text += panorama.file.string() + " name=" + panorama.name.value_or("(none)") + " only=";
            for (const std::string& pattern : panorama.only) text += pattern + ";";
            text += " except=";
            for (const std::string& pattern : panorama.except) text += pattern + ";";
            text += essence_of(panorama.settings) + "\n";
        }
        return shortened(text);
    }
    static std::string essence_of(const std::vector<Setting>& settings) {
        std::string text;
        for (const Setting& setting : settings)
            text += " " + setting.option + (setting.is_flag ? "?" : "") + "=" + setting.value;
        return text;
    }

private:
    TemporaryFolder folder_;
};

}  // namespace splitsum::tests
