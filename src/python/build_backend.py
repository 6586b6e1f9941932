# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions that pip calls (PEP 517). They build the module by CMake, without PCL."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

root = pathlib.Path(__file__).parents[2]


def version():
    """The version of the CMake project, "X.Y.Z"; scripts/check compares its other places."""
    return re.search(r"VERSION (\d+\.\d+\.\d+)", (root / "CMakeLists.txt").read_text())[1]


def metadata():
    """The contents of the file METADATA, from pyproject.toml."""
    try:
        import tomllib
    except ImportError:
        import tomli as tomllib
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}",
             *(f"Requires-Dist: {dependency}" for dependency in project["dependencies"]),
             *(f"Classifier: {classifier}" for classifier in project["classifiers"]),
             "Description-Content-Type: text/markdown", "",
             (root / project["readme"]).read_text(encoding="utf-8")]
    return "\n".join(lines)


def wheel_tag():
    """The part of a wheel's name that says for which Python and which system it is."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def dist_info():
    """The name of the folder in a wheel that has the files about the wheel itself."""
    return f"pcl_ops-{version()}.dist-info"


def dist_info_files():
    """Contents of the files in the folder dist_info() by their names, without RECORD."""
    wheel = ("Wheel-Version: 1.0\nGenerator: pcl_ops\nRoot-Is-Purelib: false\n"
             f"Tag: {wheel_tag()}\n")
    return {"METADATA": metadata().encode(), "WHEEL": wheel.encode(),
            "LICENSE": (root / "LICENSE").read_bytes()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes the metadata alone; returns the name of their folder.

    Without this function pip would build a whole wheel for its metadata, and then another.
    """
    folder = pathlib.Path(metadata_directory, dist_info())
    folder.mkdir()
    for name, content in dist_info_files().items():
        (folder / name).write_bytes(content)
    return folder.name


def write_wheel(package, wheel_directory):
    """Writes a wheel with the files of a folder, the built package; returns the wheel's name."""
    info = dist_info()
    files = {f"pcl_ops/{file.name}": file.read_bytes()
             for file in sorted(package.iterdir()) if file.is_file()}
    files.update({f"{info}/{name}": content for name, content in dist_info_files().items()})
    record = ""  # a line for each file: path, hash, bytes
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        record += f"{path},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    name = f"pcl_ops-{version()}-{wheel_tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            archive.writestr(path, content)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds the package by CMake and writes its wheel; returns the wheel's name."""
    with tempfile.TemporaryDirectory() as folder:
        build, prefix = pathlib.Path(folder, "build"), pathlib.Path(folder, "prefix")
        settings = {
            "CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON",
            "CMAKE_UNITY_BUILD_BATCH_SIZE": "16", "PCL_OPS_BUILD_SURFACE": "OFF",
            "BUILD_TESTING": "OFF", "PCL_OPS_WITHOUT_PCL": "ON", "PCL_OPS_BUILD_APPS": "OFF",
            "PCL_OPS_PYTHON": sys.executable, "PCL_OPS_PYTHON_INSTALL_DIR": ".",
            "CMAKE_INSTALL_PREFIX": prefix}
        for command in (
            ["-S", root, "-B", build, *(f"-D{name}={value}" for name, value in settings.items())],
            ["--build", build, "--parallel", str(os.cpu_count()),
             "--target", "pcl_ops_python_package"],
            ["--install", build, "--strip", "--component", "python"],
        ):
            subprocess.run(["cmake", *command], check=True)
        return write_wheel(prefix / "pcl_ops", wheel_directory)


def build_sdist(sdist_directory, config_settings=None):
    """Writes an archive of the committed files; returns the archive's name."""
    name = f"pcl_ops-{version()}"
    with tempfile.TemporaryDirectory() as folder:
        package_information = pathlib.Path(folder, "PKG-INFO")
        package_information.write_text(metadata(), encoding="utf-8")
        subprocess.run(["git", "archive", f"--prefix={name}/", f"--add-file={package_information}",
                        f"--output={pathlib.Path(sdist_directory, name).absolute()}.tar.gz",
                        "HEAD"], cwd=root, check=True)
    return f"{name}.tar.gz"
