# The Python of QGIS, which is the distribution's.
PYTHON ?= /usr/bin/python3
# The last mypy that checks against Python 3.9.
TOOLS = ruff==0.17.* mypy==1.19.* bandit==1.* detect-secrets==1.5.* flake8==7.*
SITE_TOOLS = "sphinx>=7,<10" "myst-parser>=3,<6" "furo>=2024"
DASK = "distributed==2024.8.*" "dask==2024.8.*" "zict==3.*" "importlib-metadata==8.*" "zipp==3.*"
RUN = PYTHONPATH=$(CURDIR)/.plugins:$(CURDIR)/.packages QT_QPA_PLATFORM=offscreen $(PYTHON)
VERSION = $(shell sed -n 's/^version=//p' metadata.txt)
DEMO = build/demo
# Models and pages are written in English, whatever the language of the computer.
export LC_ALL = C.UTF-8

# Small matrices are slower on several threads.
RUN_REGISTRATION = OPENBLAS_NUM_THREADS=1 $(RUN)
RUN_PEERS = LD_LIBRARY_PATH=$(CURDIR)/.peers/usr/lib/$(shell uname -m)-linux-gnu OPENBLAS_NUM_THREADS=1 \
	PYTHONPATH=$(CURDIR)/.plugins:$(CURDIR)/.packages:$(CURDIR)/.peers $(PYTHON)

.PHONY: help setup demo test suite lint accuracy plan rooms lived-in ablation benchmark figure2 real package test-matrix
.PHONY: desktop models example kills refusals cancel leaks facade streets facade-peers constants house sensitivity house-picture
.PHONY: registration registration-chain registration-surfaces placement peers registration-statistics registration-figure
.DELETE_ON_ERROR:

help:  ## Show this list
	@sed -n 's/^\([a-z0-9-]*\):.*  ## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | expand -t 26

setup: .packages/installed .plugins/ichnograph  ## Install missing packages, from apt (Debian, Ubuntu) and into this folder

.PHONY: distribution
distribution:
	@scripts/install-packages

.packages/installed: requirements.txt | distribution
	@# Everything else comes from the distribution, with the GDAL and numpy of QGIS.
	$(PYTHON) -m pip install --quiet --upgrade --target .packages --no-deps $$(grep -E '^(laspy|lazrs)' requirements.txt)
	@# Only E57 files need these, and not every machine has wheels of them.
	-$(PYTHON) -m pip install --quiet --upgrade --target .packages --no-deps --only-binary :all: pye57 pyquaternion
	@# The Dask of Debian 12 does not bear the loss of a worker.
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 12))' || $(PYTHON) -m pip install --quiet --upgrade \
		--target .packages --no-deps --only-binary :all: $(DASK)
	@touch $@

.plugins/ichnograph:
	@mkdir -p .plugins
	@ln -sfn .. $@

.tools/installed: Makefile | distribution
	$(PYTHON) -m venv .tools
	.tools/bin/pip install --quiet $(TOOLS)
	@touch $@

.tools/site: .tools/installed
	.tools/bin/pip install --quiet $(SITE_TOOLS)
	@touch $@

