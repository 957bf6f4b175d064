using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Depth maps compared with the depth that the renderer draws, which shares no code with rays.</summary>
public sealed class DepthAgainstPictureTests(ITestOutputHelper output)
{
    private const double UnitsPerMetre = 256;

    /// <summary>The renderer's depth has single precision, and a map rounds to half a unit of 4 mm.</summary>
    private const double SampleMetres = 0.01;

    /// <summary>Beyond this the map has no depth, metres; near it rounding decides.</summary>
    private const double MaxMetres = 255;

    private static readonly ImageSize Image = new(800, 450);

    [Theory]
    [InlineData(31)]
    [InlineData(32)]
    [InlineData(33)]
    [InlineData(34)]
    [InlineData(35)]
    [InlineData(36)]
    [Trait("Category", "Heavy")]
    public void Completed_depth_is_that_of_the_renderer(int seed)
    {
        (CapturedFrame frame, RenderTarget picture) = Take(seed, masks: true);
        DepthMaps maps = frame.Part<DepthMaps>()!;
        int[] compared = [.. Enumerable.Range(0, Image.PixelCount).Where(i => picture.Depth[i] < MaxMetres && maps.Completed!.Ids[i] > 0)];
        double ErrorAt(int i) => Math.Abs((maps.Completed!.Ids[i] / UnitsPerMetre) - picture.Depth[i]);
        double[] errors = [.. compared.Select(ErrorAt).Order()];
        double underFraction = compared.Count(i => ErrorAt(i) <= maps.Error!.Ids[i] / UnitsPerMetre) / (double)compared.Length;
        int missing = Enumerable.Range(0, Image.PixelCount).Count(i => picture.Depth[i] < MaxMetres != maps.Completed!.Ids[i] > 0);
        double[] estimates = [.. compared.Select(i => maps.Error!.Ids[i] / UnitsPerMetre).Order()];
        output.WriteLine(
            FormattableString.Invariant($"{seed}: rays {frame.Label.Depth!.RaysCast}, median {errors[errors.Length / 2]:0.0000} m, ")
                + FormattableString.Invariant($"95 % {errors[errors.Length * 95 / 100]:0.000} m, ")
                + FormattableString.Invariant(
                    $"under {underFraction:0.0000}, estimate {estimates[estimates.Length / 2]:0.000} m, missing {missing}"
                )
        );

        // Seeds 11 to 14, with which the mapper was made, have 2 mm, 9 cm and 98 % at worst; other scenes may be twice as bad.
        const double median = 0.005;
        const double ninetyFifth = 0.2;
        const double underEstimate = 0.95;
        const int missingPart = 100;
        Assert.InRange(errors[errors.Length / 2], 0, median);
        Assert.InRange(errors[errors.Length * 95 / 100], 0, ninetyFifth);
        Assert.InRange(underFraction, underEstimate, 1);
        Assert.InRange(missing, 0, Image.PixelCount / missingPart);
        Assert.InRange(frame.Label.Depth!.RaysCast, 1, Image.PixelCount * 3 / 100);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Measured_depth_lies_between_those_of_its_neighbours()
    {
        (CapturedFrame frame, RenderTarget picture) = Take(31, masks: false);
        DepthMaps maps = frame.Part<DepthMaps>()!;
        int measured = 0;
        int wrong = 0;
        for (int row = 1; row + 1 < Image.Height; row++)
        {
            for (int column = 1; column + 1 < Image.Width; column++)
            {
                // A ray may pass anywhere through its pixel, so it meets what the pixel or one beside it shows.
                if (maps.Sparse[column, row] is > 0 and var depth)
                {
                    double[] around =
                    [
                        .. from y in Enumerable.Range(row - 1, 3)
                        from x in Enumerable.Range(column - 1, 3)
                        select (double)picture.Depth[(y * Image.Width) + x],
                    ];
                    measured++;
                    wrong +=
                        depth / UnitsPerMetre >= around.Min() - SampleMetres && depth / UnitsPerMetre <= around.Max() + SampleMetres
                            ? 0
                            : 1;
                }
            }
        }

        // Something thinner than a pixel may be met and not drawn.
        const int thinPart = 500;
        Assert.InRange(measured, Image.PixelCount / 100, Image.PixelCount);
        Assert.InRange(wrong, 0, measured / thinPart);
        Assert.Null(maps.Completed);
        Assert.Equal(maps.Sparse.Ids.Count(value => value > 0), frame.Label.Depth!.MeasuredPixels);
    }

    private static (CapturedFrame Frame, RenderTarget Picture) Take(int seed, bool masks)
    {
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [RigHarvest.Camera("front", new Vector3D(0, 1.7, 1.2), 0, Image)],
            [new RigLidar("top", new Pose(new Vector3D(0.3, 0, 1.6), Axes.Identity), [2, 0, -2, -5, -9, -14, -20], 720, 10, 0.5, 60)]
        );
        var moment = new RigHarvest(rig, seed, new HarvestOptions { Masks = masks, Depth = true });
        return (moment.Frames[0], moment.Game.Render(Image));
    }
}
