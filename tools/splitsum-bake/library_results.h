#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "splitsum/library/bake_library.h"

namespace splitsum::tools {

/// How the results of a run are printed.
struct ResultStyle {
    bool json = false;     ///< one object at the end instead of text as results come
    bool dry_run = false;  ///< nothing was done: say what would be
};

/// Prints what became of each panorama, in the order of the list however they come: a panorama waits
/// for those before it.
class LibraryResults final : public LibraryObserver {
public:
    /// `print` gets whole lines; all that is handed in must outlive the object.
    LibraryResults(const ResultStyle& style, std::span<const LibraryJob> jobs,
                   const std::filesystem::path& folder,
                   std::function<void(const std::string&)> print);

    void begun(std::span<const size_t> jobs) override;
    void finished(const LibraryItem& item) override;

    /// Prints what still waits, the table of the library, and of several panoramas the counts.
    void end(const LibrarySummary& summary);

private:
    void print_text(const LibraryItem& item);

    const ResultStyle style_;
    const std::span<const LibraryJob> jobs_;
    const std::filesystem::path& folder_;
    const std::function<void(const std::string&)> print_;
    std::vector<size_t> order_;              // of the shard's jobs
    size_t next_ = 0;                        // in order_
    std::map<size_t, LibraryItem> waiting_;  // those that came early
};

}  // namespace splitsum::tools
