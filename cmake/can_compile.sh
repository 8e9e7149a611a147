#!/bin/sh
# can_compile.sh CC PYTHON: whether extension modules can be compiled. If not, says on standard error which Debian
# package is missing and exits with status 1.
cc=$1
python=$2

missing() {
    echo "$1: going on with the NumPy kernels. For compiled ones install the Debian package $2, then: make clean all" >&2
    exit 1
}

compiles() {
    # Unquoted: CC may carry arguments, as in "ccache gcc".
    echo "#include <$1>" | $cc -E -I"$include" - >/dev/null 2>&1
}

include=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')
command -v $cc >/dev/null || missing "No C compiler '$cc'" gcc
compiles math.h || missing "The C compiler '$cc' does not work, or the C library's headers are not there" libc6-dev
compiles Python.h || missing "No Python.h in $include" python3-dev
