#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include "common/options.h"
#include "splitsum/base/result.h"
#include "splitsum/preview/baked_files.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/picture.h"
#include "splitsum/preview/scene.h"

namespace splitsum::tools {

/// BAKED, --specular, --irradiance, --table.
struct AssetOptions {
    explicit AssetOptions(CLI::App& app);
    AssetOptions(const AssetOptions&) = delete;

    /// Fails with bad_argument where no file is named for one of them.
    Result<BakedFiles> files() const;

private:
    std::string folder_, specular_, irradiance_, table_;
};

/// --scene, --size, --yaw, --pitch, --background, --no-background.
struct SceneOptions {
    explicit SceneOptions(CLI::App& app);
    SceneOptions(const SceneOptions&) = delete;

    /// Fails as read_scene does.
    Result<Scene> scene() const;
    Viewpoint viewpoint() const { return viewpoint_; }
    Background background() const { return background_ ? Background::light : Background::black; }

private:
    std::string file_;
    Viewpoint viewpoint_;
    bool background_ = true;
};

/// --view, --exposure.
struct ViewOptions {
    explicit ViewOptions(CLI::App& app);
    ViewOptions(const ViewOptions&) = delete;

    std::string name;
    /// Nothing: as bright as the light asks for.
    std::optional<double> exposure_stops() const;

private:
    std::string exposure_ = "auto";
};

/// Every option of splitsum-preview.
struct PreviewOptions {
    explicit PreviewOptions(CLI::App& app);
    PreviewOptions(const PreviewOptions&) = delete;

    AssetOptions assets;
    OutputOptions output;
    std::string panorama;  ///< "" if there is none
    SceneOptions scene;
    ViewOptions view;
    ReadingOptions reading;
    int probes = 64;
    JsonOption json;
};

}  // namespace splitsum::tools
