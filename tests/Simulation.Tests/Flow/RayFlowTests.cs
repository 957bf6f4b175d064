using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Flow;

/// <summary>
/// Flow from rays and masks, in a game with faults of the real one, compared with the motion of the points that its pictures show.
/// </summary>
public sealed class RayFlowTests(ITestOutputHelper output)
{
    /// <summary>The estimate is meant not to be exceeded at so many of the pixels.</summary>
    private const double MinUnderEstimate = 0.95;

    /// <summary>Rounding of a map to 1/64 pixel along both axes.</summary>
    private const double RoundingPixels = 0.012;

    private static readonly ImageSize Image = new(400, 300);

    private static readonly GameQuirks GameLike = new()
    {
        PictureLagTicks = 2,
        ModelMarginMetres = 0.05,
        HidesMaterials = true,
        PictureNoiseLevels = 1,
        Paused = new FreezeQuirks { CreepTicks = 3 },
    };

    public static TheoryData<int> Seeds => [.. ProofSize.Of([9112], [9111, 9112, 9113])];

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Seeds))]
    public void Errors_of_flow_from_rays_are_within_their_estimates(int seed)
    {
        List<double> errors = [];
        (int within, int withinLabel, int valid, int shown) = (0, 0, 0, 0);
        List<double> labelled = [];
        FlowHarvest harvest = new()
        {
            Seed = seed,
            Image = Image,
            Frames = 4,
            QuirksOfRays = GameLike,
        };
        harvest.Run(
            (maps, label, before, now, world) =>
            {
                Assert.Equal(SemanticsMethod.Rays, label.Method);
                labelled.Add(label.ErrorPixels!.Value);
                Judge(maps.Backward, now, before, world, label.ErrorPixels.Value);
                Judge(maps.Forward, before, now, world, label.ErrorPixels.Value);
            }
        );
        errors.Sort();
        (double ofPixel, double ofLabel) = ((double)within / errors.Count, (double)withinLabel / errors.Count);
        (double median, double high) = (errors[errors.Count / 2], errors[errors.Count * 95 / 100]);
        output.WriteLine(
            FormattableString.Invariant($"{seed}: {errors.Count} pixels, median {median:0.0000}, 95 % {high:0.000} px; ")
                + FormattableString.Invariant($"within the estimate of the pixel {ofPixel:0.0000}, of the label {ofLabel:0.0000}; ")
                + FormattableString.Invariant(
                    $"labels {labelled.Min():0.00} to {labelled.Max():0.00} px; with flow, people apart, {(double)valid / shown:0.0000}"
                )
        );

        Assert.True(errors.Count > Image.PixelCount, "Too few pixels were compared.");
        Assert.InRange(ofPixel, MinUnderEstimate, 1);
        Assert.InRange(ofLabel, MinUnderEstimate, 1);

        void Judge(FlowField flow, Moment from, Moment to, RenderScene world, double errorOfLabel)
        {
            var oracle = new RenderedMotion(from, to, world, moment => FlowHarvest.CameraOf(moment, Image));
            for (int at = 0; at < flow.Flags.Length; at++)
            {
                if (oracle.MovedAt(at) is not { } moved || oracle.PixelOf(moved) is not { } there || flow.At(at).HasFlag(FlowFlags.Person))
                {
                    continue;
                }

                shown++;
                if (!flow.At(at).HasFlag(FlowFlags.Valid))
                {
                    continue;
                }

                valid++;
                double u = (at % Image.Width) + 0.5 + FlowUnits.PixelsOf(FlowUnits.OfPixels(flow.U[at]));
                double v = (at / Image.Width) + 0.5 + FlowUnits.PixelsOf(FlowUnits.OfPixels(flow.V[at]));
                double error = new Vector2D(u - there.U, v - there.V).Length;
                errors.Add(error);
                within += error <= flow.ErrorPixels![at] + RoundingPixels ? 1 : 0;
                withinLabel += error <= errorOfLabel + RoundingPixels ? 1 : 0;
            }
        }
    }
}
