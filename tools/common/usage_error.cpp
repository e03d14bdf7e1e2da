#include "common/usage_error.h"

#include <vector>

#include "splitsum/base/edit_distance.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// Every option as it is typed, with its dashes.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::string unknown_option(const CLI::App& app, const std::string& argument) {
    const std::string typed = argument.substr(0, argument.find('='));
    const std::vector<std::string> names = option_names(app);
    const auto nearest = nearest_name(typed, names);
    return cat("there is no option ", typed, nearest ? "; did you mean " + *nearest + "?" : "");
}

std::string unexpected_argument(const CLI::App& app, const std::string& argument) {
    if (argument.size() > 1 && argument.front() == '-') return unknown_option(app, argument);
    return cat("the argument '", argument, "' was not expected");
}

// CLI11's own words for it name types and minima.
std::string wrong_count(const CLI::App& app, const CLI::ArgumentMismatch& error) {
    const std::string name =
        std::string(error.what()).substr(0, std::string(error.what()).find(':'));
    const CLI::Option* option = app.get_option_no_throw(name);
    const size_t count = option ? option->count() : 0;
    if (count > 1) return cat(name, " was given ", count, " times; once is enough");
    return cat(name, " needs a value");
}

std::string problem_with_arguments(const CLI::App& app, const CLI::ParseError& error) {
    // A misspelt option also leaves what it stood for missing: name the cause, not the effect.
    const std::vector<std::string> unexpected = app.remaining();
    if (!unexpected.empty()) return unexpected_argument(app, unexpected.front());
    if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        return wrong_count(app, *mismatch);
    return error.what();
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
    const std::string problem = problem_with_arguments(app, error);
    return cat(problem, problem.back() == '?' ? " See " : "; see ", app.get_name(), " --help");
}

}  // namespace splitsum::tools
