#include "splitsum/chart/chart.h"

#include <algorithm>
#include <deque>

#include "splitsum/bake/light.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/chart/bake_panel.h"
#include "splitsum/chart/level_panels.h"
#include "splitsum/chart/method_notes.h"
#include "splitsum/chart/table_panels.h"

namespace splitsum {
namespace {

struct LoadedPanorama {
    std::filesystem::path path;
    Light light;
    NamedLight named;

    LoadedPanorama(const std::filesystem::path& file, Light loaded, std::string name)
        : path(file),
          light(std::move(loaded)),
          named{std::move(name), FilterSource(light.environment, light.tables)} {}
    LoadedPanorama(const LoadedPanorama&) = delete;
};

using Panoramas = std::deque<LoadedPanorama>;  // never moves its elements: panels point to them

// Two files of one name are told apart by a number.
std::string name_of(const std::filesystem::path& path, const Panoramas& before) {
    const std::string stem = path.stem().string();
    const auto count = std::ranges::count_if(
        before, [&](const LoadedPanorama& other) { return other.path.stem() == path.stem(); });
    return count == 0 ? stem : cat(stem, " (", count + 1, ")");
}

Status load(const ChartJob& job, Panoramas& panoramas, Progress& progress) {
    for (const auto& path : job.panoramas)  // all of them before any work
        if (const auto size = panorama_size(path, job.reading); !size) return size.error();
    LightUse use;
    use.keep_texels = true;
    for (const auto& path : job.panoramas) {
        auto light = load_light(path, job.reading, use, progress);
        if (!light) return light.error();
        panoramas.emplace_back(path, std::move(*light), name_of(path, panoramas));
    }
    return ok;
}

std::vector<Panel> panels_of(const LoadedPanorama& panorama, const ChartJob& job) {
    std::vector<Panel> panels = specular_panels(panorama.named, job.plan);
    panels.push_back(diffuse_panel(panorama.named, job.plan));
    panels.push_back(bake_panel(panorama.path, job.reading, panorama.light, job.plan));
    panels.back().facts.panorama = panorama.named.name;
    return panels;
}

Status measure_panels(const std::vector<Panel>& panels, const ChartJob& job, Chart& chart,
                      Progress& progress) {
    for (const Panel& panel : panels) {
        const std::string& light = panel.facts.panorama;
        progress.begin(cat(light, light.empty() ? "" : ": ", panel.facts.title),
                       int(panel.contestants.size()));
        MeasuredPanel measured;
        const Status done = measure_panel(panel, job.plan.timing, measured, progress);
        mark_front(measured);
        if (!measured.rows.empty()) chart.panels.push_back(std::move(measured));
        if (!done) return done;
    }
    return ok;
}

Status measure_all(const Panoramas& panoramas, const ChartJob& job, Chart& chart,
                   Progress& progress) {
    for (const LoadedPanorama& panorama : panoramas)
        if (const Status done = measure_panels(panels_of(panorama, job), job, chart, progress);
            !done)
            return done;
    const Status tables = measure_panels({table_panel(job.plan), table_between_panel(job.plan)},
                                         job, chart, progress);
    if (!tables) return tables;
    for (const LoadedPanorama& panorama : panoramas) {
        progress.begin(cat(panorama.named.name, ": what engines read"), storage_steps(job.plan));
        const Status done = measure_storage(panorama.named, job.plan, chart.storage, progress);
        if (!done) return done;
    }
    return ok;
}

}  // namespace

Result<Chart> measure_chart(const ChartJob& job, Progress& progress) {
    Panoramas panoramas;
    if (const Status loaded = load(job, panoramas, progress); !loaded) return loaded.error();
    Chart chart;
    chart.threads = ThreadLimit::in_force();
    chart.probes = job.plan.probes;
    chart.quick = job.quick;
    for (const LoadedPanorama& panorama : panoramas)
        chart.sources.push_back({panorama.named.name, panorama.light.source.name,
                                 panorama.light.source.hash, panorama.light.width,
                                 panorama.light.height});
    const Status done = measure_all(panoramas, job, chart, progress);
    chart.complete = bool(done);
    const bool kept = !done && done.error().kind == ErrorKind::interrupted && !chart.panels.empty();
    if (!done && !kept) return done.error();
    chart.notes = method_notes(chart.panels);
    return chart;
}

}  // namespace splitsum
