#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. The last line says how many passed.
#
#   bash tests/run.sh [--preset dev|asan|tsan|release] [-- CMAKE_ARGUMENT...]
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=dev
while [ $# -gt 0 ]; do
    case $1 in
    --preset) preset=${2:?tests/run.sh: --preset needs a name} && shift 2 ;;
    --) shift && break ;;
    *) echo "tests/run.sh: unknown argument '$1': usage: tests/run.sh [--preset NAME] [-- CMAKE_ARGUMENT...]" >&2 && exit 2 ;;
    esac
done
cd "$root" || exit 1

give_up() {
    echo "tests/run.sh: $1: no test was run" >&2
    echo "0 passed, 1 failed"
    exit 1
}

bash share/install-dependencies.sh build rawlog demo test || give_up "packages are missing"
cmake --preset "$preset" "$@" || give_up "CMake failed"
cmake --build --preset "$preset" || give_up "the build failed"

# Leaks count as failures, and so does undefined behaviour (which the build makes fatal).
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
log=build/$preset/ctest.log
ctest --test-dir "build/$preset" -j "$(nproc)" --output-on-failure 2>&1 | tee "$log"
status=${PIPESTATUS[0]}

# One line a test, such as "  3/120 Test  #7: Name ....   Passed    0.01 sec"; all that neither passed nor was skipped failed.
results=$(grep -E '^ *[0-9]+/[0-9]+ Test +#[0-9]+: ' "$log")
total=$(grep -c . <<<"$results")
passed=$(grep -cE ' Passed +[0-9.]+ sec' <<<"$results")
skipped=$(grep -cE '\*\*\*Skipped' <<<"$results")
failed=$((total - passed - skipped))
if [ "$total" -eq 0 ]; then give_up "ctest found no test"; fi
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
    echo "tests/run.sh: ctest ended with $status though no test failed" >&2
    failed=1
fi
line="$passed passed, $failed failed"
[ "$skipped" -eq 0 ] || line="$line, $skipped skipped"
echo "$line"
[ "$failed" -eq 0 ]
