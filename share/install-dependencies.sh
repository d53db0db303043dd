#!/usr/bin/env bash
# Installs the Debian packages that Gr2To needs, those that are missing only.
#
#   bash share/install-dependencies.sh [GROUP...]
#
# Groups: build, rawlog, demo, test, bench, lint; all of them when none is given. Group rawlog is for the program
# gr2to-rawlog alone: MRPT's SLAM library brings OpenCV's windows and Qt along.
# This file is the only place that lists packages.
set -euo pipefail

packages_of() {
    case $1 in
    build) echo g++ cmake ninja-build pkg-config libmrpt-maps-dev libmrpt-graphs-dev liboctomap-dev libeigen3-dev libpugixml-dev \
        libcli11-dev libpng-dev zlib1g-dev libcairo2-dev libyaml-cpp-dev nlohmann-json3-dev ;;
    rawlog) echo libmrpt-slam-dev ;;
    demo) echo mrpt-common ;;
    test) echo libgtest-dev libgmock-dev libxml2-utils libmrpt-nav-dev python3 python3-numpy python3-scipy python3-skimage python3-pil man-db mrpt-apps ;;
    bench) echo libbenchmark-dev libopencv-imgproc-dev ;;
    lint) echo clang-format clang-tidy git ;;
    *)
        echo "install-dependencies.sh: unknown group '$1': choose from build, rawlog, demo, test, bench, lint" >&2
        exit 2
        ;;
    esac
}

is_installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "install-dependencies.sh: needs Debian's apt-get and dpkg-query; elsewhere install the packages listed in it by hand" >&2
    exit 1
fi
[ $# -gt 0 ] || set -- build rawlog demo test bench lint

missing=()
for group in "$@"; do
    packages=$(packages_of "$group")
    for package in $packages; do
        is_installed "$package" || missing+=("$package")
    done
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "install-dependencies.sh: not root and no sudo; as root run: apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "Installing ${missing[*]}"
# A third-party source that is out of reach must not stop what Debian's own sources can give.
"${as_root[@]}" apt-get update -q ||
    echo "install-dependencies.sh: apt-get update failed; going on with the package lists at hand" >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
