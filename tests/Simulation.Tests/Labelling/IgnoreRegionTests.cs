using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>Ignore regions against what the pictures truly show beyond the labelling range.</summary>
public sealed class IgnoreRegionTests(ITestOutputHelper output)
{
    private const double Range = 150;
    private const double IgnoreRange = 300;

    /// <summary>An object of this many pixels is clearly visible: a car at 200 m, unhidden, has about 300 at 1920 x 1080.</summary>
    private const int ClearlyVisiblePixels = 60;

    /// <summary>Area of a car's box seen from behind, m². Of a larger object, more pixels must show to make it as clearly
    /// visible.</summary>
    private const double RearOfCar = 1.9 * 1.35;

    /// <summary>Objects hardly reach out of their cuboids.</summary>
    private const double MinFractionWithin = 0.95;

    /// <summary>
    /// Rays and the renderer may differ along an outline: an object of a few pixels may be hit by a ray and have no pixel.
    /// </summary>
    private const double MaxEmptyRegions = 0.02;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Every_visible_object_out_of_range_is_an_ignore_region() => Judge(15, "snow");

    [Fact]
    [Trait("Category", "Heavy")]
    public void Every_visible_object_out_of_range_is_ignored_under_clouds() => Judge(17, "clouds");

    private static double PixelsOfClearlyVisible(EntityState entity)
    {
        double rear = (entity.ModelMax.X - entity.ModelMin.X) * (entity.ModelMax.Z - entity.ModelMin.Z);
        return ClearlyVisiblePixels * Math.Max(1, rear / RearOfCar);
    }

    private void Judge(int seed, string weather)
    {
        int expected = 0,
            regions = 0,
            empty = 0;
        var missed = new List<string>();
        var options = new HarvestOptions
        {
            Image = new ImageSize(1920, 1080),
            MaxFrames = 8,
            RateHz = 0.25,
            RangeMetres = Range,
            IgnoreRangeMetres = IgnoreRange,
        };
        LabelledTown.Harvest(
            new SimulationOptions
            {
                Seed = seed,
                Weather = weather,
                WindowAspect = 16 / 9.0,
            },
            options,
            (frame, truth) =>
            {
                EntityState[] distant =
                [
                    .. truth.Scene.Entities.Where(entity =>
                        (entity.Pose.Position - truth.Scene.Camera.Pose.Position).Length is >= Range and < IgnoreRange
                        && truth.PixelsOf(entity.Handle).Count > 0
                    ),
                ];
                IgnoreRegion[] seen = [.. frame.Label.IgnoreRegions.Where(region => region.Reason == IgnoreReason.BeyondRange)];
                foreach (
                    EntityState entity in distant.Where(entity => truth.PixelsOf(entity.Handle).Count >= PixelsOfClearlyVisible(entity))
                )
                {
                    expected++;
                    if (
                        !seen.Any(region =>
                            region.Class == entity.Class
                            && truth.PixelsWithin(entity.Handle, region.Box2D) >= MinFractionWithin * truth.PixelsOf(entity.Handle).Count
                        )
                    )
                    {
                        missed.Add(
                            $"frame {frame.Label.Frame}: {entity.Class} {entity.Model}, {truth.PixelsOf(entity.Handle).Count} pixels, at "
                                + $"{(entity.Pose.Position - truth.Scene.Camera.Pose.Position).Length:F0} m"
                        );
                    }
                }

                regions += seen.Length;
                empty += seen.Count(region =>
                    !distant.Any(entity => entity.Class == region.Class && truth.PixelsWithin(entity.Handle, region.Box2D) > 0)
                );
            }
        );

        output.WriteLine(
            $"{expected} objects of {ClearlyVisiblePixels} pixels or more (large ones: more), {regions} regions, "
                + $"{empty} of them empty"
        );
        Assert.True(expected > 10, $"Only {expected} objects.");
        Assert.Empty(missed);
        Assert.True(empty <= MaxEmptyRegions * regions, $"{empty} of {regions} regions show nothing.");
    }
}
