#include "library_results.h"

#include <utility>

#include "library_json.h"
#include "library_text.h"

namespace splitsum::tools {

LibraryResults::LibraryResults(const ResultStyle& style, std::span<const LibraryJob> jobs,
                               const std::filesystem::path& folder,
                               std::function<void(const std::string&)> print)
    : style_(style), jobs_(jobs), folder_(folder), print_(std::move(print)) {}

void LibraryResults::begun(std::span<const size_t> jobs) {
    order_.assign(jobs.begin(), jobs.end());
}

void LibraryResults::finished(const LibraryItem& item) {
    if (style_.json) return;
    waiting_.emplace(item.job, item);
    for (; next_ < order_.size(); ++next_) {
        const auto next = waiting_.find(order_[next_]);
        if (next == waiting_.end()) return;
        print_text(next->second);
        waiting_.erase(next);
    }
}

void LibraryResults::end(const LibrarySummary& summary) {
    if (style_.json) return print_(library_json(summary, jobs_, folder_, style_.dry_run));
    for (; next_ < summary.items.size(); ++next_) print_text(summary.items[next_]);
    if (summary.table) print_(table_text(*summary.table, style_.dry_run));
    if (summary.items.size() > 1) print_(counts_text(summary, jobs_, folder_, style_.dry_run));
}

void LibraryResults::print_text(const LibraryItem& item) {
    const std::string text = item_text(item, folder_ / jobs_[item.job].panorama.name,
                                       order_.size() > most_in_full, style_.dry_run);
    if (!text.empty()) print_(text);
}

}  // namespace splitsum::tools
