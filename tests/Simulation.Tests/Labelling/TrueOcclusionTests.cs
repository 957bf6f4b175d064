using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>The occlusion that the renderer reports, against a ray through the centre of every pixel.</summary>
public sealed class TrueOcclusionTests(ITestOutputHelper output)
{
    /// <summary>Rays and z-buffer may differ at this many pixels of an object, whose centres lie on an edge to within rounding.</summary>
    private const double EdgePixels = 2;

    /// <summary>Labels are rounded to four decimals.</summary>
    private const double Rounding = 1e-4;

    /// <summary>64 rays through an object that is half hidden have a standard deviation of 0.06, the largest of all.</summary>
    private const double MaxMeanErrorOfRays = 0.04;

    private static readonly SimulationOptions Town = new()
    {
        Seed = 11,
        IsWarm = true,
        ReportsTrueOcclusion = true,
        PedestrianDensity = 2,
        TrafficDensity = 2,
    };

    [Fact]
    [Trait("Category", "Heavy")]
    public void True_occlusion_is_that_of_rays_through_all_pixels()
    {
        var game = new SimulatedGame(Town);
        int compared = 0,
            partly = 0;
        List<double> errors = [];
        var options = new HarvestOptions
        {
            Image = new ImageSize(320, 240),
            MaxFrames = 3,
            RateHz = 0.5,
            RangeMetres = 60,
        };
        LabelledTown.Harvest(
            game,
            game.Ports,
            options,
            (frame, _) =>
            {
                MeshInstance[] moving = [.. game.World.MovingNear(frame.Label.Camera.Pose.Position, 350)];
                MeshInstance[] all = [.. game.World.Scene.Static.Instances.ToArray(), .. moving];
                var rays = new SceneRayCaster(new RenderScene(all));
                foreach (ObjectLabel item in frame.Label.Objects.Where(item => item.Parent is null))
                {
                    int handle = game
                        .Shown.Entities.MinBy(entity =>
                            (entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5) - item.Box3D.Centre).Length
                        )!
                        .Handle;
                    var alone = new SceneRayCaster(new RenderScene(all.Where(instance => instance.Handle == handle)));
                    (int drawn, int hidden) = Count(frame.Label.Camera.ToCamera(), item.Box2D, handle, rays, alone);
                    Assert.NotNull(item.TrueOccludedFraction);
                    Assert.InRange(
                        Math.Abs(item.TrueOccludedFraction.Value - ((double)hidden / drawn)),
                        0,
                        (EdgePixels / drawn) + Rounding
                    );
                    compared++;
                    partly += item.TrueOccludedFraction is > 0.05 and < 0.95 ? 1 : 0;

                    // A rider hides parts of the machine, which rays do not count: they meet the rider within the machine's cuboid.
                    if (item.HasRider != true)
                    {
                        errors.Add(Math.Abs(item.TrueOccludedFraction.Value - item.OccludedFraction!.Value));
                    }
                }
            }
        );
        output.WriteLine($"{compared} objects, {partly} partly hidden, mean error of occludedFraction {errors.Average():F3}");
        Assert.True(compared > 20 && partly > 4, $"Only {compared} objects, of which {partly} are partly hidden.");
        Assert.InRange(errors.Average(), 0, MaxMeanErrorOfRays);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labels_have_no_true_occlusion_unless_asked_for()
    {
        var options = new HarvestOptions { Image = new ImageSize(160, 120), MaxFrames = 1 };
        LabelledTown.Harvest(
            Town with
            {
                ReportsTrueOcclusion = false,
            },
            options,
            (frame, _) =>
            {
                Assert.All(frame.Label.Objects, item => Assert.Null(item.TrueOccludedFraction));
                Assert.DoesNotContain("trueOccluded", JsonLabelWriter.Line(frame.Label), StringComparison.Ordinal);
            }
        );
    }

    /// <summary>The pixels of an object alone, and those of them where something else is met first.</summary>
    private static (int Drawn, int Hidden) Count(Camera camera, Box2D box, int handle, SceneRayCaster rays, SceneRayCaster alone)
    {
        int drawn = 0,
            hidden = 0;
        for (int row = (int)box.YMin; row < Math.Ceiling(box.YMax); row++)
        {
            for (int column = (int)box.XMin; column < Math.Ceiling(box.XMax); column++)
            {
                Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
                if (alone.Cast(ray, 1000, RayHit.World) is not null)
                {
                    drawn++;
                    hidden += rays.Cast(ray, 1000, RayHit.World)?.Entity == handle ? 0 : 1;
                }
            }
        }

        return (drawn, hidden);
    }
}
