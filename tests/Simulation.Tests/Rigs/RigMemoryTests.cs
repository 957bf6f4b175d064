using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>What a harvest of many moments keeps in memory.</summary>
[Collection(MeasuredAlone.Name)]
public sealed class RigMemoryTests(ITestOutputHelper output)
{
    private const int Moments = 400;

    /// <summary>By then the simulated game has loaded its models.</summary>
    private const int Begun = 300;

    /// <summary>
    /// Half of the 150 kB of pixels and depths that each moment would take if moments were kept. New objects come into the world, with
    /// models and ids: 10 to 50 kB.
    /// </summary>
    private const long BytesPerMoment = 75_000;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Memory_does_not_grow_with_the_moments()
    {
        var image = new ImageSize(96, 72);
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [RigHarvest.Camera("front", new Vector3D(0, 2, 1), 0, image), RigHarvest.Camera("back", new Vector3D(0, -2, 1), 180, image)],
            [
                new RigLidar("top", new Pose(new Vector3D(0, 0, 1.6), Axes.Identity), [2, -2, -6, -10], 360, 10, 0.5, 60)
                {
                    RayFraction = 0.3,
                },
            ]
        );
        var game = new SimulatedGame(new SimulationOptions { Seed = 3, IsWarm = true });
        var sizes = new List<long>();
        int frames = 0;
        var sink = new MemorySink
        {
            KeepsFrames = false,
            OnFrame = _ =>
            {
                frames++;
                if (frames is Begun * 2 or Moments * 2)
                {
                    sizes.Add(GC.GetTotalMemory(forceFullCollection: true));
                }
            },
        };
        var options = new HarvestOptions
        {
            Rig = rig,
            Image = image,
            MaxFrames = Moments * 2,
            RateHz = 60,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
            Masks = true,
            Depth = true,
        };
        using (var session = new HarvestSession(options, game.Ports, sink))
        {
            game.Ports.RigCamera!.Show(rig.Cameras[0], rig.OnVehicle(rig.Cameras[0].Mount));
            do
            {
                game.Tick(1.0 / 60);
            } while (!session.Step().IsOver);
            Assert.Null(session.Fault);
        }

        double perMoment = (sizes[1] - sizes[0]) / (double)(Moments - Begun);
        output.WriteLine(
            FormattableString.Invariant($"{sizes[0] / 1e6:0.0} MB, then {perMoment:0} bytes for each of {Moments - Begun} moments")
        );
        Assert.InRange(perMoment, long.MinValue, BytesPerMoment);
    }
}
