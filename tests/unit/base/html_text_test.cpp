#include "splitsum/base/html_text.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

TEST(HtmlText, NothingEndsATagOrAnAttribute) {
    EXPECT_EQ(html_text("</script>\"&amp;'"), "&lt;/script&gt;&quot;&amp;amp;'");
    EXPECT_EQ(html_text("Zürich, 8° \n"), "Zürich, 8° \n");
    EXPECT_EQ(html_text(""), "");
}

}  // namespace
}  // namespace splitsum
