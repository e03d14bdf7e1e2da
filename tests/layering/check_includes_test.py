#!/usr/bin/env python3
"""Plants violations in a copy of lib and sees each of them caught, and nothing else."""

import pathlib
import shutil
import sys
import tempfile
import unittest

import check_includes

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class PlantedViolation(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.source = pathlib.Path(self.folder.name)
        shutil.copytree(SOURCE / "lib", self.source / "lib")
        self.before = set(check_includes.violations(self.source))

    def tearDown(self):
        self.folder.cleanup()

    def plant(self, name, text):
        path = self.source / "lib" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def edit_table(self, old, new):
        path = self.source / "lib/CMakeLists.txt"
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))

    def assert_found(self, *messages):
        found = set(check_includes.violations(self.source)) - self.before
        self.assertEqual(found, set(messages))

    def test_a_module_that_is_not_listed(self):
        self.plant("splitsum/brdf/planted.h",
                   '#pragma once\n\n#include "splitsum/filter/methods.h"\n')
        self.assert_found("lib/splitsum/brdf/planted.h:3: brdf may not use filter")

    def test_a_listed_module_is_fine(self):
        self.plant("splitsum/filter/planted.h",
                   '#pragma once\n#include <vector>\n#include "splitsum/brdf/lobe.h"\n'
                   "#include <hwy/highway.h>\n")
        self.assert_found()

    def test_a_module_that_does_not_exist(self):
        self.plant("splitsum/brdf/planted.cpp", '#include "splitsum/nowhere/x.h"\n')
        self.assert_found("lib/splitsum/brdf/planted.cpp:1: there is no module nowhere")

    def test_a_folder_outside_the_table(self):
        self.plant("splitsum/unlisted/planted.cpp", "int x;\n")
        self.assert_found("lib/splitsum/unlisted/planted.cpp: unlisted is not in the module table "
                          "of lib/CMakeLists.txt")

    def test_third_party_headers_outside_their_module(self):
        headers = {
            "glm/glm.hpp": "glm::glm",
            "OpenImageIO/imageio.h": "OpenImageIO::OpenImageIO",
            "OpenEXR/ImfRgba.h": "OpenEXR::OpenEXR",
            "ImfRgba.h": "OpenEXR::OpenEXR",
            "Imath/half.h": "Imath::Imath",
            "half.h": "Imath::Imath",
            "OpenColorIO/OpenColorIO.h": "OpenColorIO::OpenColorIO",
            "hwy/highway.h": "hwy::hwy",
            "oneapi/tbb/parallel_for.h": "TBB::tbb",
            "tbb/parallel_for.h": "TBB::tbb",
            "zstd.h": "zstd",
            "xxhash.h": "xxhash",
            "nlohmann/json.hpp": "nlohmann_json::nlohmann_json",
            "CLI/CLI.hpp": "CLI11::CLI11",
        }
        for header, target in headers.items():
            with self.subTest(header=header):
                self.plant("splitsum/brdf/planted.cpp", f"  #  include <{header}>\n")
                self.assert_found("lib/splitsum/brdf/planted.cpp:1: "
                                  f"brdf may not use {target} ({header})")

    def test_half_is_for_texture_and_container_only(self):
        self.plant("splitsum/texture/planted.cpp", "#include <Imath/half.h>\n")
        self.plant("splitsum/container/planted.cpp", "#include <Imath/ImathBox.h>\n")
        self.assert_found()

    def test_a_header_without_pragma_once(self):
        self.plant("splitsum/brdf/planted.h", "// A comment.\nint x();\n#pragma once\n")
        self.assert_found("lib/splitsum/brdf/planted.h:1: a header starts with #pragma once")

    def test_a_use_of_a_later_line(self):
        self.edit_table("splitsum_module(math ", "splitsum_module(math USES report ")
        self.assert_found("lib/CMakeLists.txt: math uses report, which is not on an earlier line")

    def test_a_cycle(self):
        self.edit_table("splitsum_module(base ", "splitsum_module(base USES math ")
        self.assert_found("lib/CMakeLists.txt: base uses math, which is not on an earlier line")

    def test_a_module_that_uses_itself(self):
        self.edit_table("splitsum_module(base ", "splitsum_module(base USES base ")
        self.assert_found("lib/CMakeLists.txt: base uses base, which is not on an earlier line")

    def test_a_table_that_cannot_be_read(self):
        self.plant("CMakeLists.txt", "# nothing\n")
        self.assertIn("lib/CMakeLists.txt: no splitsum_module lines found",
                      set(check_includes.violations(self.source)))


if __name__ == "__main__":
    sys.exit(unittest.main())
