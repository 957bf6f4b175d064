using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Semantics;

/// <summary>Class maps from rays against the surfaces that the renderer drew.</summary>
public sealed class ClassMapTests(ITestOutputHelper output)
{
    /// <summary>Classes with fewer pixels in all pictures together are not judged: 1 pixel in 10,000.</summary>
    private const double MinShare = 1e-4;

    private const double MaxRayFraction = 0.02;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Classes_from_rays_are_those_of_the_picture() => Judge([17], 2, minRoadAndSky: 0.95, minMean: 0.85);

    public static TheoryData<int> Seeds => [.. ProofSize.Of([401], [301, 401])];

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Seeds))]
    public void Classes_from_rays_are_those_of_the_picture_in_20_frames(int seed) =>
        Judge([seed, seed + 1, seed + 2, seed + 3], 5, minRoadAndSky: 0.95, minMean: 0.85);

    private void Judge(int[] seeds, int frames, double minRoadAndSky, double minMean)
    {
        long[] both = new long[SemanticClasses.Greatest + 1];
        long[] either = new long[both.Length];
        long[] shown = new long[both.Length];
        double maxRays = 0;
        var options = new HarvestOptions
        {
            Image = new ImageSize(800, 600),
            MaxFrames = frames,
            RateHz = 0.25,
            Masks = true,
            Semantics = SemanticsMethod.Rays,
        };
        foreach (int seed in seeds)
        {
            var simulation = new SimulationOptions
            {
                Seed = seed,
                WindowAspect = options.Image.Aspect,
                Detail = Detail.Full,
            };
            var game = new Game.SimulatedGame(simulation);
            LabelledTown.Harvest(
                game,
                game.Ports,
                options,
                (frame, _) =>
                {
                    InstanceMap truth = game.Ports.Surfaces!.Draw(
                        options.Image,
                        handle =>
                            game.Shown.Entities.FirstOrDefault(entity => entity.Handle == handle) is { } entity
                                ? SemanticClasses.Of(entity.Class)
                                : SemanticClass.Other
                    );
                    InstanceMap map = frame.Part<ClassMapPart>()!.Map;
                    for (int i = 0; i < truth.Ids.Length; i++)
                    {
                        (ushort real, ushort seen) = (truth.Ids[i], map.Ids[i]);
                        shown[real]++;
                        either[real]++;
                        both[real] += real == seen ? 1 : 0;
                        either[seen] += real == seen ? 0 : 1;
                    }

                    double fraction = (double)frame.Label.ClassMap!.RaysCast / options.Image.PixelCount;
                    maxRays = Math.Max(maxRays, fraction);
                    output.WriteLine(
                        $"seed {seed}, frame {frame.Label.Frame}: {fraction:P3} of the pixels as rays, mask {frame.Label.Rays!.Map}"
                    );
                }
            );
        }

        long all = shown.Sum();
        var ious = new Dictionary<SemanticClass, double>();
        for (int value = 1; value < both.Length; value++)
        {
            if (shown[value] > 0)
            {
                double iou = (double)both[value] / either[value];
                output.WriteLine($"{(SemanticClass)value}: IoU {iou:F4}, {(double)shown[value] / all:P3} of the pixels");
                if (shown[value] >= MinShare * all)
                {
                    ious[(SemanticClass)value] = iou;
                }
            }
        }

        output.WriteLine($"mean IoU {ious.Values.Average():F4}; rays at most {maxRays:P3}");
        Assert.True(maxRays <= MaxRayFraction, $"rays {maxRays:P3}");
        Assert.True(ious[SemanticClass.Road] >= minRoadAndSky, $"road {ious[SemanticClass.Road]:F4}");
        Assert.True(ious[SemanticClass.Sky] >= minRoadAndSky, $"sky {ious[SemanticClass.Sky]:F4}");
        Assert.True(ious.Values.Average() >= minMean, $"mean {ious.Values.Average():F4}");
    }
}
