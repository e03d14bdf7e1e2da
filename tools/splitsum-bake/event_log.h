#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "splitsum/base/result.h"
#include "splitsum/library/bake_library.h"

namespace splitsum::tools {

/// What happens in a run, for dashboards: a JSON object a line, each written in one piece, so that
/// several runs may share a file. tools/README.md lists the events and their members.
class EventLog final : public LibraryObserver {
public:
    /// Appends to `file`; "-" is stderr. `jobs` must outlive the object. Fails with
    /// unwritable_output.
    static Result<std::unique_ptr<EventLog>> open(const std::string& file,
                                                  std::span<const LibraryJob> jobs,
                                                  const LibraryRun& run);
    ~EventLog() override;
    EventLog(const EventLog&) = delete;
    EventLog& operator=(const EventLog&) = delete;

    void begun(std::span<const size_t> jobs) override;
    void started(size_t job) override;
    void finished(const LibraryItem& item) override;

    /// The last event. Fails with unwritable_output if any of them could not be written.
    Status end(const LibrarySummary& summary, int exit_code);

private:
    EventLog(int descriptor, std::span<const LibraryJob> jobs, const LibraryRun& run);
    template <class Json>
    void write(const Json& event);

    const int descriptor_;
    const std::span<const LibraryJob> jobs_;
    const LibraryRun& run_;
    int failure_ = 0;  // errno of the first event that was lost
};

/// A moment as ISO 8601 in UTC, to the millisecond: "2026-03-01T22:15:04.250Z".
std::string utc_text(std::chrono::system_clock::time_point moment);

}  // namespace splitsum::tools
