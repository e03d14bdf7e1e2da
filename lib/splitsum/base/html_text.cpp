#include "splitsum/base/html_text.h"

namespace splitsum {

std::string html_text(std::string_view text) {
    std::string result;
    for (const char letter : text) switch (letter) {
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '&': result += "&amp;"; break;
            case '"': result += "&quot;"; break;
            default: result += letter;
        }
    return result;
}

}  // namespace splitsum
