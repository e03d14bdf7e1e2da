#include "splitsum/report/certificate.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/content_hash.h"
#include "splitsum/base/text.h"
#include "splitsum/report/metadata_detail.h"

namespace splitsum {
namespace {

constexpr const char* hash_key = "splitsum.certificate.hash";

std::string key_of(const char* figure) { return cat("splitsum.certificate.", figure); }

// The figures of a level that are numbers, by the names of report.json.
struct Figure {
    const char* name;
    double ErrorFigures::*member;
};
constexpr Figure figures[] = {{"rel_rms", &ErrorFigures::rel_rms},
                              {"max_rel", &ErrorFigures::max_rel},
                              {"max_abs", &ErrorFigures::max_abs},
                              {"bias", &ErrorFigures::bias}};

// Single precision is more than figures have, and half as long to read.
std::string short_text(double figure) { return number_text(float(figure)); }

template <class Print>
std::string line_of(const Certificate& certificate, const Print& print) {
    return join(certificate.levels, " ", print);
}

std::string rgb_text(const Vec3d& rgb) {
    return cat(short_text(rgb.x), " ", short_text(rgb.y), " ", short_text(rgb.z));
}

bool was_measured(const Certificate& certificate) {
    return std::ranges::any_of(certificate.levels,
                               [](const auto& level) { return level.figures.texels > 0; });
}

// The numbers under a key, `a_level` for each level.
std::vector<double> read(MetadataReader& reader, const char* name, size_t count,
                         std::string& problem) {
    std::vector<double> values = reader.numbers(key_of(name));
    if (values.size() != count && problem.empty() && reader.problem().empty())
        problem = cat("the file says ", values.size(), " numbers for '", key_of(name), "' where ",
                      count, " belong");
    values.resize(count);
    return values;
}

bool agree(double a, double b, double relative, double absolute) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= absolute + relative * std::max(std::abs(a), std::abs(b));
}

bool agree(const Vec3d& a, const Vec3d& b) {
    const double tolerance = 1e-6 * std::max({a.x, a.y, a.z, b.x, b.y, b.z});
    return agree(a.x, b.x, 0, tolerance) && agree(a.y, b.y, 0, tolerance) &&
           agree(a.z, b.z, 0, tolerance);
}

}  // namespace

Certificate certificate_from(std::span<const LevelAccount> accounts,
                             std::span<const EncodeCounts> counts,
                             std::span<const LevelCheck> checks,
                             const Vec3d& source_mean_radiance) {
    Certificate certificate;
    certificate.source_mean_radiance = source_mean_radiance;
    for (size_t i = 0; i < checks.size(); ++i)
        certificate.levels.push_back({accounts[i].error_bound, accounts[i].clamped_negative,
                                      counts[i].saturated, checks[i].mean_radiance,
                                      checks[i].figures});
    return certificate;
}

std::string certificate_hash(const TextureAsset& texture) {
    ContentHash hash;
    for (const auto& level : texture.levels) hash.add(level);
    for (const auto& [key, value] : texture.metadata) {
        if (!key.starts_with("splitsum.") || key == hash_key) continue;
        for (const std::string& text : {key, value})
            hash.add(std::string_view(text.c_str(), text.size() + 1));
    }
    return named_hash(hash.digits());
}

void certify(TextureAsset& texture, const Certificate& certificate) {
    auto& metadata = texture.metadata;
    metadata[key_of("source_mean_radiance")] = rgb_text(certificate.source_mean_radiance);
    metadata[key_of("mean_radiance")] =
        line_of(certificate, [](const auto& level) { return rgb_text(level.mean_radiance); });
    metadata[key_of("error_bound")] =
        line_of(certificate, [](const auto& level) { return short_text(level.error_bound); });
    metadata[key_of("clamped_negative")] =
        line_of(certificate, [](const auto& level) { return level.clamped_negative; });
    metadata[key_of("saturated")] =
        line_of(certificate, [](const auto& level) { return level.saturated; });
    metadata[key_of("probes")] =
        line_of(certificate, [](const auto& level) { return level.figures.texels; });
    if (was_measured(certificate))
        for (const Figure& figure : figures)
            metadata[key_of(figure.name)] = line_of(certificate, [&](const auto& level) {
                return short_text(level.figures.*figure.member);
            });
    metadata[hash_key] = certificate_hash(texture);
}

Result<std::optional<Certificate>> certificate_of(const Metadata& metadata) {
    if (!metadata.contains(hash_key)) return std::optional<Certificate>();
    MetadataReader reader(metadata);
    std::string problem;
    Certificate certificate;
    certificate.hash = reader.text(hash_key);
    certificate.levels.resize(reader.numbers(key_of("probes")).size());
    const size_t count = certificate.levels.size();
    const auto each = [&](const char* name, const auto& store) {
        const std::vector<double> values = read(reader, name, count, problem);
        for (size_t i = 0; i < count; ++i) store(certificate.levels[i], values[i]);
    };
    const auto source = read(reader, "source_mean_radiance", 3, problem);
    certificate.source_mean_radiance = {source[0], source[1], source[2]};
    const auto means = read(reader, "mean_radiance", 3 * count, problem);
    for (size_t i = 0; i < count; ++i)
        certificate.levels[i].mean_radiance = {means[3 * i], means[3 * i + 1], means[3 * i + 2]};
    each("error_bound", [](auto& level, double value) { level.error_bound = value; });
    each("clamped_negative",
         [](auto& level, double value) { level.clamped_negative = int64_t(value); });
    each("saturated", [](auto& level, double value) { level.saturated = int64_t(value); });
    each("probes", [](auto& level, double value) { level.figures.texels = int64_t(value); });
    if (was_measured(certificate))
        for (const Figure& figure : figures)
            each(figure.name,
                 [&](auto& level, double value) { level.figures.*figure.member = value; });
    if (problem.empty()) problem = reader.problem();
    if (!problem.empty()) return Error{ErrorKind::unusable_input, problem};
    return std::optional(certificate);
}

std::vector<std::string> contradictions(const Certificate& certificate, const TextureAsset& texture,
                                        std::span<const LevelCheck> found) {
    std::vector<std::string> sentences;
    if (certificate.hash != certificate_hash(texture))
        sentences.push_back(
            cat("the texels or keys are not those that were certified: their hash is ",
                certificate_hash(texture), ", certified is ", certificate.hash));
    if (certificate.levels.size() != found.size()) {
        sentences.push_back(cat("the file has ", found.size(), " levels, certified are ",
                                certificate.levels.size()));
        return sentences;
    }
    for (size_t i = 0; i < found.size(); ++i) {
        const CertifiedLevel& level = certificate.levels[i];
        if (!agree(level.mean_radiance, found[i].mean_radiance))
            sentences.push_back(cat("level ", i, ": the mean radiance is ",
                                    rgb_text(found[i].mean_radiance), ", certified is ",
                                    rgb_text(level.mean_radiance)));
        if (found[i].figures.texels == 0 || found[i].figures.texels != level.figures.texels)
            continue;
        for (const auto& [name, member] : figures)
            if (!agree(level.figures.*member, found[i].figures.*member, 1e-3, 1e-6))
                sentences.push_back(cat("level ", i, ": ", name, " is ",
                                        short_text(found[i].figures.*member), ", certified is ",
                                        short_text(level.figures.*member)));
    }
    return sentences;
}

}  // namespace splitsum
