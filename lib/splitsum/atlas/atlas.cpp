#include "splitsum/atlas/atlas.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/text.h"

namespace splitsum {

Status validate(const AtlasPlan& plan) {
    const auto in = [](int value, int lowest, int highest) {
        return value >= lowest && value <= highest;
    };
    if (plan.methods.empty())
        return Error{ErrorKind::bad_argument, "an atlas needs a method; leave them out for all"};
    if (!in(plan.sky_rows, 8, 1024) || !in(plan.face_size, 2, 128) || !in(plan.many_rows, 8, 8192))
        return Error{ErrorKind::bad_argument,
                     cat("an atlas of skies of ", plan.sky_rows, " rows (8 to 1024), faces of ",
                         plan.face_size, " texels (2 to 128) and many texels in ", plan.many_rows,
                         " rows (8 to 8192); 64, 8 and 2048 work")};
    return validate(FilterPlan{.samples = plan.samples, .accuracy = plan.accuracy});
}

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::meets: return "meets";
        case Verdict::near: return "near";
        case Verdict::fails: return "fails";
        case Verdict::refuses: return "refuses";
    }
    return "fails";
}

// Written so that NaN fails.
Verdict verdict_of(const ErrorFigures& figures, double accuracy) {
    if (!(figures.rel_rms <= std::max(near_limit, accuracy))) return Verdict::fails;
    if (!(std::abs(figures.bias) <= std::max(near_limit, accuracy))) return Verdict::fails;
    return figures.rel_rms <= accuracy ? Verdict::meets : Verdict::near;
}

Verdict worst_of(const AtlasRow& row) {
    for (const Verdict verdict : {Verdict::fails, Verdict::near, Verdict::meets})
        if (std::ranges::find(row.cells, verdict, &AtlasCell::verdict) != row.cells.end())
            return verdict;
    return Verdict::refuses;
}

}  // namespace splitsum
