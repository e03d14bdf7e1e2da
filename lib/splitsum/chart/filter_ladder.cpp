#include "splitsum/chart/filter_ladder.h"

#include <algorithm>
#include <array>
#include <limits>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

// A line beside the plain one of a method.
struct Variant {
    std::string_view method;
    std::string_view suffix;
    int most_samples;
    void (*change)(FilterPlan& plan);
};

constexpr int no_limit = std::numeric_limits<int>::max();

void use_random_points(FilterPlan& plan) { plan.sequence = PointSequence::random; }
void use_balance_heuristic(FilterPlan& plan) { plan.heuristic = MisHeuristic::balance; }
void keep(FilterPlan&) {}

// Methods that are not named have one line and the whole ladder. `mis` takes 0.2 us a sample, fifty
// times what samples shared by all texels take.
constexpr std::array<Variant, 5> variants = {{
    {"importance", "", no_limit, keep},
    {"importance", " (random points)", 4096, use_random_points},
    {"mis", "", 1024, keep},
    {"mis", " (random points)", 1024, use_random_points},
    {"mis", " (balance heuristic)", 256, use_balance_heuristic},
}};

FilterRung rung_of(const FilterMethod& method, std::string name, std::string effort_name,
                   double effort) {
    FilterRung rung;
    rung.method = method;
    rung.plan.method = method.name;
    rung.name = std::move(name);
    rung.effort_name = std::move(effort_name);
    rung.effort = effort;
    return rung;
}

void add_samples(const FilterMethod& method, const Variant& variant, std::span<const int> samples,
                 std::vector<FilterRung>& ladder) {
    for (const int count : samples) {
        if (count > variant.most_samples) continue;
        ladder.push_back(rung_of(method, cat(method.name, variant.suffix), "samples", count));
        ladder.back().plan.samples = count;
        variant.change(ladder.back().plan);
    }
}

}  // namespace

std::vector<FilterRung> accuracy_ladder(const FilterMethod& method,
                                        std::span<const double> accuracies) {
    std::vector<FilterRung> ladder;
    for (const double accuracy : accuracies) {
        ladder.push_back(rung_of(method, std::string(method.name), "accuracy", accuracy));
        ladder.back().plan.accuracy = accuracy;
    }
    return ladder;
}

std::vector<FilterRung> filter_ladder(LobeKind kind, std::span<const int> samples,
                                      std::span<const double> accuracies) {
    std::vector<FilterRung> ladder;
    for (const FilterMethod& method : filter_methods()) {
        if (kind == LobeKind::ggx ? !method.filters_ggx : !method.filters_cosine) continue;
        if (method.name == "reference" || method.name == "auto") continue;
        if (method.name == "spectral") {
            const auto rungs = accuracy_ladder(method, accuracies);
            ladder.insert(ladder.end(), rungs.begin(), rungs.end());
            continue;
        }
        bool listed = false;
        for (const Variant& variant : variants)
            if (variant.method == method.name) {
                add_samples(method, variant, samples, ladder);
                listed = true;
            }
        if (!listed) add_samples(method, {"", "", no_limit, keep}, samples, ladder);
    }
    return ladder;
}

}  // namespace splitsum
