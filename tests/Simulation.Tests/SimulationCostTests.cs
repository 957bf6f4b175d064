using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests;

/// <summary>What a frame costs on any machine may not grow: bytes written and bytes allocated.</summary>
public class SimulationCostTests
{
    private const int WarmingTicks = 60;

    /// <summary>OpenCV 4.6 writes 216 kB of such a frame at its level 1.</summary>
    private const long MaxBytesOfPicture = 205_000;

    private const int Ticks = 100;
    private const long MaxBytesPerTick = 160_000;

    [Fact]
    public void Picture_of_a_street_has_few_bytes()
    {
        SimulatedGame game = Warm();
        var picture = new PixelBuffer(new ImageSize(800, 600));
        game.Ports.Screen.Grab(picture);
        using var file = new MemoryStream();
        new PngEncoder().Write(picture, file);
        Assert.InRange(file.Length, 1, MaxBytesOfPicture);
    }

    [Fact]
    public void Tick_allocates_little()
    {
        SimulatedGame game = Warm();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int tick = 0; tick < Ticks; tick++)
        {
            game.Tick(1 / 60.0);
        }

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, Ticks * MaxBytesPerTick);
    }

    private static SimulatedGame Warm()
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 3 });
        for (int tick = 0; tick < WarmingTicks; tick++)
        {
            game.Tick(1 / 60.0);
        }

        return game;
    }
}
