#include "splitsum/manifest/settings_detail.h"

#include <algorithm>
#include <optional>

#include "splitsum/base/edit_distance.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using Kind = ManifestValue::Kind;

const char* expectation_of(OptionType type) {
    switch (type) {
        case OptionType::flag: return "true or false, without quotes";
        case OptionType::number: return "a number, without quotes";
        case OptionType::text: return "text in quotes";
        case OptionType::number_or_text: return "a number, or text in quotes";
        case OptionType::number_list: return "a list of numbers, or text in quotes";
        case OptionType::path: return "the name of a file or folder, in quotes";
    }
    return "";
}

bool is_list_of_numbers(const ManifestValue& value) {
    return value.kind == Kind::list && !value.items.empty() &&
           std::ranges::all_of(value.items,
                               [](const ManifestValue& item) { return item.kind == Kind::number; });
}

// The value as it is typed on the command line, if it is of the option's type.
std::optional<std::string> typed_value(const ManifestValue& value, OptionType type,
                                       const std::filesystem::path& folder) {
    const bool text = value.kind == Kind::text && !value.text.empty();
    const bool number = value.kind == Kind::number;
    switch (type) {
        case OptionType::flag:
            if (value.kind == Kind::flag) return value.text;
            break;
        case OptionType::number:
            if (number) return value.text;
            break;
        case OptionType::text:
            if (text) return value.text;
            break;
        case OptionType::number_or_text:
            if (text || number) return value.text;
            break;
        case OptionType::number_list:
            if (text) return value.text;
            if (is_list_of_numbers(value))
                return join(value.items, ",", [](const auto& item) { return item.text; });
            break;
        case OptionType::path:
            if (text) return (folder / value.text).lexically_normal().string();
            break;
    }
    return std::nullopt;
}

// The flag that a key such as "no-verify" turns off, if there is one.
const KnownOption* negated_flag(const std::string& key, std::span<const KnownOption> options) {
    if (!key.starts_with("no-")) return nullptr;
    const auto flag = std::ranges::find(options, key.substr(3), &KnownOption::name);
    return flag != options.end() && flag->type == OptionType::flag ? &*flag : nullptr;
}

}  // namespace

SettingReader::SettingReader(std::span<const KnownOption> options,
                             std::span<const std::string> other_keys,
                             const std::filesystem::path& file, Problems& problems)
    : options_(options), other_keys_(other_keys), file_(file), problems_(problems) {}

void SettingReader::read(const ManifestValue& member, Table table,
                         std::vector<Setting>& settings) const {
    const KnownOption* option = find(member.key);
    if (!option) return problems_.add(file_, member.line, unknown_key(member.key, table));
    if (const std::string wrong = wrong_place(*option, table); !wrong.empty())
        return problems_.add(file_, member.line, wrong);
    const auto value = typed_value(member, option->type, file_.parent_path());
    if (!value)
        return problems_.add(file_, member.line,
                             cat(member.key, ": found ", description_of(member), "; it takes ",
                                 expectation_of(option->type)));
    settings.push_back({member.key, *value, option->type == OptionType::flag, file_, member.line});
}

bool SettingReader::is_for_run(const Setting& setting) const {
    return find(setting.option)->place == OptionPlace::run;
}

const KnownOption* SettingReader::find(const std::string& name) const {
    const auto option = std::ranges::find(options_, name, &KnownOption::name);
    return option == options_.end() ? nullptr : &*option;
}

std::string SettingReader::unknown_key(const std::string& key, Table table) const {
    if (const KnownOption* flag = negated_flag(key, options_))
        return cat("there is no setting ", in_quotes(key), "; write ", flag->name, " = false");
    const bool is_panorama = table == Table::panorama;
    std::vector<std::string> names;
    if (is_panorama) names.assign(other_keys_.begin(), other_keys_.end());
    for (const KnownOption& option : options_)
        if (option.place == OptionPlace::panorama ||
            (option.place == OptionPlace::run && !is_panorama))
            names.push_back(option.name);
    return no_such_key(key, names);
}

std::string SettingReader::wrong_place(const KnownOption& option, Table table) const {
    if (option.place == OptionPlace::command_line)
        return cat(option.name, " cannot be set in a manifest; give --", option.name,
                   " on the command line");
    if (option.place == OptionPlace::run && table == Table::panorama)
        return cat(option.name,
                   " holds for the whole run, not for one panorama; move it to the "
                   "defaults");
    return "";
}

std::string no_such_key(const std::string& key, std::span<const std::string> names) {
    const auto nearest = nearest_name(key, names);
    if (nearest) return cat("there is no ", in_quotes(key), " here; did you mean ", *nearest, "?");
    return cat("there is no ", in_quotes(key), " here; there are: ", join(names, ", "));
}

}  // namespace splitsum
