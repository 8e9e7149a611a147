"""What people install: the source distribution, both wheels, and each of them in an environment of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from collections.abc import Callable
from email import message_from_bytes
from hashlib import sha256
from importlib import metadata
from pathlib import Path, PurePosixPath

import pytest

import chasles

from .sampling import WHOLE

pytest.importorskip("fcntl", reason="the environments are laid out as on Unix")
ROOT = Path(__file__).resolve().parents[1]
DOWNLOADS = "CHASLES_TEST_DOWNLOADS"
EPOCH = "1700000000"
PURE = {"CC": "false", "CHASLES_REQUIRE_C": "0"}
COMPILED = {"CHASLES_REQUIRE_C": "1"} | ({} if WHOLE else {"SKBUILD_CMAKE_DEFINE": "chasles_has_x86-64-v3=OFF"})
"""For instructions that every processor has; .ci/run installs what is compiled for all."""
NAME = f"chasles-{chasles.__version__}"
ONE_GO = (
    'chasles decide 3.18 && chasles solve 3.7 && python -c "import chasles.kernels; print(chasles.kernels.backend)"'
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs the checkout"),
]


def succeed(*command: str | Path, cwd: Path, **environment: str) -> str:
    """What the command prints, in an environment that does not know what tests are told."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith("CHASLES_")}
    done = subprocess.run(command, cwd=cwd, env={**kept, **environment}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{done.args}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def can_compile() -> bool:
    script = ROOT / "cmake" / "can_compile.sh"
    command = ("sh", script, os.environ.get("CC", "cc"), sys.executable)
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


needs_c = pytest.mark.skipif(not can_compile(), reason="no C compiler or no Python.h on this machine")


@pytest.fixture(scope="session")
def once(made_once: Callable[[str, Callable[[Path], object]], Path]) -> Callable[[str, Callable[[Path], None]], Path]:
    """The only file in the folder of a name, made there by the first test process that asks for it."""

    def make(name: str, maker: Callable[[Path], None]) -> Path:
        def fill(folder: Path) -> None:
            folder.mkdir()
            maker(folder)

        (made,) = made_once(f"package-{name}", fill).iterdir()
        return made

    return make


def build(source: Path, out: Path, **environment: str) -> None:
    """Put the wheel that pip builds from a folder or an archive into `out`, with the tools of this environment."""
    options = ("--no-build-isolation", "--no-deps", "--quiet", "--wheel-dir", out)
    succeed(sys.executable, "-m", "pip", "wheel", *options, source, cwd=out, SOURCE_DATE_EPOCH=EPOCH, **environment)


def build_sdist(source: Path, out: Path) -> None:
    """Put the source distribution into `out`."""
    code = "import sys; from scikit_build_core.build import build_sdist as build; build(sys.argv[1])"
    succeed(sys.executable, "-c", code, out, cwd=source, SOURCE_DATE_EPOCH=EPOCH)


@pytest.fixture(scope="session")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A fresh copy of the checkout, without what is made in it."""
    made = shutil.ignore_patterns(".*", "__pycache__")

    def ignored(folder: str, names: list[str]) -> set[str]:
        return made(folder, names) | ({"build", "dist", "report"} if Path(folder) == ROOT else set())

    return shutil.copytree(ROOT, tmp_path_factory.mktemp("tree") / "source", ignore=ignored)


@pytest.fixture(scope="session")
def sdist(once, tree: Path) -> Path:
    """The source distribution of the checkout."""
    return once("sdist", lambda out: build_sdist(tree, out))


@pytest.fixture(scope="session")
def pure_wheel(once, sdist: Path) -> Path:
    """The wheel that is built from the source distribution where there is no compiler."""
    return once("pure", lambda out: build(sdist, out, **PURE))


@pytest.fixture(scope="session")
def compiled_wheel(once, sdist: Path, hasty_compiler: str) -> Path:
    """The wheel that is built from the source distribution where there is a compiler."""
    return once("compiled", lambda out: build(sdist, out, **COMPILED, CC=hasty_compiler))


class Environment:
    """A new virtual environment that has what a wheel requires, and nothing else, from the one that runs the tests."""

    def __init__(self, folder: Path, wheel: Path, *more: str) -> None:
        venv.create(folder, with_pip=False, symlinks=True)
        self.folder = folder
        self.python = folder / "bin" / "python"
        (self.packages,) = folder.glob("lib/python*/site-packages")
        for distribution in required(wheel, *more):
            for top in {PurePosixPath(file).parts[0] for file in distribution.files or ()} - {"..", "__pycache__"}:
                (self.packages / top).symlink_to(Path(str(distribution.locate_file(top))))

    def install(self, *words: str | Path, **environment: str) -> None:
        """Install with the pip of this environment, which finds its build tools here and downloads nothing."""
        pip = (sys.executable, "-m", "pip", "--python", self.python, "install", "--no-index", "--no-compile", "--quiet")
        succeed(*pip, *words, cwd=self.folder, **environment)

    def run(self, line: str) -> str:
        """What a line of shell prints in this environment, far from the checkout."""
        path = os.pathsep.join((str(self.folder / "bin"), os.environ["PATH"]))
        home = {"HOME": str(self.folder), "XDG_CACHE_HOME": str(self.folder / "cache")}
        plain = {"PATH": path, "PYTHONPATH": "", "NO_COLOR": "1", "COLUMNS": "100"}
        return succeed("sh", "-c", line, cwd=self.folder, **home, **plain)


def required(wheel: Path, *more: str) -> list[metadata.Distribution]:
    """What a wheel says it requires without extras, and what that requires; more names with themselves."""
    from packaging.requirements import Requirement

    with zipfile.ZipFile(wheel) as archive:
        said = message_from_bytes(archive.read(f"{NAME}.dist-info/METADATA")).get_all("Requires-Dist", [])
    found: dict[str, metadata.Distribution] = {}
    waiting = [*said, *more]
    while waiting:
        requirement = Requirement(waiting.pop())
        wanted = requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        if wanted and requirement.name.lower() not in found:
            found[requirement.name.lower()] = metadata.distribution(requirement.name)
            waiting += metadata.requires(requirement.name) or ()
    return list(found.values())


@pytest.fixture
def environment(tmp_path: Path, pure_wheel: Path) -> Environment:
    return Environment(tmp_path / "environment", pure_wheel)


@pytest.fixture
def builder(tmp_path: Path, pure_wheel: Path) -> Environment:
    return Environment(tmp_path / "environment", pure_wheel, "scikit-build-core", "cmake", "ninja")


def contents(wheel: Path) -> dict[str, str]:
    """The hash of each file in a wheel, but for what lists the others and what says for which machines it is."""
    with zipfile.ZipFile(wheel) as archive:
        names = [name for name in archive.namelist() if not name.endswith(("/RECORD", "/WHEEL"))]
        return {name: sha256(archive.read(name)).hexdigest() for name in names}


def sources() -> set[str]:
    """What a wheel has to hold: sources, book, what is emitted but for the C self-test, and what was measured."""
    places = {"src/chasles": "chasles"} | {
        name: f"chasles/{name}" for name in ("derivations", "rotations", "generated")
    }
    measured = {"chasles/evidence/kernels.json", "chasles/evidence/errors.json"}
    return measured | {
        f"{to}/{path.relative_to(ROOT / folder).as_posix()}"
        for folder, to in places.items()
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and not path.is_relative_to(ROOT / "generated/c/test")
    }


def test_the_source_distribution_holds_what_is_built_and_tested(sdist: Path) -> None:
    with tarfile.open(sdist) as archive:
        names = {name.removeprefix(f"{NAME}/") for name in archive.getnames()}
    wanted = [
        "CMakeLists.txt",
        "LICENSE",
        "README.md",
        "pyproject.toml",
        "cmake/levels.cmake",
        "tests/test_packaging.py",
    ]
    assert names.issuperset([*wanted, "generated/c/test/self_test.c", "src/chasles/py.typed", "PKG-INFO"])
    assert not [name for name in names if name.endswith((".so", ".pyc", ".egg-info"))]


def test_the_pure_wheel_holds_the_sources_and_nothing_else(pure_wheel: Path) -> None:
    assert pure_wheel.name == f"{NAME}-py3-none-any.whl"
    names = {name for name in contents(pure_wheel) if not name.startswith(f"{NAME}.dist-info/")}
    assert {"chasles/py.typed", "chasles/kernels/__init__.pyi", "chasles/generated/stubs/kernels.pyi"} <= names
    assert names == sources()


@needs_c
def test_the_compiled_wheel_is_the_pure_one_and_the_extension(pure_wheel: Path, compiled_wheel: Path) -> None:
    assert compiled_wheel.name.startswith(f"{NAME}-cp311-abi3-")
    pure, compiled = contents(pure_wheel), contents(compiled_wheel)
    objects = {name for name in compiled if name.startswith("chasles/objects/")}
    assert all(name.endswith(("/batches.o", *(f"/trigonometry_blocks_{k}.o" for k in range(3)))) for name in objects)
    (extension,) = set(compiled) - set(pure) - objects
    assert extension.startswith("chasles/_kernels.abi3.")
    assert {name: found for name, found in compiled.items() if name in pure} == pure


def test_tree_and_source_distribution_give_one_wheel_bit_for_bit(tree: Path, pure_wheel: Path, tmp_path: Path) -> None:
    build(tree, tmp_path, **PURE)
    (built,) = tmp_path.iterdir()
    assert contents(built) == contents(pure_wheel)
    assert built.read_bytes() == pure_wheel.read_bytes()


def test_the_source_distribution_is_the_same_every_time(sdist: Path, tmp_path: Path) -> None:
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path / "unpacked", filter="data")
    unpacked = tmp_path / "unpacked" / NAME
    (unpacked / "PKG-INFO").unlink()
    for path in unpacked.rglob("*"):
        os.utime(path)
    again = tmp_path / "again"
    again.mkdir()
    build_sdist(unpacked, again)
    assert (again / sdist.name).read_bytes() == sdist.read_bytes()


@pytest.mark.skipif(not WHOLE, reason="the pure one is installed below: set CHASLES_TEST_WHOLE=1")
@needs_c
def test_the_compiled_wheel_in_one_go(compiled_wheel: Path, environment: Environment) -> None:
    environment.install("--no-deps", compiled_wheel)
    said = environment.run(ONE_GO)
    assert "holds under  The point of the screw axis nearest the origin." in said
    assert "Answer: " in said
    assert said.splitlines()[-1] == "c"
    where = environment.run("python -c 'import chasles.derivations as d; print(d.__file__)'")
    assert Path(where.strip()).is_relative_to(environment.packages)
    succeed(sys.executable, "-m", "pip", "--python", environment.python, "check", cwd=environment.folder)


def test_the_pure_wheel_in_one_go(pure_wheel: Path, environment: Environment) -> None:
    environment.install("--no-deps", pure_wheel)
    said = environment.run(ONE_GO)
    assert "holds under  The point of the screw axis nearest the origin." in said
    assert said.splitlines()[-1] == "numpy"
    assert not (environment.packages / "flint").exists()
    some = "" if WHOLE else " --section 3.2.1"
    said = environment.run(f"CHASLES_CACHE= chasles decide --brief{some} && chasles derive 3.96c")
    assert ("522 statements: " if WHOLE else " statements: ") in said
    assert "complete; all results are as printed" in said


@pytest.mark.skipif(not WHOLE, reason="wheels of the folder and installed ones are tried: set CHASLES_TEST_WHOLE=1")
def test_the_folder_itself_can_be_installed(tree: Path, builder: Environment) -> None:
    builder.install("--no-deps", "--no-build-isolation", tree, **PURE)
    assert "The point of the screw axis nearest the origin." in builder.run("chasles list --section 3.2.1")


@pytest.mark.skipif(not WHOLE, reason="what runs these tests is an editable installation: set CHASLES_TEST_WHOLE=1")
def test_an_editable_installation_sees_what_is_edited(tree: Path, tmp_path: Path, builder: Environment) -> None:
    edited = shutil.copytree(tree, tmp_path / "edited")
    builder.install("--no-deps", "--no-build-isolation", "--editable", edited, **PURE)
    section = edited / "derivations" / "s02_screw.py"
    text = section.read_text("utf-8")
    sentence = "The point of the screw axis nearest the origin."
    assert sentence in text
    section.write_text(text.replace(sentence, "A sentence that was edited."), "utf-8")
    assert "A sentence that was edited." in builder.run("chasles list --section 3.2.1")
    where = builder.run("python -c 'import chasles; print(chasles.__file__)'").strip()
    assert where == str(edited / "src" / "chasles" / "__init__.py")


def test_compiled_kernels_can_be_insisted_on(tree: Path, tmp_path: Path) -> None:
    with pytest.raises(AssertionError, match="CMake configuration failed"):
        build(tree, tmp_path, CC="false", CHASLES_REQUIRE_C="1")


@pytest.mark.skipif(not os.environ.get(DOWNLOADS), reason=f"downloads: set {DOWNLOADS}=1")
@pytest.mark.parametrize("kind", ["compiled_wheel", "pure_wheel"])
def test_a_clean_machine_with_downloads(kind: str, request: pytest.FixtureRequest, tmp_path: Path) -> None:
    venv.create(tmp_path, with_pip=True)
    wheel = request.getfixturevalue(kind)
    path = os.pathsep.join((str(tmp_path / "bin"), os.environ["PATH"]))
    clean = {"PATH": path, "PYTHONPATH": "", "XDG_CACHE_HOME": str(tmp_path / "cache")}
    said = succeed("sh", "-c", f"pip install --quiet {wheel} && {ONE_GO}", cwd=tmp_path, **clean)
    assert said.splitlines()[-1] == ("c" if kind == "compiled_wheel" else "numpy")
