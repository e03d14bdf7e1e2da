#include "splitsum/preview/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace splitsum {
namespace {

using Json = nlohmann::json;

BakedLight small_light() {
    BakedLight light;
    light.specular = {Cubemap(2), Cubemap(1)};
    for (Cubemap& level : light.specular) std::ranges::fill(level.texels, Vec3(0.5f, 1, 0.25f));
    light.irradiance = Cubemap(1);
    light.split_sum = blank_table(3, 2, 2);
    return light;
}

Page small_page(const BakedLight& light) {
    Page page;
    page.title = "a panorama";
    page.light = &light;
    page.scene = textbook_scene();
    page.view = "srgb";
    return page;
}

std::string text_of(const Page& page) {
    const auto text = page_text(page);
    EXPECT_TRUE(text);
    return text ? *text : "";
}

// What stands in the only element with that id.
std::string element(const std::string& text, const std::string& id) {
    const std::string head = "id=\"" + id + "\">";
    const size_t from = text.find(head);
    EXPECT_NE(from, text.npos) << id;
    if (from == text.npos) return "";
    EXPECT_EQ(text.find(head, from + 1), text.npos) << id;
    return text.substr(from + head.size(), text.find("</script>", from) - from - head.size());
}

Json facts_of(const std::string& text) {
    return Json::parse(element(text, "facts"), nullptr, false);
}

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Page, HasEveryPlaceFilled) {
    const BakedLight light = small_light();
    const std::string text = text_of(small_page(light));
    EXPECT_EQ(count(text, "{{"), 0u);
    EXPECT_EQ(count(text, "<title>a panorama</title>"), 1u);
    EXPECT_EQ(count(text, "#version 300 es"), 2u);
    EXPECT_EQ(count(text, "#include"), 0u);
    EXPECT_NE(text.find("splitsum_image_based_light"), text.npos);
}

TEST(Page, LoadsNothing) {
    const BakedLight light = small_light();
    const std::string text = text_of(small_page(light));
    for (const char* const loading : {"src=", "http:", "https:", "@import", "url(", "import "})
        EXPECT_EQ(count(text, loading), 0u) << loading;
}

TEST(Page, FactsAreThoseOfTheLight) {
    BakedLight light = small_light();
    light.curve = {RoughnessCurve::Kind::list, {0.1, 0.7}};
    Page page = small_page(light);
    page.viewpoint = {300, 200, 12.5, -4};
    page.exposure_stops = -3.25;
    page.background = Background::black;
    page.tables = {{"figures", "a note", {"", "x"}, {{"row", "1"}}}};
    page.no_truth = "none was asked for";
    const std::string text = text_of(page);
    const Json facts = facts_of(text);
    EXPECT_EQ(facts["specular"]["sizes"], Json({2, 1}));
    EXPECT_EQ(facts["specular"]["curve"], "list");
    EXPECT_EQ(facts["specular"]["perceptualRoughness"], Json({0.1, 0.7}));
    EXPECT_EQ(facts["table"]["width"], 3);
    EXPECT_EQ(facts["spheres"].size(), 14u);
    EXPECT_EQ(facts["start"], Json({{"width", 300},
                                    {"height", 200},
                                    {"yaw", 12.5},
                                    {"pitch", -4},
                                    {"background", "none"},
                                    {"exposure", -3.25},
                                    {"view", "srgb"}}));
    EXPECT_EQ(facts["tables"][0]["rows"][0][1], "1");
    EXPECT_EQ(facts["noTruth"], "none was asked for");
    EXPECT_FALSE(facts.contains("truth"));
    // Six faces of 4 texels and of 1, 4 bytes each, in base 64.
    EXPECT_EQ(element(text, "texels-specular").size(), 160u);
}

TEST(Page, NamesCannotBecomeMarkup) {
    const BakedLight light = small_light();
    const std::string name = "</script><!-- <script> \"&' {{script}} \xff \xe2\x80\xa8";
    Page page = small_page(light);
    page.title = name;
    page.scene_note = page.no_truth = name;
    page.scene.spheres.resize(1);
    page.scene.spheres[0].name = name;
    page.tables = {{name, name, {name}, {{name}}}};
    page.notes = {name};
    const std::string text = text_of(page);
    const std::string plain = text_of(small_page(light));
    for (const char* const markup : {"</script", "<script", "<!--", "-->"})
        EXPECT_EQ(count(text, markup), count(plain, markup)) << markup;
    const Json facts = facts_of(text);
    ASSERT_TRUE(facts.is_object());
    // Bytes that are no UTF-8 become the replacement character, and nothing else changes.
    std::string read = name;
    read.replace(read.find('\xff'), 1, "\xef\xbf\xbd");
    EXPECT_EQ(facts["title"], read);
    EXPECT_EQ(facts["tables"][0]["rows"][0][0], read);
}

TEST(Page, CarriesTheTruth) {
    const BakedLight light = small_light();
    Image picture(2, 1);
    picture.rgb = {1, 1, 1, 0, 0, 0};
    Page page = small_page(light);
    page.truth = PageTruth{&picture, 0.25, "noisy"};
    const std::string text = text_of(page);
    EXPECT_EQ(facts_of(text)["truth"]["width"], 2);
    EXPECT_EQ(facts_of(text)["truth"]["leastLuminance"], 0.25);
    EXPECT_EQ(element(text, "texels-truth").size(), 16u);
}

TEST(Page, HasAViewBesideTheBuiltInOnes) {
    const BakedLight light = small_light();
    Page page = small_page(light);
    const auto view = View::find("filmic", {});
    ASSERT_TRUE(view);
    page.view = "sRGB/Mine";
    page.more_view = &*view;
    const Json facts = facts_of(text_of(page));
    EXPECT_EQ(facts["views"].size(), views().size() + 1);
    EXPECT_EQ(facts["views"].back()["name"], "sRGB/Mine");
    EXPECT_TRUE(facts["views"].back().contains("lut"));
}

}  // namespace
}  // namespace splitsum
