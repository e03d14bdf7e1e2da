#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace splitsum {

/// What kind of thing went wrong: one kind for each exit code of the tools, so that a caller can
/// branch on it without reading the message.
enum class ErrorKind {
    bad_argument,       ///< asked for something impossible
    unreadable_input,   ///< an input is absent, truncated or corrupt
    unwritable_output,  ///< an output could not be written
    unusable_input,     ///< an input was read but cannot be used (not 2:1, NaN texels, ...)
    interrupted,        ///< the caller asked to stop
    internal,           ///< our own fault
};

/// As it is spelt above, for reports that programs read.
constexpr std::string_view name_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::bad_argument: return "bad_argument";
        case ErrorKind::unreadable_input: return "unreadable_input";
        case ErrorKind::unwritable_output: return "unwritable_output";
        case ErrorKind::unusable_input: return "unusable_input";
        case ErrorKind::interrupted: return "interrupted";
        case ErrorKind::internal: return "internal";
    }
    return "";
}

/// Why an operation failed: a kind the caller can branch on, and a sentence a user can act on that
/// says what was asked, what was found and what would work.
struct Error {
    ErrorKind kind;
    std::string message;
};

/// A value, or the Error that prevented it. Becomes std::expected once we may require C++23.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return state_.index() == 0; }
    T& operator*() { return std::get<0>(state_); }
    const T& operator*() const { return std::get<0>(state_); }
    T* operator->() { return &std::get<0>(state_); }
    const T* operator->() const { return &std::get<0>(state_); }
    const Error& error() const { return std::get<1>(state_); }

private:
    std::variant<T, Error> state_;
};

/// Success without a value.
struct Done {};

/// Success, or the Error that prevented it.
using Status = Result<Done>;

/// The successful Status: `return ok;`.
inline constexpr Done ok{};

}  // namespace splitsum
