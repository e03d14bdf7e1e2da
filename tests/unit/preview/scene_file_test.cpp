#include "splitsum/preview/scene_file.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

// Every number is another, so that none can be mistaken for its neighbour.
const std::string two_spheres = R"({"spheres": [
  {"name": "brass", "centre": [0.5, -1, 2], "radius": 0.75, "base_color": [0.9, 0.8, 0.4],
   "metalness": 1, "perceptual_roughness": 0.3},
  {"centre": [-2, 0, 0]}
]})";

TEST(SceneFile, IsRead) {
    const auto scene = parse_scene(two_spheres);
    ASSERT_TRUE(scene) << scene.error().message;
    ASSERT_EQ(scene->spheres.size(), 2u);
    const Sphere& brass = scene->spheres[0];
    EXPECT_EQ(brass.name, "brass");
    EXPECT_EQ(brass.centre, Vec3d(0.5, -1, 2));
    EXPECT_EQ(brass.radius, 0.75);
    EXPECT_EQ(brass.material.base_color, Vec3d(0.9, 0.8, 0.4));
    EXPECT_EQ(brass.material.metalness, 1);
    EXPECT_EQ(brass.material.perceptual_roughness, 0.3);
}

TEST(SceneFile, LeavesWhatItDoesNotSayAsItIs) {
    const auto scene = parse_scene(two_spheres);
    ASSERT_TRUE(scene);
    const Sphere& plain = scene->spheres[1];
    EXPECT_EQ(plain.name, "sphere 1");
    EXPECT_EQ(plain.centre, Vec3d(-2, 0, 0));
    EXPECT_EQ(plain.radius, Sphere{}.radius);
    EXPECT_EQ(plain.material.base_color, Material{}.base_color);
    EXPECT_EQ(plain.material.perceptual_roughness, Material{}.perceptual_roughness);
}

TEST(SceneFile, TakesTheEndsOfItsRanges) {
    for (const char* end : {R"("metalness": 0)", R"("metalness": 1)", R"("radius": 1000)",
                            R"("radius": 1e-3)", R"("base_color": [0, 1, 0])"}) {
        const auto scene =
            parse_scene(std::string(R"({"spheres": [{"centre": [1000, -1000, 0], )") + end + "}]}");
        EXPECT_TRUE(scene) << scene.error().message;
    }
}

struct Mistake {
    const char* text;
    ErrorKind kind;
    const char* says;  ///< part of the message
};

TEST(SceneFile, SaysWhatIsWrongAndWhere) {
    constexpr ErrorKind unusable = ErrorKind::unusable_input,
                        unreadable = ErrorKind::unreadable_input;
    const Mistake mistakes[] = {
        {"", unreadable, "line 1"},
        {"{\"spheres\": [\n{\"centre\": [0, 0 0]}]}", unreadable, "line 2"},
        {"[]", unusable, "{\"spheres\": [...]}"},
        {"{}", unusable, "{\"spheres\": [...]}"},
        {R"({"spheres": {}})", unusable, "{\"spheres\": [...]}"},
        {R"({"spheres": []})", unusable, "0 spheres"},
        {R"({"spheres": [3]})", unusable, "sphere 0 is no object"},
        {R"({"spheres": [{"centre": [0,0,0]}], "camera": 1})", unusable, "no 'camera'"},
        {R"({"spheres": [{}]})", unusable, "sphere 0 has no centre"},
        {R"({"spheres": [{"centre": [0,0,0], "metalnes": 1}]})", unusable,
         "did you mean metalness?"},
        {R"({"spheres": [{"centre": [0,0,0]}, {"centre": [1,0]}]})", unusable,
         "centre of sphere 1 is [1,0]; it must be a list of three numbers from -1000 to 1000"},
        {R"({"spheres": [{"centre": [0,0,1001]}]})", unusable, "from -1000 to 1000"},
        {R"({"spheres": [{"centre": [0,0,"0"]}]})", unusable, "three numbers"},
        {R"({"spheres": [{"centre": [0,0,0], "radius": 0}]})", unusable, "above 0 to 1000"},
        {R"({"spheres": [{"centre": [0,0,0], "radius": -1}]})", unusable, "above 0 to 1000"},
        {R"({"spheres": [{"centre": [0,0,0], "metalness": 1.5}]})", unusable,
         "metalness of sphere 0 is 1.5"},
        {R"({"spheres": [{"centre": [0,0,0], "metalness": true}]})", unusable, "from 0 to 1"},
        {R"({"spheres": [{"centre": [0,0,0], "perceptual_roughness": -0.1}]})", unusable,
         "from 0 to 1"},
        {R"({"spheres": [{"centre": [0,0,0], "base_color": [0,0,2]}]})", unusable, "base_color"},
        {R"({"spheres": [{"centre": [0,0,0], "base_color": 0.5}]})", unusable, "three numbers"},
        {R"({"spheres": [{"centre": [0,0,0], "name": ""}]})", unusable, "a text"},
        {R"({"spheres": [{"centre": [0,0,0], "name": 7}]})", unusable, "a text"},
        {R"({"spheres": [{"centre": [0,0,0], "name": "a"}, {"centre": [1,0,0], "name": "a"}]})",
         unusable, "names must differ"},
        {R"({"spheres": [{"centre": [0,0,0], "radius": 1, "radius": 2}]})", unusable,
         "'radius' stands twice"},
    };
    for (const Mistake& mistake : mistakes) {
        const auto scene = parse_scene(mistake.text);
        ASSERT_FALSE(scene) << mistake.text;
        EXPECT_EQ(scene.error().kind, mistake.kind) << mistake.text;
        EXPECT_NE(scene.error().message.find(mistake.says), std::string::npos)
            << scene.error().message;
    }
}

TEST(SceneFile, EveryBeginningOfAFileIsRefused) {
    for (size_t length = 0; length < two_spheres.size(); ++length)
        EXPECT_FALSE(parse_scene(two_spheres.substr(0, length))) << length;
}

TEST(SceneFile, HoldsAtMostAThousandSpheres) {
    const auto with = [](int count) {
        std::string text = R"({"spheres": [)";
        for (int i = 0; i < count; ++i) text += std::string(i ? "," : "") + R"({"centre":[0,0,0]})";
        return parse_scene(text + "]}");
    };
    EXPECT_TRUE(with(most_spheres));
    EXPECT_FALSE(with(most_spheres + 1));
}

TEST(SceneFile, MessagesNameTheFile) {
    const tests::TemporaryFolder folder;
    tests::write_bytes(folder / "good.json", two_spheres);
    EXPECT_TRUE(read_scene(folder / "good.json"));
    tests::write_bytes(folder / "bad.json", "{}");
    for (const char* name : {"bad.json", "absent.json"}) {
        const auto scene = read_scene(folder / name);
        ASSERT_FALSE(scene);
        EXPECT_NE(scene.error().message.find(name), std::string::npos) << scene.error().message;
    }
    EXPECT_EQ(read_scene(folder / "absent.json").error().kind, ErrorKind::unreadable_input);
}

}  // namespace
}  // namespace splitsum
