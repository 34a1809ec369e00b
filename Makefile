# Two commands: `make demo` and `make test`. Everything else is for those who work on isoracle.
.DEFAULT_GOAL := demo
.PHONY: demo demo-peers test test-long bench lint doc build m4 clean

CARGO ?= cargo
BIN := $(or $(CARGO_TARGET_DIR),target)/release/isoracle
PYTHON ?= python3
SEED ?= 1

# Judge the table of 1987, then mesh and check a real surface; the report is demo-report/report.html.
demo: build
	@$(BIN) demo --out demo-report

# The same judge on scikit-image, PyMCubes, VTK and libigl, in a virtual environment of its own.
demo-peers: build .venv/installed
	@sh examples/candidates/judge_all.sh $(BIN) .venv/bin/python peers-report

# The random cases are the same in every run; `make test-long` draws others each time.
test: m4
	PROPTEST_RNG_SEED=$(SEED) $(CARGO) test --release --no-fail-fast --features proptest,quickcheck
	$(PYTHON) -m unittest discover -s examples/candidates

# The heavy sweeps too: larger exhaustive domains, more random cases.
test-long: m4
	ISORACLE_LONG=1 PROPTEST_CASES=5000 PROPTEST_MAX_GLOBAL_REJECTS=1000000 PROPTEST_MAX_LOCAL_REJECTS=100000000 \
		$(CARGO) test --release --no-fail-fast --features proptest,quickcheck

bench: m4
	$(CARGO) bench

lint: m4
	$(CARGO) fmt --check
	$(CARGO) clippy --release --all-targets --features proptest,quickcheck -- -D warnings
	$(CARGO) clippy --release --no-default-features -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --release --no-deps

build: m4
	$(CARGO) build --release

# GMP, which the exact numbers are built on, needs m4 for its build.
m4:
	@command -v m4 >/dev/null || { [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null && apt-get update -qq && apt-get install -y -qq m4; } \
		|| { echo 'm4 is missing: GMP needs it for its build. Install it, for example: sudo apt-get install m4' >&2; exit 1; }
	@command -v $(CARGO) >/dev/null || { echo 'cargo is missing: install Rust, https://rustup.rs' >&2; exit 1; }

.venv/installed: examples/candidates/requirements.txt
	$(PYTHON) -m venv .venv
	.venv/bin/pip install --quiet --requirement examples/candidates/requirements.txt
	@touch $@

clean:
	$(CARGO) clean
	rm -rf demo-report peers-report .venv
