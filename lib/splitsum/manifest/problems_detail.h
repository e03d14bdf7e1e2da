#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// What is wrong with manifests, collected so that one attempt shows all of it.
class Problems {
public:
    /// How many a message lists; the rest is counted.
    static constexpr size_t most_listed = 10;

    void add(const std::filesystem::path& file, int line, const std::string& text);
    /// Of a file as a whole that cannot be read.
    void add_unreadable(const std::filesystem::path& file, int line, const std::string& text);

    bool empty() const { return problems_.empty(); }

    /// A line for each problem, by lines within each file: unreadable_input if a file could not be
    /// read, else bad_argument. Needs a problem.
    Error error() const;

private:
    struct Problem {
        size_t file;
        int line;
        std::string text;
    };
    void add(const std::filesystem::path& file, int line, const std::string& text, ErrorKind kind);

    ErrorKind kind_ = ErrorKind::bad_argument;
    std::vector<std::filesystem::path> files_;  // in the order of their first problems
    std::vector<Problem> problems_;
};

/// "file:line: ", the beginning of a message; without a line if that is 0.
std::string place_prefix(const std::filesystem::path& file, int line);

/// The text in quotes, fit for a message: short, and without control characters.
std::string in_quotes(std::string_view text);

}  // namespace splitsum
