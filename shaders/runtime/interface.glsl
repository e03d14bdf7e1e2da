// What differs between Vulkan, desktop GL 4.50 and ES 3.00 where a shader meets the program: Vulkan
// has sets, ES 3.00 knows no numbers for samplers, blocks and what goes from stage to stage, and WGSL
// knows no combined samplers.
#ifdef VULKAN
#define SAMPLER(number) layout(set = 0, binding = number)
#define BLOCK(number) layout(std140, set = 0, binding = number)
#define BETWEEN_STAGES(number) layout(location = number)
#elif defined(GL_ES)
#define SAMPLER(number)
#define BLOCK(number) layout(std140)
#define BETWEEN_STAGES(number)
#else
#define SAMPLER(number) layout(binding = number)
#define BLOCK(number) layout(std140, binding = number)
#define BETWEEN_STAGES(number) layout(location = number)
#endif

#ifdef SPLITSUM_SEPARATE_SAMPLERS
SAMPLER(7) uniform sampler splitsum_filter;
#endif
