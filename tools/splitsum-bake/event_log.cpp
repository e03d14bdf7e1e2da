#include "event_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <iomanip>
#include <nlohmann/json.hpp>

#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum::tools {
namespace {

using Json = nlohmann::ordered_json;

Json event_named(const char* name) {
    return {{"event", name}, {"time", utc_text(std::chrono::system_clock::now())}};
}

}  // namespace

Result<std::unique_ptr<EventLog>> EventLog::open(const std::string& file,
                                                 std::span<const LibraryJob> jobs,
                                                 const LibraryRun& run) {
    const int descriptor =
        file == "-" ? dup(STDERR_FILENO)
                    : ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return Error{ErrorKind::unwritable_output,
                     cat("cannot write events to ", file, ": ", std::strerror(errno))};
    return std::unique_ptr<EventLog>(new EventLog(descriptor, jobs, run));
}

EventLog::EventLog(int descriptor, std::span<const LibraryJob> jobs, const LibraryRun& run)
    : descriptor_(descriptor), jobs_(jobs), run_(run) {}

EventLog::~EventLog() { close(descriptor_); }

template <class Json>
void EventLog::write(const Json& event) {
    const std::string line = event.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    const ssize_t written = ::write(descriptor_, line.data(), line.size());
    if (failure_ == 0 && written != ssize_t(line.size())) failure_ = written < 0 ? errno : ENOSPC;
}

void EventLog::begun(std::span<const size_t> jobs) {
    Json event = event_named("run_started");
    event["version"] = version;
    event["folder"] = run_.folder.string();
    event["panoramas"] = jobs.size();
    event["shard"] = cat(run_.shard.index, "/", run_.shard.count);
    event["threads"] = run_.threads;
    write(event);
}

void EventLog::started(size_t job) {
    Json event = event_named("panorama_started");
    event["name"] = jobs_[job].panorama.name;
    event["file"] = jobs_[job].panorama.file.string();
    write(event);
}

void EventLog::finished(const LibraryItem& item) {
    Json event = event_named("panorama_finished");
    event["name"] = jobs_[item.job].panorama.name;
    event["file"] = jobs_[item.job].panorama.file.string();
    event["outcome"] = name_of(item.outcome);
    event["seconds"] = item.seconds;
    if (!item.why.empty()) event["why"] = item.why;
    if (item.facts) {
        event["bytes"] = bytes_of(*item.facts);
        if (item.facts->worst_rel_rms) event["worst_rel_rms"] = *item.facts->worst_rel_rms;
    }
    if (item.error)
        event["error"] = {{"kind", name_of(item.error->kind)}, {"message", item.error->message}};
    write(event);
}

Status EventLog::end(const LibrarySummary& summary, int exit_code) {
    Json event = event_named("run_finished");
    for (const Outcome outcome : {Outcome::baked, Outcome::from_cache, Outcome::up_to_date,
                                  Outcome::failed, Outcome::not_begun})
        event[std::string(name_of(outcome))] =
            std::ranges::count(summary.items, outcome, &LibraryItem::outcome);
    event["seconds"] = summary.seconds;
    event["exit_code"] = exit_code;
    write(event);
    if (failure_ == 0) return ok;
    return Error{ErrorKind::unwritable_output,
                 cat("not all events could be written: ", std::strerror(failure_))};
}

std::string utc_text(std::chrono::system_clock::time_point moment) {
    using namespace std::chrono;
    const auto whole = floor<seconds>(moment);
    const std::time_t time = system_clock::to_time_t(whole);
    std::tm parts{};
    gmtime_r(&time, &parts);
    char text[32];
    const size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
    return cat(std::string(text, length), ".", std::setw(3), std::setfill('0'),
               duration_cast<milliseconds>(moment - whole).count(), "Z");
}

}  // namespace splitsum::tools
