#!/usr/bin/env bash
# A package of `plm export --ros2`, built by ament_cmake of Debian with headers that stand in for rclcpp and its messages, and its
# package.xml read by catkin_pkg. ROS 2 itself is not here: nothing of it is compiled or run.
#
#     bash tests/ros2.sh      # PLM is the command `plm`; without it cargo builds it
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
made=$target/ros2 tools=$target/tools/catkin
if ! command -v cmake >/dev/null || ! [ -d /usr/share/ament_cmake ]; then
    if [ "$(id -u)" != 0 ] || ! { apt-get install -y -qq ament-cmake cmake || { apt-get update -qq && apt-get install -y -qq ament-cmake cmake; }; } >/dev/null; then
        printf 'NOT CHECKED: ament_cmake cannot be had on this machine\n'
        exit 0
    fi
fi
if ! "$tools/bin/python" -c 'import catkin_pkg' 2>/dev/null; then
    python3 -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check catkin_pkg setuptools
fi
plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi

# The declaration of the book's page.
rm -rf "$made"
mkdir -p "$made"
sed -n '/^pub Pendulum {/,/^}/p' docs/src/running/ros2.md >"$made/pendulum.plm"
"$plm" export "$made/pendulum.plm" --ros2 "$made/pendulum"
"$tools/bin/python" - "$made/pendulum" <<'END'
import sys
from catkin_pkg.package import parse_package
package = parse_package(sys.argv[1])
package.validate()
assert (package.name, package.get_build_type()) == ("pendulum", "ament_cmake"), package
assert "rclcpp" in [each.name for each in package.build_depends]
END

# Packages of CMake that have no more than the headers.
stand_in=$PWD/crates/plm-source/tests/ros2/include
for package in geometry_msgs rcl_interfaces rclcpp std_msgs std_srvs tf2_msgs; do
    mkdir -p "$made/stand_in/$package"
    {
        printf 'add_library(%s::%s INTERFACE IMPORTED)\n' $package $package
        printf 'target_include_directories(%s::%s INTERFACE "%s")\n' $package $package "$stand_in"
        printf 'set(%s_TARGETS %s::%s)\n' $package $package $package
    } >"$made/stand_in/$package/${package}Config.cmake"
done
cmake -S "$made/pendulum" -B "$made/build" -DCMAKE_PREFIX_PATH="$made/stand_in" -DCMAKE_INSTALL_PREFIX="$made/install" \
    -DPython3_EXECUTABLE=/usr/bin/python3 >"$made/cmake.txt" 2>&1 &&
    cmake --build "$made/build" --target install >>"$made/cmake.txt" 2>&1 || { cat "$made/cmake.txt"; exit 1; }
[ -f "$made/install/share/ament_index/resource_index/packages/pendulum" ]
[ -f "$made/install/share/pendulum/package.xml" ]
printf 'tick 100\n' | "$made/install/lib/pendulum/node" >"$made/said.txt"
# One second by the node, and by a run of the declaration.
run=$("$plm" run "$made/pendulum.plm" --until 1 --every 1 --csv - --method Dop853:1e-12 | tail -n 1 | cut -d , -f 2)
node=$(grep '^~/output/bar_angle' "$made/said.txt" | tail -n 1 | cut -d ' ' -f 2)
python3 -c 'import sys; run, node = float(sys.argv[1]), float.fromhex(sys.argv[2]); print(f"angle after 1 s: plm run {run:.12f}, node {node:.12f} rad"); assert abs(run - node) < 1e-9' "$run" "$node"
