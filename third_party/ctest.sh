# Sourced by test and .ci/run after setup.sh: runs CTest in a build folder and sums up.

# A command to start ctest with, empty for none.
nuno_launch=()

# Value of a number attribute of the report's outermost element, 0 where it is absent.
nuno_junit_number() {
    local value
    value=$(sed -n '/<testsuite /,/>/p' "$1" | grep -oE "\b$2=\"[0-9]+\"" | head -n 1 | grep -oE '[0-9]+' || true)
    echo "${value:-0}"
}

# Lets through what a reader wants of CTest's output: failures, and one line of progress every hundred tests.
nuno_ctest_output() {
    local line passed=0
    while IFS= read -r line; do
        case $line in
            *" Start "[0-9\ ]*) ;;
            *Test*#*Passed*sec*)
                passed=$((passed + 1))
                ((passed % 100 == 0)) && echo "... $passed passed"
                ;;
            *"tests passed, "*|"Label Time Summary:"*|*" sec*proc "*|"Total Test time"*|"Errors while running"*) ;;
            "Test project "*|"Internal ctest changing"*|"") ;;
            *) printf '%s\n' "$line" ;;
        esac
    done
    return 0
}

# nuno_ctest BUILD_DIR [CTEST ARGS...]: prints failing tests and the summary line; returns 1 if a test failed or none ran.
nuno_ctest() {
    local build=$1 report status=0 total failed skipped passed
    shift
    report=$build/tests.xml
    rm -f "$report"
    "${nuno_launch[@]}" ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" --output-junit "$report" "$@" 2>&1 \
        </dev/null | nuno_ctest_output || status=$?
    if [[ ! -f $report ]]; then
        echo "0 passed, 0 failed, 0 skipped"
        return 1
    fi
    total=$(nuno_junit_number "$report" tests)
    failed=$(nuno_junit_number "$report" failures)
    skipped=$(($(nuno_junit_number "$report" skipped) + $(nuno_junit_number "$report" disabled)))
    passed=$((total - failed - skipped))
    echo "$passed passed, $failed failed, $skipped skipped"
    [[ $status -eq 0 && $failed -eq 0 && $total -gt 0 ]]
}
