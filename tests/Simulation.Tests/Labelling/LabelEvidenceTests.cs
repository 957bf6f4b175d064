using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>
/// Labels against what the pictures truly show: nothing that cannot be seen has one, and nothing that is seen is left out.
/// </summary>
public sealed class LabelEvidenceTests(ITestOutputHelper output)
{
    /// <summary>Rays and the renderer may differ along an outline: an object that a ray hit at its very edge may have no pixel.</summary>
    private const double MaxUnseen = 0.005;

    /// <summary>An object of this many pixels is plainly there.</summary>
    private const int PlainPixels = 64;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Every_label_beyond_the_drawing_range_has_a_pixel() => Judge(15, "snow", masks: true);

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(15, "snow", false)]
    [InlineData(21, "rain", true)]
    public void Labels_beyond_the_drawing_range_have_pixels_elsewhere_too(int seed, string weather, bool masks) =>
        Judge(seed, weather, masks);

    private void Judge(int seed, string weather, bool masks)
    {
        // The simulated game draws moving things up to 350 m.
        int labels = 0,
            plain = 0;
        List<string> unseen = [],
            missed = [];
        var options = new HarvestOptions
        {
            Image = new ImageSize(1280, 720),
            MaxFrames = 4,
            RateHz = 0.25,
            RangeMetres = 500,
            Masks = masks,
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
                Dictionary<(string, Vector3D), int> handles = truth.Scene.Entities.ToDictionary(
                    entity => (entity.Model, CentreOf(entity)),
                    entity => entity.Handle
                );
                HashSet<int> labelled = [];
                foreach (ObjectLabel item in frame.Label.Objects.Where(item => item.Parent is null))
                {
                    labels++;
                    int handle = handles[(item.Model, item.Box3D.Centre)];
                    labelled.Add(handle);
                    if (truth.PixelsOf(handle).Count == 0 || item.IsUndetermined)
                    {
                        unseen.Add(
                            $"frame {frame.Label.Frame}: {item.Model} at {item.DistanceMetres:F0} m, {item.OcclusionMethod}, box "
                                + $"{item.Box2D.Area:F0} px²"
                        );
                    }
                }

                foreach (EntityState entity in truth.Scene.Entities.Where(entity => truth.PixelsOf(entity.Handle).Count >= PlainPixels))
                {
                    plain++;
                    if (!labelled.Contains(entity.Handle))
                    {
                        missed.Add($"frame {frame.Label.Frame}: {entity.Model}, {truth.PixelsOf(entity.Handle).Count} pixels");
                    }
                }
            }
        );

        output.WriteLine($"{labels} labels, {unseen.Count} of them unseen; {plain} plain objects, {missed.Count} of them missed");
        unseen.ForEach(output.WriteLine);
        missed.ForEach(output.WriteLine);
        Assert.True(labels > 50, $"Only {labels} labels.");
        Assert.InRange(unseen.Count, 0, MaxUnseen * labels);
        Assert.Empty(missed);
    }

    private static Vector3D CentreOf(EntityState entity) => Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Centre;
}
