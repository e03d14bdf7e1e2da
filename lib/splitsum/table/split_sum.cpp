#include "splitsum/table/split_sum.h"
