using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Flow;

/// <summary>Flow of the simulated game compared with the motion of the points of the meshes, by the renderer's matrices.</summary>
public sealed class ExactFlowTests(ITestOutputHelper output)
{
    /// <summary>Required of 95 % of the pixels that are visible in both pictures; maps round to 1/64 pixel.</summary>
    private const double MaxErrorPixels = 0.05;

    /// <summary>
    /// A point and the pixel's centre differ by up to half a pixel where one surface ends and another begins, so that the flags of a few
    /// pixels along the silhouettes differ.
    /// </summary>
    private const double MinVisibilityAgreement = 0.97;

    /// <summary>A point at a distance is visible if a ray comes this near to it: single precision of the depth, with room.</summary>
    private const double SlackFraction = 1e-4;

    private static readonly ImageSize Image = new(400, 300);

    private static readonly RenderLens Bent = new(1.01, 0.004, -0.003, -0.12, 0.03);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Flow_is_the_motion_of_the_points_of_the_meshes()
    {
        Compare(61, new ImageSize(160, 120), RenderLens.None, frames: 2);
    }

    /// <summary>Seeds of drives, each with whether the lens is bent.</summary>
    public static TheoryData<int, bool> Drives
    {
        get
        {
            var drives = new TheoryData<int, bool> { { 9102, false }, { 9104, true } };
            foreach (int seed in ProofSize.Of([], [9101, 9103]))
            {
                drives.Add(seed, false);
            }

            return drives;
        }
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Drives))]
    public void Flow_of_a_drive_is_the_motion_of_the_points_of_the_meshes(int seed, bool isBent) =>
        Compare(seed, Image, isBent ? Bent : RenderLens.None, frames: 5);

    private void Compare(int seed, ImageSize image, RenderLens lens, int frames)
    {
        List<Compared> all = [];
        FlowHarvest harvest = new()
        {
            Seed = seed,
            Image = image,
            Lens = lens,
            Frames = frames,
        };
        harvest.Run(
            (maps, label, before, now, world) =>
            {
                Assert.Equal(SemanticsMethod.Exact, label.Method);
                Assert.Null(label.ErrorPixels);
                all.Add(Compare(maps.Backward, now, before, world, image));
                all.Add(Compare(maps.Forward, before, now, world, image));
                AssertAgree(maps, output);
            }
        );

        double[] errors = [.. all.SelectMany(each => each.Errors).Order()];
        double agreement = all.Sum(each => each.Agreeing) / (double)all.Sum(each => each.Judged);
        double lost = all.Sum(each => each.Missing) / (double)all.Sum(each => each.Shown);
        double moved = all.Sum(each => each.Moved) / (double)all.Sum(each => each.Shown);
        output.WriteLine(
            FormattableString.Invariant(
                $"{seed}: {errors.Length} pixels, error median {At(0.5):0.0000}, 95 % {At(0.95):0.0000}, 99.9 % {At(0.999):0.0000} px; "
            )
                + FormattableString.Invariant(
                    $"visibility agrees for {agreement:0.0000}; moved {moved:0.000}; without flow, people apart, {lost:0.0000}"
                )
        );

        Assert.True(errors.Length > image.PixelCount, "Too few pixels were compared.");
        Assert.InRange(At(0.95), 0, MaxErrorPixels);
        Assert.InRange(agreement, MinVisibilityAgreement, 1);

        double At(double fraction) => errors[(int)(fraction * errors.Length)];
    }

    /// <summary>Forward and backward flow lead back to the pixel where both are visible and neighbours show one surface.</summary>
    private static void AssertAgree(FlowMaps maps, ITestOutputHelper output)
    {
        List<double> gaps = [];
        ImageSize image = maps.Backward.Image;
        for (int at = 0; at < maps.Backward.Flags.Length; at++)
        {
            if ((maps.Backward.At(at) & ~FlowFlags.Moved) != FlowFlags.Valid)
            {
                continue;
            }

            (double u, double v) = (Written(maps.Backward.U[at]), Written(maps.Backward.V[at]));
            if (Between(maps.Forward, (at % image.Width) + u, (at / image.Width) + v) is { } back)
            {
                gaps.Add(new Vector2D(u + back.X, v + back.Y).Length);
            }
        }

        gaps.Sort();
        output.WriteLine(
            FormattableString.Invariant(
                $"there and back: {gaps.Count} pixels, median {gaps[gaps.Count / 2]:0.0000}, 95 % {gaps[gaps.Count * 95 / 100]:0.0000} px"
            )
        );
        Assert.InRange(gaps[gaps.Count * 95 / 100], 0, MaxErrorPixels);
    }

    /// <summary>The flow between the centres of four pixels; null where they do not all have one.</summary>
    private static Vector2D? Between(FlowField field, double column, double row)
    {
        (int left, int top) = ((int)Math.Floor(column), (int)Math.Floor(row));
        if (left < 0 || top < 0 || left + 1 >= field.Image.Width || top + 1 >= field.Image.Height)
        {
            return null;
        }

        (double u, double v) = (0, 0);
        for (int i = 0; i < 4; i++)
        {
            int at = ((top + (i / 2)) * field.Image.Width) + left + (i % 2);
            if ((field.At(at) & ~FlowFlags.Moved) != FlowFlags.Valid)
            {
                return null;
            }

            double across = i % 2 == 0 ? left + 1 - column : column - left;
            double down = i / 2 == 0 ? top + 1 - row : row - top;
            u += across * down * Written(field.U[at]);
            v += across * down * Written(field.V[at]);
        }

        return new Vector2D(u, v);
    }

    private static double Written(float pixels) => FlowUnits.PixelsOf(FlowUnits.OfPixels(pixels));

    private static Compared Compare(FlowField flow, Moment from, Moment to, RenderScene world, ImageSize image)
    {
        var oracle = new RenderedMotion(from, to, world, moment => FlowHarvest.CameraOf(moment, image));
        HashSet<int> people =
        [
            .. from.Truth.Entities.Where(entity => entity.Class == ObjectClass.Pedestrian).Select(static entity => entity.Handle),
        ];
        var compared = new Compared();
        for (int at = 0; at < flow.Flags.Length; at++)
        {
            FlowFlags flags = flow.At(at);
            if (oracle.HandleAt(at) is not { } handle)
            {
                continue;
            }

            if (people.Contains(handle))
            {
                compared.People++;
                continue;
            }

            compared.Shown++;
            compared.Moved += flags.HasFlag(FlowFlags.Moved) ? 1 : 0;
            if (oracle.MovedAt(at) is not { } moved || oracle.PixelOf(moved) is not { } there)
            {
                continue;
            }

            if (!flags.HasFlag(FlowFlags.Valid))
            {
                compared.Missing++;
                continue;
            }

            bool isInside = there.U >= 0 && there.V >= 0 && there.U < image.Width && there.V < image.Height;
            bool isVisible = isInside && oracle.IsVisible(moved, SlackFraction * oracle.DepthAt(at));
            compared.Judged++;
            compared.Agreeing += isVisible == ((flags & (FlowFlags.Covered | FlowFlags.LeavesPicture)) == 0) ? 1 : 0;
            if (isVisible)
            {
                double u = (at % image.Width) + 0.5 + Written(flow.U[at]);
                double v = (at / image.Width) + 0.5 + Written(flow.V[at]);
                compared.Errors.Add(new Vector2D(u - there.U, v - there.V).Length);
            }
        }

        return compared;
    }

    private sealed class Compared
    {
        public List<double> Errors { get; } = [];

        public int Shown { get; set; }

        public int Moved { get; set; }

        public int People { get; set; }

        public int Missing { get; set; }

        public int Judged { get; set; }

        public int Agreeing { get; set; }
    }
}
