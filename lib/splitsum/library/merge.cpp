#include "splitsum/library/merge.h"

#include "splitsum/base/content_hash.h"
#include "splitsum/base/file_hash.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/library/freshness.h"
#include "splitsum/report/certificate_check.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// What was found of one job.
struct Found {
    std::string problem;  // "" if there is none
    bool is_damaged = false;
    BakedFacts facts;
};

// What the certificate of a cubemap says against it, "" if nothing.
std::string broken_certificate_of(const fs::path& path) {
    if (path.extension() != ".ktx2") return "";
    const auto texture = read_texture(path);
    return texture ? join(broken_certificate(*texture), "; ") : texture.error().message;
}

// What the report and the certificates say against the folder's files, "" if nothing.
std::string broken_promise(const fs::path& folder, const BakedFacts& facts) {
    for (const BakedReport::File& file : facts.files) {
        std::string broken = broken_certificate_of(folder / file.name);
        const auto hash = hash_of_file(folder / file.name);
        if (broken.empty() && !hash) broken = hash.error().message;
        if (broken.empty() && named_hash(*hash) != file.hash)
            broken = "the bytes are not those that the report names";
        if (!broken.empty()) return cat(file.name, ": ", broken);
    }
    return "";
}

Found look_at(const LibraryJob& job, const fs::path& folder, ConfigHashes& configs) {
    const auto fresh = check_freshness(job.panorama.file, job.reading, job.plan, folder, configs);
    if (!fresh) return {fresh.error().message, false, {}};
    if (!fresh->up_to_date || !fresh->baked) return {fresh->why, false, {}};
    Found found{"", false, facts_from(*fresh->baked)};
    found.problem = broken_promise(folder, found.facts);
    found.is_damaged = !found.problem.empty();
    return found;
}

void count(const Found& found, size_t job, MergeCheck& check) {
    if (found.is_damaged) ++check.damaged;
    if (!found.problem.empty())
        return check.problems.push_back({job, found.is_damaged, found.problem});
    ++check.complete;
    check.bytes += bytes_of(found.facts);
    const auto& error = found.facts.worst_rel_rms;
    if (!error || (check.worst_rel_rms && *check.worst_rel_rms >= *error)) return;
    check.worst_rel_rms = error;
    check.worst = job;
}

}  // namespace

Result<MergeCheck> check_merged(std::span<const LibraryJob> jobs, const LibraryTable& table,
                                const fs::path& folder, Progress& progress) {
    if (const Status valid = validate(jobs, table); !valid) return valid.error();
    ConfigHashes configs;
    std::vector<Found> found(jobs.size());
    progress.begin("check", int(jobs.size()));
    parallel_rows(int(jobs.size()), [&](int i) {
        if (progress.cancelled()) return;
        const LibraryJob& job = jobs[size_t(i)];
        found[size_t(i)] = look_at(job, folder / job.panorama.name, configs);
        progress.advance(1);
    });
    MergeCheck check;
    for (size_t i = 0; i < jobs.size(); ++i) count(found[i], i, check);
    const TableResult here = find_library_table(table, folder);
    if (here.outcome != Outcome::up_to_date) check.table_problem = here.why;
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
    return check;
}

}  // namespace splitsum
