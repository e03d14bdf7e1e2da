#include "splitsum/preview/scene_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "splitsum/base/edit_distance.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using Json = nlohmann::json;

constexpr double largest_length = 1e3;

Error unusable(const std::string& what) { return {ErrorKind::unusable_input, what}; }

// What JSON leaves to its reader: the same key twice in an object.
struct Parsed {
    Json json;
    std::optional<std::string> repeated_key;
};

Parsed parse(const std::string& text) {
    Parsed parsed;
    std::vector<std::set<std::string>> open;  // the keys of the objects around
    const auto watch = [&](int, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::object_start) open.emplace_back();
        if (event == Json::parse_event_t::object_end) open.pop_back();
        if (event == Json::parse_event_t::key && !open.back().insert(value).second)
            parsed.repeated_key = value;
        return true;
    };
    parsed.json = Json::parse(text, watch);
    return parsed;
}

Error no_json(const std::string& text, const Json::parse_error& error) {
    const auto end = text.begin() + std::ptrdiff_t(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    return {ErrorKind::unreadable_input, cat("line ", line, " is no JSON")};
}

Status check_keys(const Json& object, const std::string& place,
                  const std::vector<std::string>& known) {
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::find(known, key) == known.end())
            return unusable(cat(place, " has no '", key, "'", names_instead(key, known)));
    }
    return ok;
}

/// The numbers that a key may have.
struct Range {
    double low;
    double high;
    bool low_excluded = false;

    bool holds(double value) const {
        return value >= low && value <= high && !(low_excluded && value == low);
    }
    std::string text() const { return cat(low_excluded ? "above " : "from ", low, " to ", high); }
};

constexpr Range unit{0, 1};
constexpr Range position{-largest_length, largest_length};
constexpr Range length_of_radius{0, largest_length, true};

/// A sphere as the file has it. Keeps the first problem; what follows one does not count.
class SphereReader {
public:
    SphereReader(const Json& object, std::string place)
        : object_(object), place_(std::move(place)) {}

    void read(const char* key, const Range& range, double& value) {
        if (problem_ || !object_.contains(key)) return;
        const auto number = number_in(object_[key], range);
        if (!number) return complain(key, cat("a number ", range.text()));
        value = *number;
    }

    void read(const char* key, const Range& range, Vec3d& value) {
        if (problem_ || !object_.contains(key)) return;
        const Json& list = object_[key];
        const auto needed = cat("a list of three numbers ", range.text());
        if (!list.is_array() || list.size() != 3) return complain(key, needed);
        for (int i = 0; i < 3; ++i) {
            const auto number = number_in(list[size_t(i)], range);
            if (!number) return complain(key, needed);
            value[i] = *number;
        }
    }

    void read(const char* key, std::string& value) {
        if (problem_ || !object_.contains(key)) return;
        if (!object_[key].is_string() || object_[key].get<std::string>().empty())
            return complain(key, "a text");
        value = object_[key];
    }

    Status status() const {
        if (problem_) return *problem_;
        return ok;
    }

private:
    static std::optional<double> number_in(const Json& json, const Range& range) {
        if (!json.is_number() || !range.holds(json.get<double>())) return std::nullopt;
        return json.get<double>();
    }

    void complain(const char* key, const std::string& needed) {
        problem_ = unusable(
            cat(key, " of ", place_, " is ", object_[key].dump(), "; it must be ", needed));
    }

    const Json& object_;
    std::string place_;
    std::optional<Error> problem_;
};

Result<Sphere> sphere_of(const Json& object, size_t index) {
    const std::string place = cat("sphere ", index);
    if (!object.is_object())
        return unusable(cat(place, " is no object: {\"centre\": [0, 0, 0], ...}"));
    if (Status known = check_keys(
            object, place,
            {"name", "centre", "radius", "base_color", "metalness", "perceptual_roughness"});
        !known)
        return known.error();
    if (!object.contains("centre"))
        return unusable(cat(place, " has no centre; it needs one, such as [0, 0, 0]"));
    Sphere sphere;
    sphere.name = place;
    SphereReader reader(object, place);
    reader.read("name", sphere.name);
    reader.read("centre", position, sphere.centre);
    reader.read("radius", length_of_radius, sphere.radius);
    reader.read("base_color", unit, sphere.material.base_color);
    reader.read("metalness", unit, sphere.material.metalness);
    reader.read("perceptual_roughness", unit, sphere.material.perceptual_roughness);
    if (const Status read = reader.status(); !read) return read.error();
    return sphere;
}

Result<Scene> scene_of(const Json& json) {
    if (!json.is_object() || !json.contains("spheres") || !json["spheres"].is_array())
        return unusable("it must be an object with a list of spheres: {\"spheres\": [...]}");
    if (Status known = check_keys(json, "the scene", {"spheres"}); !known) return known.error();
    const Json& list = json["spheres"];
    if (list.empty() || list.size() > size_t(most_spheres))
        return unusable(cat("it has ", list.size(), " spheres; a scene has 1 to ", most_spheres));
    Scene scene;
    std::set<std::string> names;
    for (size_t i = 0; i < list.size(); ++i) {
        const auto sphere = sphere_of(list[i], i);
        if (!sphere) return sphere.error();
        if (!names.insert(sphere->name).second)
            return unusable(cat("sphere ", i, " is called '", sphere->name,
                                "', as one before it; names must differ"));
        scene.spheres.push_back(*sphere);
    }
    return scene;
}

}  // namespace

Result<Scene> parse_scene(const std::string& text) {
    try {
        const Parsed parsed = parse(text);
        if (parsed.repeated_key)
            return unusable(cat("the key '", *parsed.repeated_key, "' stands twice in one object"));
        return scene_of(parsed.json);
    } catch (const Json::parse_error& error) {
        return no_json(text, error);
    }
}

Result<Scene> read_scene(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) return Error{ErrorKind::unreadable_input, cat("cannot read ", path.string())};
    auto scene = parse_scene(text);
    if (!scene) return Error{scene.error().kind, cat(path.string(), ": ", scene.error().message)};
    return scene;
}

}  // namespace splitsum
