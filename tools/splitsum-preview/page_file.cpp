#include "page_file.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

std::string with_digits(double value, int digits) {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
}

// "2.3e-4": two digits are as much as anyone compares.
std::string figure(double value) {
    std::ostringstream text;
    text << std::scientific << std::setprecision(1) << value;
    std::string figure = text.str();
    if (const size_t zero = figure.find("e-0"); zero != figure.npos) figure.erase(zero + 2, 1);
    if (const size_t none = figure.find("e+00"); none != figure.npos) figure.erase(none);
    return figure;
}

std::vector<std::string> level_row(int level, double perceptual_roughness,
                                   const ErrorFigures& figures) {
    std::vector<std::string> row = {cat("level ", level), with_digits(perceptual_roughness, 3)};
    for (const double value : {figures.rel_rms, figures.max_rel, figures.bias})
        row.push_back(figures.texels > 0 ? figure(value) : "not measured");
    row.push_back(cat(figures.texels));
    return row;
}

PageTable level_table(const BakedAssets& baked, const PreviewResults& results) {
    PageTable table{"Error of the levels",
                    "Stored texels against exact integration of the panorama. rel_rms: the root of "
                    "the squared error over the squared light, 1e-3 is a tenth of a percent; bias: "
                    "light gained or lost.",
                    {"", "roughness", "rel_rms", "max_rel", "bias", "texels measured"},
                    {}};
    const std::vector<double>& values = baked.facts.perceptual_roughness;
    if (!results.chain.levels.empty())
        for (const LevelCheck& level : results.chain.levels)
            table.rows.push_back(
                level_row(level.level, values[size_t(level.level)], level.figures));
    else if (baked.certificate)
        for (size_t level = 0; level < baked.certificate->levels.size(); ++level)
            table.rows.push_back(
                level_row(int(level), values[level], baked.certificate->levels[level].figures));
    return table;
}

PageTable reading_table(const PreviewResults& results) {
    PageTable table{
        "Between texels and levels",
        "What an engine reads nearly everywhere: linear filters in the two levels around "
        "a roughness, against exact integration there.",
        {"roughness", "rel_rms", "max_rel", "bias"},
        {}};
    for (const ReconstructionError& band : results.chain.between)
        table.rows.push_back({cat(band.range.from, " to ", band.range.to),
                              figure(band.figures.rel_rms), figure(band.figures.max_rel),
                              figure(band.figures.bias)});
    return table;
}

PageTable sphere_table(const PreviewResults& results) {
    PageTable table{
        "Error of the spheres",
        "rel_rms over the pixels of each sphere, without the truth's noise. Baked data: what "
        "texels, "
        "levels, formats and table cost. Approximation: what the split sum itself costs, which no "
        "bake can help. Noise: of the truth.",
        {"", "roughness", "baked data", "approximation", "together", "noise"},
        {}};
    for (const SphereResult& sphere : results.spheres) {
        if (!sphere.errors) continue;
        const SphereErrors& errors = *sphere.errors;
        table.rows.push_back(
            {sphere.sphere.name, with_digits(sphere.sphere.material.perceptual_roughness, 3),
             figure(errors.baked_data.rel_rms), figure(errors.approximation.rel_rms),
             figure(errors.together.rel_rms), figure(errors.approximation.noise)});
    }
    return table;
}

std::string truth_note(const TruthResult& truth) {
    const std::string noise =
        std::isfinite(truth.noise)
            ? cat("The mean relative standard error of a pixel is ",
                  with_digits(100 * truth.noise, 2), " %.")
            : std::string("Where it is black, the time was too short for a first estimate.");
    return cat("The unsplit BRDF, integrated under the panorama itself with ",
               (truth.samples + 500000) / 1000000, " million directions. ", noise);
}

}  // namespace

PageOption::PageOption(CLI::App& app) {
    app.add_option(
           "--html", file,
           "also write a page that shows the light in a browser: turn it, choose materials, "
           "levels and views")
        ->option_text("FILE")
        ->check(not_empty());
}

Page page_of(const BakedAssets& baked, const PreviewResults& results) {
    Page page;
    page.title = baked.facts.source.name.empty() ? "Baked light" : baked.facts.source.name;
    page.light = &baked.light;
    page.notes = results.notes;
    page.no_truth =
        "There is none in this page: splitsum-preview --panorama FILE --truth computes it.";
    if (results.truth) page.truth = PageTruth{nullptr, 0, truth_note(*results.truth)};
    for (PageTable& table :
         std::array{sphere_table(results), level_table(baked, results), reading_table(results)})
        if (!table.rows.empty()) page.tables.push_back(std::move(table));
    return page;
}

}  // namespace splitsum::tools
