using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>Riders and the joints of people in masks, against what the renderer draws.</summary>
[Trait("Category", "Heavy")]
public sealed class RiderTests(ITestOutputHelper output)
{
    /// <summary>The seed with which riders were made objects.</summary>
    private const int DevelopmentSeed = 3;

    /// <summary>A seed that had no part in any choice.</summary>
    private const int OtherSeed = 4711;

    /// <summary>
    /// The share of the riders' drawn pixels that masks from rays may miss: at outlines, which are most of a rider of 10 to 240 pixels.
    /// </summary>
    private const double MaxMissedFraction = 0.04;

    /// <summary>Seeds for the pixels, from <see cref="OtherSeed"/> on.</summary>
    private const int Seeds = 7;

    /// <summary>The required distance of a visible joint from its own mask, pixels.</summary>
    private const int NearPixels = 2;

    /// <summary>The required share of visible joints that are so near.</summary>
    private const double MinNearFraction = 0.99;

    [Fact]
    public void Pixels_of_riders_have_their_ids()
    {
        int drawn = 0,
            missed = 0,
            labels = 0;
        Array.ForEach(
            [.. Enumerable.Range(OtherSeed, Seeds)],
            seed =>
                Harvest(
                    seed,
                    (frame, truth) =>
                    {
                        foreach (EntityState rider in truth.Scene.Entities.Where(entity => entity.Class == ObjectClass.Rider))
                        {
                            Vector3D centre = rider.Pose.ToWorld((rider.ModelMin + rider.ModelMax) * 0.5);
                            ObjectLabel? label = frame.Label.Objects.FirstOrDefault(item =>
                                item.Class == ObjectClass.Rider && (item.Box3D.Centre - centre).Length < 1e-3
                            );
                            if (label is not null)
                            {
                                labels++;
                                ObjectLabel? vehicle = frame.Label.Objects.FirstOrDefault(item => item.Id == label.Vehicle);
                                Assert.True(vehicle is null or { HasRider: true }, $"The vehicle of rider {label.Id} is not ridden.");
                                drawn += truth.PixelsOf(rider.Handle).Count;
                                missed += truth.PixelsOf(rider.Handle).Count(pixel => frame.Mask!.Ids[pixel] != label.Id);
                            }
                        }
                    }
                )
        );
        output.WriteLine($"{labels} labels of riders, {missed} of {drawn} pixels without their id");
        Assert.True(labels > 50, $"Only {labels} labels of riders.");
        Assert.InRange(missed / (double)drawn, 0, MaxMissedFraction);
    }

    [Theory]
    [InlineData(DevelopmentSeed)]
    [InlineData(OtherSeed)]
    public void Visible_joints_are_within_two_pixels_of_their_mask(int seed)
    {
        int visible = 0,
            on = 0,
            near = 0;
        Harvest(
            seed,
            (frame, _) =>
            {
                foreach (ObjectLabel person in frame.Label.Objects.Where(item => item.Joints is not null))
                {
                    foreach (JointLabel joint in person.Joints!.Joints.Where(joint => joint.Visibility == JointVisibility.Visible))
                    {
                        visible++;
                        on += IsNear(frame.Mask!, person.Id, joint.Pixel!.Value, 0) ? 1 : 0;
                        near += IsNear(frame.Mask!, person.Id, joint.Pixel!.Value, NearPixels) ? 1 : 0;
                    }
                }
            }
        );
        output.WriteLine($"{visible} visible joints, {on} on their own mask, {near} within {NearPixels} px");
        Assert.True(visible > 200, $"Only {visible} joints are visible.");
        Assert.InRange(near / (double)visible, MinNearFraction, 1);
    }

    private static void Harvest(int seed, Action<CapturedFrame, TruePicture> judge) =>
        LabelledTown.Harvest(
            new SimulationOptions
            {
                Seed = seed,
                TrafficDensity = 2,
                PedestrianDensity = 2,
            },
            new HarvestOptions
            {
                Image = new ImageSize(800, 600),
                MaxFrames = 12,
                Masks = true,
            },
            judge
        );

    /// <summary>Whether a pixel with an id lies within a distance of a position.</summary>
    private static bool IsNear(InstanceMap mask, int id, Vector2D place, int distance)
    {
        (int column, int row) = ((int)Math.Floor(place.X), (int)Math.Floor(place.Y));
        for (int y = Math.Max(0, row - distance); y <= Math.Min(mask.Image.Height - 1, row + distance); y++)
        {
            for (int x = Math.Max(0, column - distance); x <= Math.Min(mask.Image.Width - 1, column + distance); x++)
            {
                if (mask[x, y] == id && (((x - column) * (x - column)) + ((y - row) * (y - row))) <= distance * distance)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
