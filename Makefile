# SPDX-License-Identifier: GPL-3.0-or-later
# The two commands of the README, and what else people here do often. All work is done by CMake and scripts/.
.PHONY: demo studio python docs packages test check fuzz coverage soak reproduce bench format clean

demo:       ## install what is missing, build, and run the main job: out/ holds the result
	@scripts/install-dependencies.sh demo
	@scripts/demo.sh

studio:     ## install what is missing, build the program and its page, and open the studio in the browser
	@scripts/install-dependencies.sh studio
	@scripts/studio.sh

python:     ## install what is missing, build the Python module, and make a wheel in out/
	@scripts/install-dependencies.sh python
	@scripts/python.sh

docs:       ## install what is missing, and build the site in build/site
	@scripts/install-dependencies.sh docs
	@scripts/docs.sh

packages:   ## install what is missing, build the Debian packages in out/packages, and try them in an empty Debian
	@scripts/install-dependencies.sh packages
	@scripts/packages.sh

test:       ## install what is missing, build, and pass the tests
	@scripts/install-dependencies.sh test
	@scripts/test.sh release format

check:      ## the slow rest: everything with assertions and under the sanitizers, clang-tidy, and a minute of fuzzing for each reader
	@scripts/install-dependencies.sh check
	@scripts/test.sh check headers sanitizers threads tidy fuzz

fuzz:       ## fuzz every reader of strangers' files: FUZZ_SECONDS=600 each
	@scripts/install-dependencies.sh check
	@scripts/fuzz.sh

coverage:   ## the share of lines in framework/ that the tests run
	@scripts/install-dependencies.sh check
	@scripts/coverage.sh

soak:       ## a night: pages against their commands, an hour of storm, the attack, fuzzing, random calls, packages built twice
	@scripts/install-dependencies.sh check
	@scripts/soak.sh

reproduce:  ## regenerate what the paper prints: paper | ours | verdict
	@scripts/install-dependencies.sh demo
	@scripts/reproduce.sh

bench:      ## build and run the benchmarks of every stage
	@scripts/install-dependencies.sh test
	@scripts/bench.sh

format:     ## lay out every source file
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	@rm -rf build out
