# The harvester command without a game; data is a folder of yours, in which the sessions appear:
#   docker build -t harvester .
#   mkdir data
#   docker run --rm -v "$PWD/data:/data" --user "$(id -u):$(id -g)" harvester harvest --out /data/session
FROM mcr.microsoft.com/dotnet/sdk:10.0@sha256:ea8bde36c11b6e7eec2656d0e59101d4462f6bd630730f2c8201ed0572b295d5 AS build
WORKDIR /source
COPY . .
# The packages are those of the lock files; the build for one system adds only what comes with the SDK.
RUN dotnet restore --locked-mode src/Harvester.Cli
RUN dotnet publish -c Release -r linux-x64 --self-contained -o /program src/Harvester.Cli

# What a program that contains the runtime needs of a system, and a user without rights.
FROM mcr.microsoft.com/dotnet/runtime-deps:10.0@sha256:894098eafc82e5fa02ba9f2b71d426dc78252876b9e914caae77ed95cfce185a
COPY --from=build /program /opt/harvester
RUN install -d -o "$APP_UID" -g "$APP_UID" /data
USER $APP_UID
WORKDIR /data
ENTRYPOINT ["/opt/harvester/harvester"]
CMD ["--help"]
