// Settings of manifests mean what the options mean.
#include "splitsum-bake/manifest_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "splitsum-bake/plan_options.h"
#include "splitsum/base/text.h"
#include "support/temporary_folder.h"

namespace splitsum::tools {
namespace {

// A program like splitsum-bake with a manifest.
class Program {
public:
    Program() {
        app.add_flag("--force", force);
        app.add_option("--threads", threads)->option_text("COUNT")->check(whole_number(0, 1024));
    }

    // What was typed, and then the manifest.
    Result<std::vector<PanoramaPlan>> plans(std::vector<std::string> typed,
                                            const std::string& toml) {
        std::ranges::reverse(typed);
        app.parse(typed);
        const auto manifest = read(toml);
        if (!manifest) return manifest.error();
        if (const Status applied = apply_run_settings(app, manifest->run); !applied)
            return applied.error();
        return plans_of_manifest(manifest->panoramas, app);
    }
    // The plan of the first panorama.
    PanoramaPlan plan(const std::vector<std::string>& typed, const std::string& toml) {
        const auto all = plans(typed, toml);
        EXPECT_TRUE(all) << all.error().message;
        return all ? all->front() : PanoramaPlan{};
    }
    std::string failure(const std::string& toml) {
        const auto all = plans({}, toml);
        if (all) return "";
        EXPECT_EQ(all.error().kind, ErrorKind::bad_argument);
        std::string message = all.error().message;
        const std::string folder = folder_.path().string() + "/";
        for (size_t at = 0; (at = message.find(folder)) != std::string::npos;)
            message.erase(at, folder.size());
        return message;
    }
    std::string path_of(const std::string& name) const { return folder_ / name; }

