# The harvester command without a game; data is a folder of yours, in which the sessions appear:
#   docker build -t harvester .
#   mkdir data
#   docker run --rm -v "$PWD/data:/data" --user "$(id -u):$(id -g)" harvester harvest --out /data/session
FROM mcr.microsoft.com/dotnet/sdk:10.0 AS build
WORKDIR /source
COPY . .
RUN dotnet publish -c Release -r linux-x64 --self-contained -o /program src/Harvester.Cli

# What a program that contains the runtime needs of a system, and a user without rights.
FROM mcr.microsoft.com/dotnet/runtime-deps:10.0
COPY --from=build /program /opt/harvester
RUN install -d -o "$APP_UID" -g "$APP_UID" /data
USER $APP_UID
WORKDIR /data
ENTRYPOINT ["/opt/harvester/harvester"]
CMD ["--help"]
