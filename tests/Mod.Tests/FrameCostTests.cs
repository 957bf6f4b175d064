using System.Text.Json;
using System.Windows.Forms;
using GTA.Native;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Settings;

namespace Harvester.Mod.Tests;

/// <summary>
/// Natives and rays of a frame of 800x600 with the default settings, in streets of the simulated town that the test game shows. The limits
/// are the numbers measured since rays are cast only where samples disagree; those before anything was saved, of the same streets, are
/// beside them.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class FrameCostTests
{
    /// <summary>Ticks of some seven frames.</summary>
    private const int Ticks = 120;

    [Theory]
    // 600 vehicles and people within 300 m, 16 labels: before 29,915 natives and 3,757 rays.
    [InlineData(3, 1, 10_660, 1_365)]
    // 100 vehicles and people, 6 labels: before 6,373 natives and 980 rays.
    [InlineData(21, 0.15, 2_940, 490)]
    public void Frame_asks_the_game_once_for_what_stands_still(int seed, double density, int maxNatives, int maxRays)
    {
        var options = new SimulationOptions
        {
            Seed = seed,
            TrafficDensity = density,
            PedestrianDensity = density,
        };
        var scene = new SimulatedScene(options, FaceTable.Empty);
        using var driver = new ScriptDriver("[Harvest]\nRate = 2\n", scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        driver.Game.Calls.Clear();
        driver.Tick(Ticks);
        int natives = driver.Game.Calls.Count;
        int rays = driver.Game.Calls.Count(native => native == Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();

        string[] labels = driver.Labels();
        Assert.InRange(labels.Length, 5, 9);
        Assert.All(labels, line => Assert.NotEmpty(JsonDocument.Parse(line).RootElement.GetProperty("objects").EnumerateArray()));
        Assert.InRange(natives / labels.Length, 1, maxNatives);
        Assert.InRange(rays / labels.Length, 1, maxRays);
    }
}