    CLI::App app;
    PlanOptions asset{app};
    TableOptions table{app, "table-"};
    int threads = 0;
    bool force = false;

private:
    Result<Manifest> read(const std::string& toml) {
        tests::write_bytes(folder_ / "bake.toml", toml);
        return read_manifest(folder_ / "bake.toml", options_of_manifests(app));
    }
    tests::TemporaryFolder folder_;
};

const std::string list = "panoramas = ['a.exr']\n[defaults]\n";

TEST(OptionsOfManifests, HaveTheTypesAndPlacesOfTheProgram) {
    Program program;
    std::map<std::string, std::pair<OptionType, OptionPlace>> found;
    for (const KnownOption& option : options_of_manifests(program.app))
        found[option.name] = {option.type, option.place};
    using enum OptionType;
    const auto expect = [&](const char* name, OptionType type, OptionPlace place) {
        ASSERT_TRUE(found.contains(name)) << name;
        EXPECT_EQ(found[name], std::pair(type, place)) << name;
    };
    for (const char* name : {"size", "levels", "exposure", "rotate", "accuracy", "samples", "seed",
                             "probes", "irradiance-size", "irradiance-order", "zstd-level"})
        expect(name, number, OptionPlace::panorama);
    for (const char* name :
         {"repair", "mirror", "verify", "zstd", "no-picture", "irradiance-window"})
        expect(name, flag, OptionPlace::panorama);
    for (const char* name : {"colorspace", "layer", "method", "convention", "format"})
        expect(name, text, OptionPlace::panorama);
    expect("roughness", number_list, OptionPlace::panorama);
    expect("ocio-config", path, OptionPlace::panorama);
    expect("table-size", number_or_text, OptionPlace::run);
    expect("table-kind", text, OptionPlace::run);
    expect("threads", number, OptionPlace::run);
    expect("force", flag, OptionPlace::command_line);
    expect("help", flag, OptionPlace::command_line);
    EXPECT_FALSE(found.contains("no-verify"));
}

// The same words as options and as settings give the same plans.
TEST(PlansOfManifest, AreThoseOfTheCommandLine) {
    Program typed;
    const PanoramaPlan by_hand = typed.plan(
        {"--size=64", "--levels=3", "--roughness=0,0.25,1", "--exposure=-1.5", "--rotate=90",
         "--mirror", "--repair", "--no-verify", "--convention=cmgen", "--format=rgb9e5",
         "--no-picture", "--irradiance-order=4", "--seed=4294967295", "--accuracy=0.001"},
        "panoramas = ['a.exr']");
    Program program;
    const PanoramaPlan read = program.plan({}, list + R"(
size = 64
levels = 3
roughness = [0, 0.25, 1]
exposure = -1.5
rotate = 90
mirror = true
repair = true
verify = false
convention = "cmgen"
format = "rgb9e5"
no-picture = true
irradiance-order = 4
seed = 4294967295
accuracy = 1e-3
)");
    for (const PanoramaPlan& plan : {by_hand, read}) {
        EXPECT_EQ(plan.plan.specular.face_size, 64);
        EXPECT_EQ(plan.plan.specular.levels, 3);
        EXPECT_EQ(to_string(plan.plan.specular.roughness), "0,0.25,1");
        EXPECT_EQ(plan.reading.exposure_stops, -1.5);
        EXPECT_EQ(plan.plan.orientation.rotate_degrees, 90);
        EXPECT_TRUE(plan.plan.orientation.mirror);
        EXPECT_TRUE(plan.reading.repair);
        EXPECT_EQ(plan.plan.probes, 0);
        EXPECT_EQ(plan.plan.orientation.convention, "cmgen");
        EXPECT_EQ(plan.plan.format, PixelFormat::rgb9e5);
        EXPECT_FALSE(plan.plan.picture);
        EXPECT_EQ(plan.plan.irradiance.harmonics_order, 4);
        EXPECT_EQ(plan.plan.filter.seed, 4294967295u);
        EXPECT_EQ(plan.plan.filter.accuracy, 1e-3);
    }
}

TEST(PlansOfManifest, FlagsCanBeTakenBack) {
    const std::string toml =
        "[defaults]\nrepair = true\nverify = false\nno-picture = true\nzstd = true\nzstd-level = "
        "9\n"
        "[[panoramas]]\nfile = 'a.exr'\n"
        "[[panoramas]]\nfile = 'b.exr'\nrepair = false\nverify = true\nno-picture = false\n"
        "zstd = false\n";
    Program program;
    const auto plans = program.plans({}, toml);
    ASSERT_TRUE(plans) << plans.error().message;
    EXPECT_TRUE((*plans)[0].reading.repair);
    EXPECT_EQ((*plans)[0].plan.probes, 0);
    EXPECT_FALSE((*plans)[0].plan.picture);
    EXPECT_TRUE((*plans)[0].plan.container.ktx2.zstd);
    EXPECT_FALSE((*plans)[1].reading.repair);
    EXPECT_EQ((*plans)[1].plan.probes, std::nullopt);
    EXPECT_TRUE((*plans)[1].plan.picture);
    EXPECT_FALSE((*plans)[1].plan.container.ktx2.zstd);
}

TEST(PlansOfManifest, YieldToWhatWasTyped) {
    Program program;
    const auto plans = program.plans({"--size", "32", "--verify", "--exposure", "2"},
                                     "[defaults]\nsize = 64\nlevels = 2\nverify = false\n"
                                     "[[panoramas]]\nfile = 'a.exr'\nexposure = 1\nlevels = 3\n"
                                     "[[panoramas]]\nfile = 'b.exr'\nsize = 128\n");
    ASSERT_TRUE(plans) << plans.error().message;
    for (const PanoramaPlan& plan : *plans) {
        EXPECT_EQ(plan.plan.specular.face_size, 32);
        EXPECT_EQ(plan.reading.exposure_stops, 2);
        EXPECT_EQ(plan.plan.probes, std::nullopt);
    }
    EXPECT_EQ((*plans)[0].plan.specular.levels, 3);
    EXPECT_EQ((*plans)[1].plan.specular.levels, 2);
}

TEST(PlansOfManifest, OverrideTheEnvironment) {
    setenv("OCIO", "/environment/config.ocio", 1);
    Program given, silent, typed;
    const PanoramaPlan plan = given.plan({}, list + "ocio-config = 'colour/config.ocio'\n");
    EXPECT_EQ(plan.reading.ocio_config, given.path_of("colour/config.ocio"));
    EXPECT_EQ(silent.plan({}, list).reading.ocio_config, "/environment/config.ocio");
    EXPECT_EQ(typed.plan({"--ocio-config", "typed.ocio"}, list + "ocio-config = 'a'\n")
                  .reading.ocio_config,
              "typed.ocio");
    unsetenv("OCIO");
}

TEST(PlansOfManifest, NameThePlaceOfAValueThatIsRefused) {
    EXPECT_EQ(Program().failure(list + "\nexposure = 99\n"),
              "bake.toml:4: exposure: '99' is not a number from -64 to 64");
    EXPECT_EQ(Program().failure(list + "size = 0.5"),
              "bake.toml:3: size: '0.5' is not a whole number from 1 to 8192");
    EXPECT_TRUE(Program()
                    .failure(list + "convention = 'other'")
                    .starts_with("bake.toml:3: convention: there is no 'other'; there are: "));
    // These are wrong together only, or need all of the plan to be found wrong.
    EXPECT_TRUE(Program()
                    .failure("[[panoramas]]\nfile = 'a'\nzstd-level = 3\n")
                    .starts_with("bake.toml:1: --zstd-level requires --zstd"))
        << Program().failure("[[panoramas]]\nfile = 'a'\nzstd-level = 3\n");
    EXPECT_TRUE(Program()
                    .failure("[[panoramas]]\nfile = 'a'\nsize = 4\nlevels = 9\n")
                    .starts_with("bake.toml:1: "));
    EXPECT_TRUE(
        Program().failure(list + "roughness = 'steep'").starts_with("bake.toml:1: 'steep'"));
}

TEST(PlansOfManifest, TellUpToTenProblemsEachOnce) {
    std::string toml;
    for (int i = 0; i < 30; ++i)
        toml += cat("[[panoramas]]\nfile = '", i, "'\nexposure = ", 100 + i, "\n");
    const std::string message = Program().failure(toml);
    EXPECT_EQ(std::ranges::count(message, '\n'), 9);
    EXPECT_TRUE(message.starts_with("bake.toml:3: exposure: '100'")) << message;
    // Of one bad default many panoramas suffer, but it is one problem.
    toml = "[defaults]\nexposure = 99\n";
    for (int i = 0; i < 30; ++i) toml += cat("[[panoramas]]\nfile = '", i, "'\nrotate = ", i, "\n");
    EXPECT_EQ(Program().failure(toml),
              "bake.toml:2: exposure: '99' is not a number from -64 to 64");
}

TEST(RunSettings, ReachTheProgramUnlessTyped) {
    const std::string toml = list + "threads = 3\ntable-size = 64\ntable-kind = 'energy'\n";
    Program silent;
    silent.plan({}, toml);
    EXPECT_EQ(silent.threads, 3);
    EXPECT_EQ(silent.table.plan().size, 64);
    EXPECT_EQ(silent.table.plan().kind, "energy");
    Program typed;
    typed.plan({"--threads", "2", "--table-size", "auto", "--table-accuracy", "1e-3"}, toml);
    EXPECT_EQ(typed.threads, 2);
    EXPECT_EQ(typed.table.plan().size, TablePlan::automatic_size);
    EXPECT_EQ(typed.table.plan().kind, "energy");
    EXPECT_EQ(Program().failure(list + "threads = -1"),
              "bake.toml:3: threads: '-1' is not a whole number from 0 to 1024");
    EXPECT_EQ(Program().failure(list + "table-size = 0"),
              "bake.toml:3: table-size: '0' is neither auto nor a whole number from 1 to 8192");
}

}  // namespace
}  // namespace splitsum::tools
