#include "splitsum/library/baked_facts.h"

#include <algorithm>

namespace splitsum {

BakedFacts facts_from(const BakeReport& report) {
    BakedFacts facts;
    for (const WrittenFile& file : report.files)
        facts.files.push_back({file.name, file.bytes, file.hash});
    if (report.probes == 0) return facts;
    double worst = report.irradiance.figures.rel_rms;
    for (const LevelCheck& check : report.specular)
        if (check.perceptual_roughness > 0) worst = std::max(worst, check.figures.rel_rms);
    facts.worst_rel_rms = worst;
    return facts;
}

BakedFacts facts_from(const BakedReport& report) { return {report.files, report.worst_rel_rms}; }

int64_t bytes_of(const BakedFacts& facts) {
    int64_t bytes = 0;
    for (const BakedReport::File& file : facts.files) bytes += file.bytes;
    return bytes;
}

}  // namespace splitsum
