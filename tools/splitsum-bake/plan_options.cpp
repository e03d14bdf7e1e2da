#include "plan_options.h"

#include "light/cubemap_tool.h"

namespace splitsum::tools {

PlanOptions::PlanOptions(CLI::App& app)
    : reading(app),
      specular(app),
      irradiance(app, "irradiance-"),
      orientation(app),
      filter(app, methods_for(LobeKind::ggx)),
      encoding(app, EncodingOptions::Content::cubemap),
      verify(app) {
    app.add_flag("--no-picture", no_picture, "do not write the picture contact.png");
}

Result<BakePlan> PlanOptions::plan() const {
    const auto chain = specular.plan();
    if (!chain) return chain.error();
    const BakePlan plan{*chain,           irradiance.plan,   filter.plan,
                        orientation.plan, encoding.format(), encoding.container(),
                        verify.probes(),  !no_picture};
    if (const Status valid = validate(plan); !valid) return valid.error();
    return plan;
}

}  // namespace splitsum::tools
