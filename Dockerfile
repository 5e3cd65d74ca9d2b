# phytobench on a dated Debian 12: the same packages whenever it is built.
#
#   docker build -t phytobench .
#   mkdir -p results && docker run --rm --network none --user "$(id -u):$(id -g)" -v "$PWD/results:/data" phytobench \
#     run --tier smoke --out smoke
#
# Only building needs a network. SNAPSHOT is a day of snapshot.debian.org for which there is an image of that date; PRESET
# is release, for processors with AVX2 and FMA, or portable. The program runs as user 1000 unless told otherwise. There is
# no compiler, git or valgrind in the image: comparing revisions and counting instructions need a checkout. With CGAL in it
# the image is GPL as a whole.
ARG SNAPSHOT=20251229

FROM debian:bookworm-${SNAPSHOT}-slim AS base
ARG SNAPSHOT
ENV LC_ALL=C
SHELL ["/bin/bash", "-o", "pipefail", "-c"]
# There are no certificates yet, hence http; packages are signed.
RUN rm -f /etc/apt/sources.list.d/debian.sources \
 && for suite in "debian bookworm" "debian bookworm-updates" "debian-security bookworm-security"; do \
      echo "deb [check-valid-until=no] http://snapshot.debian.org/archive/${suite% *}/${SNAPSHOT}T000000Z ${suite#* } main"; \
    done > /etc/apt/sources.list \
 && echo 'Acquire::Retries "5";' > /etc/apt/apt.conf.d/80-retries

FROM base AS build
ARG PRESET=release
WORKDIR /src
COPY cmake/packages.txt cmake/install-packages cmake/
RUN cmake/install-packages build libraries && rm -rf /var/lib/apt/lists/*
COPY . .
RUN cmake --preset "$PRESET" \
 && cmake --build --preset "$PRESET" --target phytobench phytobench_worker \
 && cmake --install "build/$PRESET" --prefix /opt/phytobench --component program
# The packages whose libraries both programs load.
RUN ldd /opt/phytobench/bin/phytobench /opt/phytobench/bin/phytobench_worker \
  | awk '$3 ~ /^\// { sub(".*/", "", $3); print "*/" $3 }' | sort -u \
  | xargs dpkg-query -S | grep -v '^diversion' | cut -d: -f1 | sort -u > /opt/runtime-packages

FROM base
COPY --from=build /opt/runtime-packages /opt/runtime-packages
RUN apt-get -qq update \
 && xargs -a /opt/runtime-packages apt-get -qq -y --no-install-recommends install gnuplot-nox \
 && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/phytobench /opt/phytobench
ENV PATH=/opt/phytobench/bin:$PATH
RUN useradd --uid 1000 --create-home --home-dir /data phytobench
USER phytobench
WORKDIR /data
ENTRYPOINT ["phytobench"]
CMD ["--help"]
