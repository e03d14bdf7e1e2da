#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include "common/options.h"
#include "page_file.h"
#include "splitsum/base/result.h"
#include "splitsum/preview/baked_files.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/picture.h"
#include "splitsum/preview/scene.h"
#include "splitsum/preview/truth_picture.h"

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
    std::string note() const;  ///< what the objects are, in a sentence
    Viewpoint viewpoint(const Cubemap& irradiance) const;
    Background background() const { return background_ ? Background::light : Background::black; }

private:
    std::string file_;
    std::string yaw_ = "0";
    Viewpoint viewpoint_;  // but for the yaw
    bool background_ = true;
};

/// --panorama, --truth, --noise, --time-limit, --verify, --no-verify, --probes.
struct TruthOptions {
    explicit TruthOptions(CLI::App& app);
    TruthOptions(const TruthOptions&) = delete;

    TruthPlan plan() const { return plan_; }
    int probes() const { return verify_ ? probes_ : 0; }  ///< 0: nothing is measured

    std::string panorama;  ///< "" if there is none
    bool truth = false;    ///< there is a panorama then

private:
    TruthPlan plan_;
    bool verify_ = true;
    int probes_ = 64;
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
    TruthOptions truth;
    SceneOptions scene;
    ViewOptions view;
    ReadingOptions reading;
    PageOption page;
    JsonOption json;
};

}  // namespace splitsum::tools
