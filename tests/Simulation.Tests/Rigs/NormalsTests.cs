using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Maps of normals compared with the surfaces that the renderer's depth shows, and maps from rays with exact ones.</summary>
public sealed class NormalsTests(ITestOutputHelper output)
{
    /// <summary>Angles of a map of 8 bits: half a step of 1/127 in each of three components.</summary>
    private const double RoundingDegrees = 0.4;

    /// <summary>
    /// Inverse depth is linear along a row or column of a plane; single precision, 1e-7, is far below this part of it, and edges above.
    /// </summary>
    private const double MaxBend = 1e-4;

    /// <summary>A normal from the depths of neighbouring pixels is less exact far away and where a plane is seen from its edge.</summary>
    private const double DifferenceDegrees = 2;

    /// <summary>Cosine by which a surface seen from its edge may seem to turn away: rounding, and the width of a pixel.</summary>
    private const double EdgeCosine = 0.02;

    /// <summary>Normals this close are those of the same face.</summary>
    private const double SameFaceDegrees = 5;

    /// <summary>The part of the pixels that must have the normal of their face; others lie near edges and on round bodies.</summary>
    private const double MinSameFace = 0.9;

    /// <summary>Surfaces beyond it are smaller than the grid of rays, metres.</summary>
    private const double MaxMetres = 100;

    private static readonly ImageSize Image = new(400, 300);

    /// <summary>Depth has no normal across an edge; where a pixel and its four neighbours lie in one plane, it has.</summary>
    [Fact]
    public void Exact_normals_are_those_of_the_depth()
    {
        List<double> angles = [];
        Harvest(
            51,
            isExact: true,
            (map, camera, picture) =>
            {
                for (int row = 1; row < Image.Height - 1; row += 3)
                {
                    for (int column = 1; column < Image.Width - 1; column += 3)
                    {
                        int at = (row * Image.Width) + column;
                        float left = picture.Depth[at - 1],
                            right = picture.Depth[at + 1];
                        float above = picture.Depth[at - Image.Width],
                            below = picture.Depth[at + Image.Width],
                            here = picture.Depth[at];
                        if (
                            !float.IsFinite(left + right + above + below)
                            || Math.Abs((2 / here) - (1 / left) - (1 / right)) * here > MaxBend
                            || Math.Abs((2 / here) - (1 / above) - (1 / below)) * here > MaxBend
                        )
                        {
                            continue;
                        }

                        Vector3D across = Point(camera, column + 1, row, right) - Point(camera, column - 1, row, left);
                        Vector3D down = Point(camera, column, row + 1, below) - Point(camera, column, row - 1, above);
                        double angle = AngleDegrees(across.Cross(down), Vector(map, at));
                        angles.Add(Math.Min(angle, 180 - angle));
                    }
                }
            }
        );

        Assert.True(angles.Count > 5_000, $"Only {angles.Count} pixels were compared.");
        double[] ordered = [.. angles.Order()];
        Assert.InRange(ordered[ordered.Length / 2], 0, RoundingDegrees);
        Assert.InRange(ordered[ordered.Length * 9 / 10], 0, DifferenceDegrees);
    }

    [Fact]
    public void Normals_face_the_camera_and_the_sky_has_none()
    {
        Harvest(
            52,
            isExact: true,
            (map, camera, picture) =>
            {
                for (int at = 0; at < Image.PixelCount; at++)
                {
                    bool isSky = float.IsPositiveInfinity(picture.Depth[at]);
                    Assert.Equal(isSky, map.Bytes.AsSpan(at * 3, 3).IndexOfAnyExcept((byte)0) < 0);
                    Vector3D seen = Point(camera, at % Image.Width, at / Image.Width, 1);
                    Assert.True(isSky || Vector(map, at).Dot(seen.Normalized()) < EdgeCosine, $"Pixel {at} shows the back of a surface.");
                }
            }
        );
    }

    [Theory]
    [InlineData(53)]
    [InlineData(54)]
    [InlineData(55)]
    [Trait("Category", "Heavy")]
    public void Normals_from_rays_are_near_the_exact_ones(int seed)
    {
        PixelBuffer? exact = null;
        Harvest(seed, isExact: true, (map, _, _) => exact = map);
        Harvest(
            seed,
            isExact: false,
            (map, _, picture) =>
            {
                int[] compared = [.. Enumerable.Range(0, Image.PixelCount).Where(at => picture.Depth[at] < MaxMetres)];
                double[] angles =
                [
                    .. compared
                        .Where(at => map.Bytes.AsSpan(at * 3, 3).IndexOfAnyExcept((byte)0) >= 0)
                        .Select(at => AngleDegrees(Vector(map, at), Vector(exact!, at)))
                        .Order(),
                ];
                double within = angles.Count(angle => angle < SameFaceDegrees) / (double)compared.Length;
                output.WriteLine(
                    FormattableString.Invariant(
                        $"{seed}: median {angles[angles.Length / 2]:0.00} degrees, within 5 degrees {within:0.0000}, "
                    ) + $"of {compared.Length} pixels"
                );

                Assert.InRange(angles[angles.Length / 2], 0, 2 * RoundingDegrees);
                Assert.InRange(within, MinSameFace, 1);
            }
        );
    }

    private static void Harvest(int seed, bool isExact, Action<PixelBuffer, Camera, RenderTarget> judge)
    {
        var game = new Harvester.Simulation.Game.SimulatedGame(new SimulationOptions { Seed = seed });
        GamePorts ports = isExact ? game.Ports : game.Ports with { Surfaces = null };
        HarvestOptions options = new()
        {
            Image = Image,
            MaxFrames = 1,
            Masks = true,
            Channels = new ChannelKeys(["normals"]),
        };
        LabelledTown.Harvest(
            game,
            ports,
            options,
            (frame, truth) =>
            {
                MapLabel label = frame.Label.Channels.Get<MapLabel>()!;
                Assert.Equal(("normals/00000000.png", isExact ? SemanticsMethod.Exact : SemanticsMethod.Rays), (label.File, label.Method));
                judge(frame.Part<MapPart>()!.Colours!, frame.Label.Camera.ToCamera(), game.Render(Image));
            }
        );
    }

    /// <summary>A point at a depth in the camera's frame: right, down, forward.</summary>
    private static Vector3D Point(Camera camera, int column, int row, double depth) =>
        new(
            (column + 0.5 - camera.Intrinsics.Cx) / camera.Intrinsics.Fx * depth,
            (row + 0.5 - camera.Intrinsics.Cy) / camera.Intrinsics.Fy * depth,
            depth
        );

    private static Vector3D Vector(PixelBuffer map, int at) =>
        new Vector3D(map.Bytes[at * 3] - 128, map.Bytes[(at * 3) + 1] - 128, map.Bytes[(at * 3) + 2] - 128).Normalized();

    private static double AngleDegrees(Vector3D one, Vector3D other) =>
        Math.Acos(Math.Clamp(one.Normalized().Dot(other.Normalized()), -1, 1)) * 180 / Math.PI;
}
