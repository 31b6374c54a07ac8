# brdfplot on Debian 12, from the packages that scripts/package makes.
#
#   docker build -t brdfplot .
#   docker run --rm -v "$PWD:/data" brdfplot eval configs/materials/ggx.json -q g1 --grid theta_o=0:80deg:10deg

FROM debian:12 AS build
COPY . /src
RUN /src/scripts/package

FROM debian:12
COPY --from=build /src/build/package/brdfplot_*.deb /tmp/
RUN apt-get update && apt-get install -y /tmp/brdfplot_*.deb && rm -rf /tmp/brdfplot_*.deb /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["brdfplot"]
