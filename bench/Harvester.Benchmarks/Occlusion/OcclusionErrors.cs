using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.Benchmarks.Occlusion;

/// <summary>
/// Compares the occluded fraction that rays give with the one that the renderer reports, in frames of simulated streets, and counts the
/// rays and the visible objects that have no label.
/// </summary>
internal static class OcclusionErrors
{
    /// <summary>An object of this many pixels is plainly there, as in LabelEvidenceTests.</summary>
    private const int PlainPixels = 64;

    private const double TicksPerSecond = 60;

    private static readonly HarvestOptions Options = new()
    {
        Image = new ImageSize(800, 600),
        RateHz = 0.5,
        ProbeLag = false,
        MaxCalibrationErrorPixels = null,
        Faces = ModelFaces.Table,
    };

    /// <summary>Harvests streets and prints the figures of each and of all.</summary>
    /// <param name="density">Density of traffic and people: 1 for busy streets, 0.15 for quiet ones.</param>
    /// <param name="frames">Frames of each street.</param>
    /// <param name="firstSeed">Seed of the first street.</param>
    /// <param name="lastSeed">Seed of the last street.</param>
    public static void Run(double density, int frames, int firstSeed, int lastSeed)
    {
        var all = new OcclusionTally();
        for (int seed = firstSeed; seed <= lastSeed; seed++)
        {
            var street = new OcclusionTally();
            Harvest(seed, density, frames, street);
            Console.WriteLine($"seed {seed}: {street}");
            all.Add(street);
        }

        Console.WriteLine($"all: {all}");
    }

    private static void Harvest(int seed, double density, int frames, OcclusionTally tally)
    {
        var options = new SimulationOptions
        {
            Seed = seed,
            TrafficDensity = density,
            PedestrianDensity = density,
            IsWarm = true,
            ReportsTrueOcclusion = true,
        };
        var game = new SimulatedGame(options);
        var sink = new OneFrameSink();
        using var session = new HarvestSession(Options with { MaxFrames = frames }, game.Ports, sink);
        bool isOver = false;
        while (!isOver)
        {
            isOver = session.Step().IsOver;
            if (sink.Take() is { } frame)
            {
                Judge(game, frame, tally);
                frame.Dispose();
            }

            game.Tick(1 / TicksPerSecond);
        }
    }

    private static void Judge(SimulatedGame game, CapturedFrame frame, OcclusionTally tally)
    {
        tally.Frames++;
        tally.Rays += frame.Label.Rays?.Total ?? 0;
        ObjectLabel[] objects = [.. frame.Label.Objects.Where(item => item.Parent is null)];
        foreach (ObjectLabel item in objects)
        {
            // A rider hides parts of the machine, which rays do not count: they meet the rider within the machine's cuboid.
            if (item is { HasRider: not true, TrueOccludedFraction: { } drawn, OccludedFraction: { } found })
            {
                tally.Errors.Add(found - drawn);
            }
        }

        int[] pixels = game.Render(Options.Image).Handles;
        Dictionary<int, int> seen = pixels.Where(handle => handle != 0).CountBy(handle => handle).ToDictionary();
        HashSet<(string, Vector3D)> labelled = [.. objects.Select(item => (item.Model, item.Box3D.Centre))];
        double range = Options.RangeMetres;
        foreach (EntityState entity in game.Shown.Entities)
        {
            Vector3D centre = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Centre;
            bool isNear = (entity.Pose.Position - frame.Label.Camera.Pose.Position).Length < range;
            if (isNear && seen.TryGetValue(entity.Handle, out int count) && !labelled.Contains((entity.Model, centre)))
            {
                tally.Missed.Add(count);
                if (count >= PlainPixels)
                {
                    Console.WriteLine(
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"  frame {frame.Label.Frame}: no label of {entity.Model}, {count} pixels"
                        )
                    );
                }
            }
        }
    }
}
