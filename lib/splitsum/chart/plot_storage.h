#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// One panorama and one band of roughness: error against bytes, a line for each format.
struct StoragePanel {
    struct Point {
        int face_size;
        int64_t bytes;
        double error;
    };
    struct Line {
        std::string format;
        std::vector<Point> points;
    };
    std::string title;
    std::vector<Line> lines;
};

std::vector<StoragePanel> storage_panels(const Chart& chart);

/// The points of all panels as gnuplot's data blocks.
void add_storage_data(std::ostream& out, const std::vector<StoragePanel>& panels);

/// The commands that draw a panel, at the margins that are set.
void draw_storage_panel(std::ostream& out, size_t index, const StoragePanel& panel);

/// The lines of all formats with their names, and nothing else.
void draw_storage_legend(std::ostream& out, const StoragePanel& panel);

}  // namespace splitsum
