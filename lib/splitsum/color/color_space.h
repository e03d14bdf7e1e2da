#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/color/primaries.h"
#include "splitsum/image/image.h"

namespace splitsum {

/// The working space, as named in outputs: linear light, Rec.709 primaries, D65 white.
inline constexpr const char* working_space = "lin_rec709";

/// Takes pixels of one colour space to the working space.
class ColorConverter {
public:
    /// The working space itself.
    ColorConverter();
    ~ColorConverter();
    ColorConverter(ColorConverter&&) noexcept;
    ColorConverter& operator=(ColorConverter&&) noexcept;

    /// Converts in place. Values outside the target's gamut come out negative: nothing is clamped.
    /// Where the two spaces are the same, every bit stays.
    void apply(Image& image) const;

    /// The same for a row of pixels, three interleaved floats each, on the calling thread.
    void apply(std::span<float> rgb) const;

    bool changes_nothing() const;

private:
    friend class ColorConfig;
    struct State;
    std::unique_ptr<State> state_;
};

/// The colour spaces that files may be in: an OpenColorIO config.
class ColorConfig {
public:
    /// The built-in config where `file` is empty; no file is read then.
    /// Fails with unreadable_input (absent or no config) and bad_argument (a config that says
    /// neither what scene_linear nor what aces_interchange is).
    static Result<ColorConfig> load(const std::filesystem::path& file);

    ~ColorConfig();
    ColorConfig(ColorConfig&&) noexcept;
    ColorConfig& operator=(ColorConfig&&) noexcept;

    /// The space that a name, an alias or a role stands for, in the config's own spelling.
    std::optional<std::string> find(const std::string& name) const;

    /// The space that files without any statement are taken to be in: scene-linear.
    std::string default_space() const;

    /// Every space, in the config's order.
    std::vector<std::string> spaces() const;

    /// From the named space to the working space. A config with the role aces_interchange is joined
    /// to Rec.709 through it; without, its scene_linear is taken for the working space and note()
    /// says so. Fails with bad_argument: an unknown name (the names that exist are listed).
    Result<ColorConverter> converter_from(const std::string& name) const;

    /// From linear RGB of any primaries to the working space; the whites are matched by Bradford.
    /// Fails with bad_argument where the primaries span no colours.
    static Result<ColorConverter> converter_from_primaries(const Primaries& primaries);

    /// What users should know about this config, or "".
    const std::string& note() const;

private:
    struct State;
    explicit ColorConfig(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// The built-in space whose primaries are these to within 1e-3.
std::optional<std::string> space_with_primaries(const Primaries& primaries);

}  // namespace splitsum
