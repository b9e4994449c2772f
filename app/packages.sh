# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sourced by app/run and tests/run: the Debian 12 packages of the build, and their installation.

build_packages=(
    g++ cmake ninja-build
    qt6-base-dev qt6-charts-dev qt6-svg-dev
    libqt6opengl6-dev # Qt Charts is not found without it
    libeigen3-dev libfftw3-dev libhdf5-dev libtomlplusplus-dev libudunits2-dev libzip-dev libcli11-dev
    libboost-dev # quasi-random points
    libdxflib-dev nlohmann-json3-dev
    fonts-dejavu-core # without a font, every letter is an empty box
)

# Installs those of the packages that are missing. Asks nothing of apt, nor of the network, when none is.
install_packages() {
    local missing=() package
    for package in "$@"; do
        if [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]]; then
            missing+=("$package")
        fi
    done
    if ((${#missing[@]} == 0)); then
        return
    fi
    echo "Installing ${missing[*]}" >&2
    local as_root=(env)
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            echo "As root: apt-get install --no-install-recommends ${missing[*]}" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -q
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${missing[@]}"
}
