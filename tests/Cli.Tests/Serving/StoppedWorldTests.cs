using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Clients;
using Harvester.Runs.Driving;
using Harvester.Runs.Serving;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Tests.Serving;

/// <summary>A world that a client of the folder has stopped before it went.</summary>
public sealed class StoppedWorldTests
{
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(60);

    [Theory]
    [InlineData(null)]
    [InlineData(0.1)]
    public async Task Folder_client_drives_on_in_a_world_left_paused_by_another(double? stepSeconds)
    {
        using TemporaryFolder folder = new();
        SimulatedGame game = new(
            new SimulationOptions
            {
                Seed = 1,
                TrafficDensity = 0,
                PedestrianDensity = 0,
            }
        );
        ImageSize picture = new(32, 24);
        using FolderBridge bridge = new(folder.Path, picture);
        using GameEndpoint bridged = new(
            game,
            new FixedRoads(game.Roads, "simulation"),
            new DrivingOptions { Picture = picture },
            bridge,
            static () => new DeepDrivingController(),
            isAssisted: true
        );
        using CancellationTokenSource ending = new();
        Task<DrivingStatus> serving = Task.Factory.StartNew(
            () => new ServedGame(game, bridged).Run(double.PositiveInfinity, ending.Token),
            CancellationToken.None,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default
        );
        await File.WriteAllTextAsync(folder.PathOf("command.json"), """{"type":"pause","paused":true}""");
        DateTime deadline = DateTime.UtcNow + Ample;
        while (!game.IsFrozen)
        {
            Assert.True(DateTime.UtcNow < deadline, "The world was not stopped.");
            await Task.Delay(10);
        }

        using (FolderLink link = new(folder.Path))
        {
            ClientDriver driver = new(link, static () => new StanleyController(new StanleyOptions()), Ample, TimeProvider.System);
            driver.Run(stepSeconds, 1, CancellationToken.None);
            Assert.True(driver.Seconds >= 1);
        }

        ending.Cancel();
        Assert.Null((await serving).Ending);
    }
}
