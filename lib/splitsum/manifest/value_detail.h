#pragma once

#include <string>
#include <vector>

namespace splitsum {

/// A value of a manifest, whichever notation it was written in: values that are meant to be equal
/// are equal.
struct ManifestValue {
    enum class Kind { flag, number, text, list, table, other };
    Kind kind = Kind::table;
    int line = 1;     ///< where it begins
    std::string key;  ///< of a member of a table
    std::string
        text;  ///< "true", a number that reads back as the same, text; of `other` what it is
    std::vector<ManifestValue> items;  ///< of a list in order, of a table in the order of keys
};

/// A number as options take it: whole numbers in full, others with as many digits as it takes to
/// read them back; `other` what is not finite, or whole and beyond 2^53, where a program that
/// counts in doubles would read another number.
ManifestValue whole_value(int64_t number, int line);
ManifestValue number_value(double number, int line);

/// Text; `other` with control characters or bytes that are not UTF-8, which escapes can make.
ManifestValue text_value(std::string text, int line);

/// The value in words, for a message: "'abc'", "3", "a list".
std::string description_of(const ManifestValue& value);

}  // namespace splitsum
