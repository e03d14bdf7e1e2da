#pragma once

#include <span>
#include <vector>

#include "splitsum/library/bake_library.h"

namespace splitsum::tools {

/// Hands everything on to several observers, which must outlive it.
class ObserverList final : public LibraryObserver {
public:
    explicit ObserverList(std::vector<LibraryObserver*> observers)
        : observers_(std::move(observers)) {}

    void add(LibraryObserver& observer) { observers_.push_back(&observer); }

    void begun(std::span<const size_t> jobs) override {
        for (LibraryObserver* observer : observers_) observer->begun(jobs);
    }
    void planned(std::span<const size_t> jobs, std::span<const int64_t> pixels) override {
        for (LibraryObserver* observer : observers_) observer->planned(jobs, pixels);
    }
    void started(size_t job) override {
        for (LibraryObserver* observer : observers_) observer->started(job);
    }
    void finished(const LibraryItem& item) override {
        for (LibraryObserver* observer : observers_) observer->finished(item);
    }

private:
    std::vector<LibraryObserver*> observers_;
};

}  // namespace splitsum::tools
