// The code that all programs share, called directly.
#include <gtest/gtest.h>
#include <signal.h>

#include <limits>

#include "common/options.h"
#include "common/progress_line.h"
#include "common/run_tool.h"
#include "common/usage_error.h"

namespace splitsum::tools {
namespace {

// Parses a command line with option groups that `Group` registers.
template <class Parse>
std::string parse_failure(std::vector<std::string> arguments, const Parse& parse) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    CLI::App app("", "tool");
    try {
        parse(app, [&] { app.parse(arguments); });
    } catch (const CLI::ParseError& error) {
        return usage_message(app, error);
    }
    return "";
}

TEST(WholeNumber, TakesWholeNumbersInItsRangeOnly) {
    const CLI::Validator validator = whole_number(-2, 8192);
    for (std::string text : {"-2", "0", "+7", "8192", "007"})
        EXPECT_EQ(validator(text), "") << text;
    for (std::string text : {"-3", "8193", "1.5", "1e3", "0x10", "12px", " 1", "", "+", "-", "+-1",
                             "18446744073709551617"})
        EXPECT_NE(validator(text), "") << text;
}

TEST(FiniteNumber, RefusesWhatIsNotOne) {
    const CLI::Validator validator = finite_number(-64, 64);
    for (std::string text : {"-64", "0.5", "+1.5", "1e1"}) EXPECT_EQ(validator(text), "") << text;
    for (std::string text : {"nan", "inf", "-inf", "64.01", "1,5", "", "one"})
        EXPECT_NE(validator(text), "") << text;
}

TEST(ByteCount, TakesWholeNumbersWithAUnit) {
    constexpr int64_t largest = std::numeric_limits<int64_t>::max();
    int64_t bytes = 0;
    const auto failure_of = [&](const std::string& text, int64_t lowest, int64_t highest) {
        return parse_failure({"--size", text}, [&](CLI::App& app, const auto& parse) {
            app.add_option("--size", bytes)->transform(byte_count(lowest, highest));
            parse();
        });
    };
    const std::pair<const char*, int64_t> sizes[] = {{"0", 0},
                                                     {"1", 1},
                                                     {"1000", 1000},
                                                     {"3K", 3072},
                                                     {"600M", 629145600},
                                                     {"10G", 10737418240},
                                                     {"2T", 2199023255552},
                                                     {"9223372036854775807", largest},
                                                     {"8388607T", 8388607 * (int64_t(1) << 40)}};
    for (const auto& [text, expected] : sizes) {
        EXPECT_EQ(failure_of(text, 0, largest), "");
        EXPECT_EQ(bytes, expected) << text;
        EXPECT_EQ(byte_count_text(expected), text);
    }
    for (const char* text :
         {"", "-1", "-0K", "K", "1.5G", "1e3", "10g", "10GB", "10 G", "G10", "1KK", "0x10",
          "9223372036854775808", "8388608T", "9007199254740992K", "nan"})
        EXPECT_NE(failure_of(text, 0, largest), "") << text;
    EXPECT_EQ(failure_of("256M", 256 << 20, 1 << 30), "");
    EXPECT_EQ(failure_of("1G", 256 << 20, 1 << 30), "");
    EXPECT_EQ(failure_of("255M", 256 << 20, 1 << 30),
              "--size: '255M' is not a size from 256M to 1G: a whole number of bytes, or one with "
              "K, M, G or T behind it; see tool --help");
    EXPECT_NE(failure_of("1025M", 256 << 20, 1 << 30), "");
}

TEST(OrientationOptions, FillAPlan) {
    Orientation plan;
    const auto failure = parse_failure({"--rotate", "-90.5", "--mirror", "--convention", "cmgen"},
                                       [&](CLI::App& app, const auto& parse) {
                                           OrientationOptions options(app);
                                           parse();
                                           plan = options.plan;
                                       });
    EXPECT_EQ(failure, "");
    EXPECT_EQ(plan.rotate_degrees, -90.5);
    EXPECT_TRUE(plan.mirror);
    EXPECT_EQ(plan.convention, "cmgen");
}

TEST(OrientationOptions, ListTheConventions) {
    const auto failure =
        parse_failure({"--convention", "mine"}, [](CLI::App& app, const auto& parse) {
            OrientationOptions options(app);
            parse();
        });
    EXPECT_EQ(failure,
              "--convention: there is no 'mine'; there are: ktx, khronos-sampler, cmgen; see tool "
              "--help");
}

TEST(InputOptions, FillAPlan) {
    PanoramaOptions plan;
    std::vector<std::string> panoramas;
    const auto failure = parse_failure(
        {"a.exr", "--exposure", "-1.5", "b.hdr", "--repair", "--ocio-config", "c.ocio"},
        [&](CLI::App& app, const auto& parse) {
            InputOptions options(app, InputOptions::Count::many);
            parse();
            plan = options.plan();
            panoramas = options.panoramas;
        });
    EXPECT_EQ(failure, "");
    EXPECT_EQ(panoramas, (std::vector<std::string>{"a.exr", "b.hdr"}));
    EXPECT_EQ(plan.exposure_stops, -1.5);
    EXPECT_TRUE(plan.repair);
    EXPECT_EQ(plan.ocio_config, "c.ocio");
}

TEST(InputOptions, TakeOnePanoramaWhereOneIsMeant) {
    const auto failure = parse_failure({"a.exr", "b.exr"}, [](CLI::App& app, const auto& parse) {
        InputOptions options(app);
        parse();
    });
    EXPECT_EQ(failure, "PANORAMA was given 2 times; once is enough; see tool --help");
}

TEST(SpecularOptions, RefuseLevelsThatTheSizeDoesNotHave) {
    for (const auto& [levels, fits] : {std::pair{"5", true}, {"6", false}}) {
        CLI::App app;
        SpecularOptions options(app);
        app.parse(std::vector<std::string>{levels, "--levels", "16", "--size"});
        const auto plan = options.plan();
        EXPECT_EQ(bool(plan), fits);
        if (!plan) {
            EXPECT_EQ(plan.error().kind, ErrorKind::bad_argument);
        }
    }
}

TEST(EncodingOptions, OfferTheFormatsThatFit) {
    using enum EncodingOptions::Content;
    for (const auto& [content, format, fits] : {std::tuple{table, "rg32f", true},
                                                {table, "rgba16f", true},
                                                {table, "rgb9e5", false},
                                                {cubemap, "rgb9e5", true},
                                                {cubemap, "rg16f", false}}) {
        const auto failure =
            parse_failure({"--format", format, "--zstd"}, [&](CLI::App& app, const auto& parse) {
                EncodingOptions options(app, content);
                parse();
                EXPECT_EQ(info_of(options.format()).name, format);
                EXPECT_TRUE(options.container().ktx2.zstd);
            });
        EXPECT_EQ(failure.empty(), fits) << format << failure;
    }
}

TEST(TableOptions, TakeAPrefix) {
    const auto failure =
        parse_failure({"--table-size", "64", "--table-geometry", "schlick-half", "--table-kind",
                       "energy", "--table-layout", "edge"},
                      [](CLI::App& app, const auto& parse) {
                          SpecularOptions specular(app);  // has a --size of its own
                          TableOptions options(app, "table-");
                          parse();
                          EXPECT_EQ(options.plan().size, 64);
                          EXPECT_EQ(options.plan().geometry, SmithTerm::schlick_half);
                          EXPECT_EQ(options.plan().kind, "energy");
                          EXPECT_EQ(options.plan().layout, TexelLayout::edge);
                      });
    EXPECT_EQ(failure, "");
}

TEST(ProgressBar, FitsItsWidth) {
    for (int width = 1; width < 200; ++width)
        for (int percent : {0, 5, 50, 100}) {
            const std::string bar = progress_bar("filtering level 3", percent, width);
            EXPECT_LT(static_cast<int>(bar.size()), std::max(width, 2)) << width;
        }
}

TEST(ProgressBar, FillsWithThePercentage) {
    const auto filled = [](int percent) {
        const std::string bar = progress_bar("filtering", percent, 80);
        return std::count(bar.begin(), bar.end(), '#');
    };
    EXPECT_EQ(filled(0), 0);
    EXPECT_EQ(filled(50), 20);
    EXPECT_EQ(filled(100), 40);
}

// Runs `body` as a tool without arguments; gives the exit code and what it printed on stderr.
std::pair<int, std::string> run_body(const std::function<Status(Progress&)>& body) {
    CLI::App app("", "tool");
    char name[] = "tool";
    char* arguments[] = {name, nullptr};
    testing::internal::CaptureStderr();
    const int code = run_tool(app, 1, arguments, body);
    return {code, testing::internal::GetCapturedStderr()};
}

TEST(RunTool, TurnsErrorsIntoExitCodes) {
    EXPECT_EQ(run_body([](Progress&) { return Status(ok); }), std::pair(0, std::string()));
    const std::pair<ErrorKind, int> codes[] = {
        {ErrorKind::bad_argument, 2},      {ErrorKind::unreadable_input, 3},
        {ErrorKind::unwritable_output, 4}, {ErrorKind::unusable_input, 5},
        {ErrorKind::internal, 70},         {ErrorKind::interrupted, 130},
    };
    for (const auto& [kind, code] : codes)
        EXPECT_EQ(run_body([kind = kind](Progress&) {
                      return Status(Error{kind, "two\nlines\n"});
                  }),
                  std::pair(code, std::string("tool: two; lines\n")));
}

TEST(RunTool, CatchesExceptions) {
    const auto [code, message] =
        run_body([](Progress&) -> Status { throw std::runtime_error("broken"); });
    EXPECT_EQ(code, 70);
    EXPECT_EQ(message, "tool: a fault of the program: broken\n");
    EXPECT_EQ(run_body([](Progress&) -> Status { throw std::bad_alloc(); }).first, 70);
}

TEST(RunTool, PrintsALineAStageWhereThereIsNoTerminal) {
    const auto [code, text] = run_body([](Progress& progress) {
        for (const char* stage : {"reading", "filtering"}) {
            progress.begin(stage, 1000);
            for (int step = 0; step < 1000; ++step) progress.advance(1);
        }
        return Status(ok);
    });
    EXPECT_EQ(code, 0);
    EXPECT_EQ(text, "reading\nfiltering\n");
}

// In a process of its own: the signal is remembered for good.
[[noreturn]] void exit_after_a_signal() {
    CLI::App app("", "tool");
    char name[] = "tool";
    char* arguments[] = {name, nullptr};
    std::exit(run_tool(app, 1, arguments, [](Progress& progress) -> Status {
        if (progress.cancelled()) return Error{ErrorKind::internal, "cancelled too early"};
        raise(SIGTERM);
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        return ok;
    }));
}

TEST(RunToolDeathTest, HandsASignalDownAsCancellation) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(exit_after_a_signal(), testing::ExitedWithCode(130), "tool: interrupted");
}

}  // namespace
}  // namespace splitsum::tools