demo: setup  ## Simulate scans of ruins and of a facade, register them, and make the site plan and the elevation
	@rm -rf $(DEMO) && mkdir -p $(DEMO)
	$(RUN) -m ichnograph.tests.scenes ruins $(DEMO)/scan.laz --angular-step 0.2 --survey $(DEMO)/control.txt \
		--move 12 412345.6 5812345.7 71.3
	scripts/qgis_process run ichnograph:registerscans -- CONTROL=$(DEMO)/control.txt CRS=EPSG:25833 \
		$$(printf 'TARGETS=%s ' $(DEMO)/scan_*.txt) TRANSFORMS=$(DEMO)/transforms.json \
		RESIDUALS=$(DEMO)/residuals.shp CONTROL_OUT=$(DEMO)/control_out.shp REPORT=$(DEMO)/registration.html
	scripts/qgis_process run ichnograph:transformcloud -- $$(printf 'INPUT=%s ' $(DEMO)/scan_*.laz) \
		TRANSFORMS=$(DEMO)/transforms.json OUTPUT_FOLDER=$(DEMO)/registered
	scripts/qgis_process run ichnograph:siteplan -- $$(printf 'INPUT=%s ' $(DEMO)/registered/*.laz) \
		DENSITY=$(DEMO)/density.tif PLAN=$(DEMO)/plan.tif WALLS=$(DEMO)/walls.shp
	$(RUN) scripts/picture.py $(DEMO)/density.tif $(DEMO)/walls.shp $(DEMO)/siteplan.png
	$(RUN) -m ichnograph.tests.scenes.facades medina $(DEMO)/facade.laz --spacing 0.015 \
		--move 12 412345.6 5812345.7 71.3 --crs EPSG:25833
	scripts/qgis_process run ichnograph:facadedetails -- INPUT=$(DEMO)/facade.laz ELEVATION=$(DEMO)/elevation.shp \
		DETAILS=$(DEMO)/details.shp ORTHOIMAGE=$(DEMO)/orthoimage.tif SCHEDULE=$(DEMO)/schedule.csv \
		DRAWING=$(DEMO)/drawing.dxf
	$(RUN) scripts/elevation_picture.py $(DEMO)/orthoimage.tif $(DEMO)/elevation.shp $(DEMO)/elevation.png
	@echo
	@echo "In $(DEMO): density.tif, plan.tif, walls.shp and a picture of them, siteplan.png;"
	@echo "residuals.shp, control_out.shp, and registration.html, the report of the registration;"
	@echo "orthoimage.tif, elevation.shp and a picture of them, elevation.png; details.shp, schedule.csv, drawing.dxf."

test: lint suite  ## Check style and types, and run all tests

suite: setup  ## Run all tests on all cores, and then those that measure time or memory one by one
	$(RUN_REGISTRATION) -m pytest -n auto --dist loadfile -m "not alone"
	$(RUN_REGISTRATION) -m pytest -m alone

desktop: setup  ## Install the zip into an empty profile of QGIS, and use its dialogs under a virtual screen (PICTURES=)
	DESKTOP=1 PICTURES=$(PICTURES) $(RUN) -m pytest tests/desktop

lint: .tools/installed .plugins/ichnograph  ## Check style and types, and security as the plugin repository does
	.tools/bin/ruff check
	.tools/bin/ruff format --check
	.tools/bin/mypy
	.tools/bin/bandit -q -r algorithms processing_provider plugin.py __init__.py
	@# The formatter puts blanks around a colon where E203 wants none.
	.tools/bin/flake8 --max-line-length 120 --extend-ignore E203 algorithms processing_provider plugin.py __init__.py
	@# Files that are staged to be deleted are listed but do not exist.
	git ls-files -co --exclude-standard -z | xargs -0 -r ls -d 2>/dev/null | xargs .tools/bin/detect-secrets-hook

.PHONY: upright
upright: setup  ## Print which tilt is found of clouds that are tilted on purpose (CLOUDS=)
	$(RUN) -m ichnograph.benchmarks.upright $(CLOUDS)

.PHONY: fuzz
fuzz: setup  ## Run every reader on damaged files in child processes (MINUTES=2, READERS=)
	$(RUN) -m ichnograph.tests.fuzz --minutes $(or $(MINUTES),2) $(READERS)

accuracy: setup  ## Print how well the walls of the simulated scenes are found
	$(RUN) -m ichnograph.benchmarks.accuracy

plan: setup  ## Print the worst and the median plan of random scenes, rotations and shifts
	$(RUN) -m ichnograph.benchmarks.plan

rooms: setup  ## Print how well the rooms between the walls of the simulated scenes are found
	$(RUN) -m ichnograph.benchmarks.rooms

lived-in: setup  ## Print the worst and the median plan of simulated buildings in use, and their rooms
	$(RUN) -m ichnograph.benchmarks.lived_in

ablation: setup  ## Print what each idea of the plan of a storey contributes (CLOUDS=, REFERENCES=)
	$(RUN) -m ichnograph.benchmarks.ablation $(CLOUDS) $(if $(REFERENCES),--references $(REFERENCES))

benchmark: setup  ## Print how long ten million points take, by stage and beside the installed peers (POINTS=, RUNS=)
	$(RUN_PEERS) -m ichnograph.benchmarks.speed --stages $(if $(POINTS),--points $(POINTS)) $(if $(RUNS),--runs $(RUNS))

figure2: setup  ## Draw figure 2 of the paper: point spacing against pixel size
	$(RUN) -m ichnograph.benchmarks.figure2

real: setup  ## Make the plans of real scans, and compare them with plans drawn by hand (CLOUDS=, REFERENCES=)
	$(RUN) -m ichnograph.benchmarks.real_clouds $(CLOUDS) $(if $(REFERENCES),--references $(REFERENCES))

registration: setup  ## Print how reliably targets are matched, compared with the installed peers
	$(RUN_PEERS) -m ichnograph.benchmarks.registration

targets: setup  ## Print how many targets are found in simulated scans, and how exact their centres are
	$(RUN) -m ichnograph.benchmarks.targets

peers: .peers/installed  ## Install the tools that registration, facades and speed are compared with (peers)

.peers/installed: | distribution
	@# One by one, because not every system has all of them; numpy must remain that of the distribution.
	mkdir -p .peers
	for peer in open3d-cpu kiss-matcher cliquematch pyransac3d alphashape click-log trimesh rtree \
		"datashader==0.16.*" "xarray==2024.*" "dask==2023.5.*" colorcet multipledispatch param pyct \
		toolz cloudpickle fsspec partd locket; do \
		$(PYTHON) -m pip install --quiet --upgrade --target .peers --no-deps "$$peer" || true; \
	done
	@# open3d imports these.
	$(PYTHON) -m pip install --quiet --upgrade --target .peers dash configargparse
	cd .peers && apt-get download -qq libusb-1.0-0 && dpkg -x libusb-1.0-0_*.deb . && rm libusb-1.0-0_*.deb
	@touch $@

registration-statistics: setup  ## Print whether confidence regions and tests have their stated probabilities
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.registration_statistics

registration-figure: setup  ## Draw figure 9 of the paper: five points of a list of a hundred
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.registration_figure

registration-chain: setup  ## Print whether errors at the end of a chain of scans are as predicted
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.registration_chain

placement: setup  ## Print which scans surfaces place without any target, and how exactly (SEEDS=4)
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.placement --seeds $(or $(SEEDS),4)

registration-surfaces: setup  ## Print how far a chain of scans drifts if surfaces tie it (CHAINS=4)
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.registration_chain --surfaces --chains $(or $(CHAINS),4)

facade: setup  ## Print how well the details of simulated facades are measured
	$(RUN) -m ichnograph.benchmarks.facade

streets: setup  ## Print how well openings are found and measured in simulated streets
	$(RUN) -m ichnograph.benchmarks.streets

.PHONY: facade-cuts
facade-cuts: setup  ## Print how far the openings of a facade depend on what else is in its cloud (CLOUDS=)
	$(RUN) -m ichnograph.benchmarks.facade_cuts $(CLOUDS)

.PHONY: facade-speed
facade-speed: setup  ## Print how long facades of a million points take, by stage, and how much memory
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.facade_speed

facade-peers: setup  ## Print how long a facade takes, and how planes and outlines compare with other tools
	$(RUN_PEERS) -m ichnograph.benchmarks.facade_peers

sensitivity: setup  ## Print what each constant costs if it is 30 % smaller or larger
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.sensitivity

.PHONY: idle-constants
idle-constants: setup  ## Print the constants that change no result on any scene if they are 30 % smaller or larger
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.idle_constants

cancel: setup  ## Print how long a cancel takes, and the longest time without progress, for every algorithm (POINTS=, CPU=)
	$(RUN) -m ichnograph.benchmarks.cancel $(if $(POINTS),--points $(POINTS)) $(if $(CPU),--cpu)

leaks: setup  ## Print how memory and open files grow over 200 runs of every algorithm (E57=)
	$(RUN) -m ichnograph.benchmarks.leaks $(if $(E57),--e57 $(E57))

refusals: setup  ## Print which kinds of bad input were tried with each algorithm, and how many are refused
	$(RUN) -m ichnograph.benchmarks.refusals

kills: setup  ## Print what runs leave that are killed while they write
	$(RUN_REGISTRATION) -m ichnograph.benchmarks.kills

constants: setup  ## Write docs/constants.md, the page of all constants with their reasons
	$(RUN) -m ichnograph.scripts.constants_page

house: setup .tools/installed  ## Print how the code is divided: files, functions, imports, types, constants
	$(RUN) -m ichnograph.scripts.house_figures

models: setup  ## Write the models that the provider ships
	$(RUN) -m ichnograph.scripts.models

example: setup  ## Simulate the example data that the plugin ships
	$(RUN) -m ichnograph.tests.scenes rooms processing_provider/example/house.laz --angular-step 0.8 \
		--survey processing_provider/example/control.txt --move 12 412345.6 5812345.7 71.3 --crs EPSG:25833
	$(RUN) -m ichnograph.tests.scenes.facades medina processing_provider/example/facade.laz --spacing 0.03 \
		--move 12 412345.6 5812345.7 71.3 --crs EPSG:25833

.PHONY: release
release: setup .tools/installed  ## Print the size of the zip, what scans find in it, and helps and translations that are missing
	$(RUN) -m ichnograph.scripts.release

.PHONY: sheet
sheet: setup  ## Print how far the lengths on the printed sheet are off
	$(RUN) -m ichnograph.benchmarks.sheet

.PHONY: docs tutorial
docs: setup .tools/site  ## Make the site of the documentation in build/site/html, and check its links
	$(RUN) -m ichnograph.scripts.site.pages build/site/pages
	.tools/bin/sphinx-build -q -W --keep-going -c scripts/site build/site/pages build/site/html

tutorial: setup  ## Run the commands of docs/tutorial.md, and draw its pictures
	@rm -rf build/tutorial
	$(RUN) -m ichnograph.scripts.tutorial build/tutorial docs/pictures

.PHONY: translations
translations: setup  ## Bring the translations up to date with the texts, compile them, and list what is missing
	$(RUN) -m ichnograph.scripts.translations

house-picture: setup  ## Draw docs/pictures/house.svg, the packages and their imports
	$(RUN) -m ichnograph.scripts.house_picture docs/pictures/house.svg

package:  ## Zip the last commit as QGIS installs it, and print its size, which must be below 5 MB
	@mkdir -p build
	git archive --prefix=ichnograph/ --output build/ichnograph-$(VERSION).zip HEAD
	@stat --format '%n: %s bytes' build/ichnograph-$(VERSION).zip
	@test $$(stat --format %s build/ichnograph-$(VERSION).zip) -lt 5000000

test-matrix:  ## Run the tests of the last commit in fresh Debian releases (as root, with debootstrap)
	scripts/test-matrix
