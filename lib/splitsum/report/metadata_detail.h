#pragma once

#include <array>
#include <charconv>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/plan/table_plan.h"

// Numbers and words in the metadata of textures.

namespace splitsum {

using Metadata = std::map<std::string, std::string>;

/// The shortest text that reads back to the same number.
template <class Number>
std::string number_text(Number value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

/// Reads values from the metadata; remembers the first that could not be read.
class MetadataReader {
public:
    explicit MetadataReader(const Metadata& metadata) : metadata_(metadata) {}

    std::string text(const std::string& key) {
        const auto found = metadata_.find(key);
        if (found != metadata_.end()) return found->second;
        if (problem_.empty()) problem_ = cat("the file does not say '", key, "'");
        return {};
    }

    template <class Number>
    Number number(const std::string& key) {
        return parsed<Number>(key, text(key));
    }

    bool flag(const std::string& key) { return text(key) == "true"; }

    bool has(const std::string& key) const { return metadata_.contains(key); }

    /// The value that `rows` name so.
    template <class Value>
    Value named(const std::string& key, std::span<const NamedValue<Value>> rows) {
        const std::string name = text(key);
        if (const auto value = value_named(rows, name)) return *value;
        if (problem_.empty())
            problem_ = cat("the file says '", name, "' for '", key, "'; known are ",
                           join(rows, ", ", [](const auto& row) { return row.name; }));
        return rows.front().value;
    }

    std::vector<double> numbers(const std::string& key) {
        std::vector<double> values;
        std::istringstream words(text(key));
        for (std::string word; words >> word;) values.push_back(parsed<double>(key, word));
        return values;
    }

    const std::string& problem() const { return problem_; }

private:
    template <class Number>
    Number parsed(const std::string& key, const std::string& word) {
        Number value{};
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool whole = result.ec == std::errc() && result.ptr == word.data() + word.size();
        if (!whole && problem_.empty())
            problem_ = cat("the file says '", word, "' for '", key, "', which is not a number");
        return value;
    }

    const Metadata& metadata_;
    std::string problem_;
};

}  // namespace splitsum
