#include "splitsum/color/config_hash.h"

#include <OpenColorIO/OpenColorIO.h>

#include <set>
#include <sstream>

#include "splitsum/base/content_hash.h"
#include "splitsum/base/file_hash.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace ocio = OCIO_NAMESPACE;
namespace fs = std::filesystem;

void collect_files(const ocio::ConstTransformRcPtr& transform, std::set<std::string>& files) {
    if (!transform) return;
    if (const auto file = ocio::DynamicPtrCast<const ocio::FileTransform>(transform))
        files.insert(file->getSrc());
    if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(transform))
        for (int i = 0; i < group->getNumTransforms(); ++i)
            collect_files(group->getTransform(i), files);
}

// Every file name in the config, as it is written there.
std::set<std::string> files_named_in(const ocio::Config& config) {
    std::set<std::string> files;
    const int spaces =
        config.getNumColorSpaces(ocio::SEARCH_REFERENCE_SPACE_ALL, ocio::COLORSPACE_ALL);
    for (int i = 0; i < spaces; ++i) {
        const auto space = config.getColorSpace(config.getColorSpaceNameByIndex(
            ocio::SEARCH_REFERENCE_SPACE_ALL, ocio::COLORSPACE_ALL, i));
        for (const auto way :
             {ocio::COLORSPACE_DIR_TO_REFERENCE, ocio::COLORSPACE_DIR_FROM_REFERENCE})
            collect_files(space->getTransform(way), files);
    }
    for (int i = 0; i < config.getNumLooks(); ++i) {
        const auto look = config.getLook(config.getLookNameByIndex(i));
        collect_files(look->getTransform(), files);
        collect_files(look->getInverseTransform(), files);
    }
    for (int i = 0; i < config.getNumViewTransforms(); ++i) {
        const auto view = config.getViewTransform(config.getViewTransformNameByIndex(i));
        for (const auto way :
             {ocio::VIEWTRANSFORM_DIR_TO_REFERENCE, ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE})
            collect_files(view->getTransform(way), files);
    }
    for (int i = 0; i < config.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL); ++i) {
        const auto named = config.getNamedTransform(
            config.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i));
        for (const auto way : {ocio::TRANSFORM_DIR_FORWARD, ocio::TRANSFORM_DIR_INVERSE})
            collect_files(named->getTransform(way), files);
    }
    return files;
}

std::string hash_of_named_file(const ocio::Context& context, const std::string& name) {
    try {
        const auto hash = hash_of_file(context.resolveFileLocation(name.c_str()));
        if (hash) return *hash;
    } catch (const ocio::Exception&) {
        // Not where the config looks for it: spaces that need it cannot be used.
    }
    return "missing";
}

std::string hash_of(const ocio::Config& config) {
    std::ostringstream text;
    config.serialize(text);
    const auto context = config.getCurrentContext();
    for (const std::string& name : files_named_in(config))
        text << '\0' << name << '\0' << hash_of_named_file(*context, name);
    for (int i = 0; i < config.getNumEnvironmentVars(); ++i) {
        const char* name = config.getEnvironmentVarNameByIndex(i);
        text << '\0' << name << '\0' << context->getStringVar(name);
    }
    ContentHash hash;
    hash.add(text.str());
    return named_hash(hash.digits());
}

}  // namespace

Result<std::string> ConfigHashes::of(const fs::path& file) {
    if (file.empty()) return std::string("built-in");
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find(file);
    if (known != known_.end()) return known->second;
    try {
        return known_[file] = hash_of(*ocio::Config::CreateFromFile(file.c_str()));
    } catch (const std::exception& thrown) {
        known_.erase(file);
        return Error{ErrorKind::unreadable_input,
                     cat("cannot use the OpenColorIO config ", file.string(), ": ", thrown.what())};
    }
}

}  // namespace splitsum
