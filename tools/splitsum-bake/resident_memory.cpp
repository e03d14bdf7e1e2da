#include "resident_memory.h"

#include <unistd.h>

#include <fstream>

namespace splitsum::tools {

int64_t resident_memory() {
    std::ifstream file("/proc/self/statm");
    int64_t all = 0, resident = 0;  // in pages
    if (!(file >> all >> resident)) return 0;
    return resident * sysconf(_SC_PAGESIZE);
}

}  // namespace splitsum::tools
