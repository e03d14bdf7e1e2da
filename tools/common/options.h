#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "common/values.h"
#include "splitsum/base/result.h"
#include "splitsum/container/containers.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/plan/asset_plan.h"
#include "splitsum/sphere/orientation.h"
#include "splitsum/texture/pixel_format.h"

// Groups of options that several tools share, so that a flag means the same in all of them. Each
// registers itself on an app when it is made and holds the values once the app has parsed; it must
// stay where it is until then. Numbers out of range and unknown names are refused while parsing.

namespace splitsum::tools {

/// How panoramas are read: --colorspace, --ocio-config, --layer, --exposure, --repair. `fallback` is what
/// --help names as the default of --exposure where that is not 0.
struct ReadingOptions {
    /// Whether there is an --exposure of panoramas, or it is left to the tool.
    enum class Exposure { option, none };

    explicit ReadingOptions(CLI::App& app, const std::string& fallback = "",
                            Exposure exposure = Exposure::option);
    ReadingOptions(const ReadingOptions&) = delete;

    PanoramaOptions plan() const;
    bool exposure_given() const { return exposure_ && exposure_->count() > 0; }

private:
    PanoramaOptions plan_;
    std::string ocio_config_;  // the option, else $OCIO, else ""
    CLI::Option* exposure_ = nullptr;
};

/// PANORAMA, one or several, and how they are read.
struct InputOptions {
    enum class Count { one, many };

    explicit InputOptions(CLI::App& app, Count count = Count::one);
    InputOptions(const InputOptions&) = delete;

    std::filesystem::path panorama() const { return panoramas.front(); }
    PanoramaOptions plan() const { return reading_.plan(); }

    std::vector<std::string> panoramas;  ///< at least one

private:
    ReadingOptions reading_;
};

/// --rotate, --mirror, --convention; `fallback` as above.
struct OrientationOptions {
    explicit OrientationOptions(CLI::App& app, const std::string& fallback = "");
    OrientationOptions(const OrientationOptions&) = delete;

    Orientation plan;
    /// Whether any of them was on the command line.
    bool given() const;

private:
    std::vector<CLI::Option*> options_;
};

/// --method, --accuracy, --samples, --sequence, --heuristic, --rotate-samples, --seed. `methods`
/// are the values of --method, and one of them is the default of FilterPlan.
struct FilterOptions {
    FilterOptions(CLI::App& app, const std::vector<Choice>& methods);
    FilterOptions(const FilterOptions&) = delete;

    FilterPlan plan;
};

/// --size, --levels, --roughness.
struct SpecularOptions {
    explicit SpecularOptions(CLI::App& app);
    SpecularOptions(const SpecularOptions&) = delete;

    /// Fails with bad_argument for a roughness that cannot be read and for levels that do not fit
    /// the size.
    Result<SpecularPlan> plan() const;

private:
    SpecularPlan plan_;
    std::string roughness_ = "linear";
};

/// --size, --order, --window, --store-e; with `prefix` "irradiance-" the first is
/// --irradiance-size and so on, where a tool also has those of another asset.
struct IrradianceOptions {
    explicit IrradianceOptions(CLI::App& app, const std::string& prefix = "");
    IrradianceOptions(const IrradianceOptions&) = delete;

    IrradiancePlan plan;
};

/// --table, --method, --accuracy, --samples, --size, --layout, --axes, --roughness-axis, --flip,
/// --geometry; with `prefix` "table-" they are --table-kind, --table-method and so on. Size, layout and
/// axes that are not on the command line are those of the kind's default_plan.
struct TableOptions {
    explicit TableOptions(CLI::App& app, const std::string& prefix = "");
    TableOptions(const TableOptions&) = delete;

    TablePlan plan() const;

private:
    TablePlan plan_;
    std::string size_;
    double accuracy_ = 0;
    CLI::Option* accuracy_given_;
    CLI::Option* size_given_;
    CLI::Option* layout_given_;
    CLI::Option* axes_given_;
    std::string geometry_;
    std::string layout_;
    std::string axes_;
    std::string roughness_axis_;
};

/// The endings that name a container, for --help: ".ktx2 or .exr or .dds".
std::string container_endings();

/// How the texels are stored: --format, --zstd, --zstd-level.
struct EncodingOptions {
    /// Which formats there are to choose from.
    enum class Content { cubemap, table };

    /// `prefix` as above.
    EncodingOptions(CLI::App& app, Content content, const std::string& prefix = "");
    EncodingOptions(const EncodingOptions&) = delete;

    PixelFormat format() const;
    bool format_given() const { return format_given_->count() > 0; }
    ContainerOptions container() const { return container_; }

private:
    CLI::Option* format_given_;
    std::string format_;
    ContainerOptions container_;
};

/// -o, --output: a file or a folder, as `placeholder` (FILE, DIR) and `text` say.
struct OutputOptions {
    OutputOptions(CLI::App& app, const std::string& placeholder, const std::string& text);
    OutputOptions(const OutputOptions&) = delete;

    std::filesystem::path path() const { return path_; }

private:
    std::string path_;
};

/// --json.
struct JsonOption {
    explicit JsonOption(CLI::App& app);
    JsonOption(const JsonOption&) = delete;

    bool json = false;
};

}  // namespace splitsum::tools
