"""The wheel of the Python module: CMake builds what it holds."""

import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"^  VERSION ([\d.]+)$", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        build = Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                        "-DBRDFPLOT_BUILD_PYTHON=ON", "-DBRDFPLOT_BUILD_TESTS=OFF", "-DBRDFPLOT_BUILD_BENCH=OFF",
                        f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "brdfplot-python"], check=True)
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        built = next((build / "python" / "brdfplot").glob("_core*.so"))
        target.write_bytes(built.read_bytes())


setup(version=VERSION, packages=["brdfplot"], package_dir={"brdfplot": "python/brdfplot"},
      package_data={"brdfplot": ["__init__.pyi", "py.typed"]},
      ext_modules=[Extension("brdfplot._core", [])], cmdclass={"build_ext": CMakeBuild})
