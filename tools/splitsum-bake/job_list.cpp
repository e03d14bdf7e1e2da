#include "job_list.h"

#include <algorithm>
#include <set>

#include "manifest_options.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;

void add_source(const fs::path& source, JobList& list) {
    if (std::ranges::find(list.sources, source) == list.sources.end())
        list.sources.push_back(source);
}

// Of an input that is a folder: it and every folder in it that is searched, as a new panorama changes
// the folder it is in. Links are not followed, but for the folders that panoramas were found in.
void add_folders(const fs::path& input, std::span<const ListedPanorama> panoramas,
                 const fs::path& output, JobList& list) {
    std::error_code failure;
    if (!fs::is_directory(input, failure)) return;
    std::set<fs::path> folders = {input};
    fs::recursive_directory_iterator entry(input, fs::directory_options::skip_permission_denied,
                                           failure);
    for (const fs::recursive_directory_iterator end; !failure && entry != end;
         entry.increment(failure)) {
        std::error_code ignored;
        if (!entry->is_directory(ignored)) continue;
        if (entry->path().filename().string().starts_with('.') ||
            fs::equivalent(entry->path(), output, ignored))
            entry.disable_recursion_pending();
        else
            folders.insert(entry->path());
    }
    for (const ListedPanorama& panorama : panoramas)
        if (panorama.file.string().starts_with((input / "").string()))
            folders.insert(panorama.file.parent_path());
    folders.insert(list.sources.begin(), list.sources.end());
    list.sources.assign(folders.begin(), folders.end());
}

void add_job(LibraryJob job, JobList& list) {
    if (!job.reading.ocio_config.empty()) add_source(job.reading.ocio_config, list);
    list.jobs.push_back(std::move(job));
}

Result<JobList> list_inputs(const BakeOptions& options) {
    const SourceOptions& source = options.source;
    const auto plan = options.asset.plan();
    if (!plan) return plan.error();
    const std::vector<fs::path> inputs(source.inputs.begin(), source.inputs.end());
    const auto panoramas =
        list_panoramas(inputs, {source.include, source.exclude, options.output.path()});
    if (!panoramas) return panoramas.error();
    JobList list;
    for (const fs::path& input : inputs)
        add_folders(input, *panoramas, options.output.path(), list);
    for (const ListedPanorama& panorama : *panoramas)
        add_job({panorama, options.asset.reading.plan(), *plan}, list);
    return list;
}

// The panoramas of one entry, which may name a folder of them.
Result<std::vector<ListedPanorama>> list_entry(const ManifestPanorama& entry,
                                               const fs::path& output) {
    auto panoramas = list_panoramas({entry.file}, {entry.only, entry.except, output});
    if (!panoramas)
        return Error{panoramas.error().kind, cat(place_of(entry), ": ", panoramas.error().message)};
    std::error_code failure;
    const bool is_folder = fs::is_directory(entry.file, failure);
    for (ListedPanorama& panorama : *panoramas)
        if (entry.name)
            panorama.name = is_folder ? cat(*entry.name, "/", panorama.name) : *entry.name;
    return panoramas;
}

Result<JobList> list_manifest(const Manifest& manifest, const CLI::App& app,
                              const BakeOptions& options) {
    const auto plans = plans_of_manifest(manifest.panoramas, app);
    if (!plans) return plans.error();
    JobList list;
    list.sources = manifest.files;
    for (size_t i = 0; i < manifest.panoramas.size(); ++i) {
        const ManifestPanorama& entry = manifest.panoramas[i];
        const auto panoramas = list_entry(entry, options.output.path());
        if (!panoramas) return panoramas.error();
        add_folders(entry.file, *panoramas, options.output.path(), list);
        for (const ListedPanorama& panorama : *panoramas)
            add_job({panorama, (*plans)[i].reading, (*plans)[i].plan}, list);
    }
    return list;
}

Error missing_output(const CLI::App& app) {
    return {ErrorKind::bad_argument,
            cat("--output is missing: -o DIR names the folder of the results; see ", app.get_name(),
                " --help")};
}

}  // namespace

Result<JobList> list_jobs(CLI::App& app, const BakeOptions& options) {
    const SourceOptions& source = options.source;
    if (source.manifest.empty()) {
        if (source.inputs.empty())
            return Error{
                ErrorKind::bad_argument,
                cat("PANORAMA is missing: name panoramas, folders of them, or a --manifest; "
                    "see ",
                    app.get_name(), " --help")};
        if (options.output.path().empty()) return missing_output(app);
        return list_inputs(options);
    }
    if (!source.inputs.empty())
        return Error{ErrorKind::bad_argument,
                     cat("the panoramas are those of ", source.manifest, ", and '",
                         source.inputs.front(), "' was named too; name it in the manifest")};
    const auto manifest = read_manifest(source.manifest, options_of_manifests(app));
    if (!manifest) return manifest.error();
    if (const Status applied = apply_run_settings(app, manifest->run); !applied)
        return applied.error();
    if (options.output.path().empty()) return missing_output(app);
    return list_manifest(*manifest, app, options);
}

}  // namespace splitsum::tools
