using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Paint;

/// <summary>The paint of a straight road whose pictures are drawn ray by ray, so that every place is known exactly.</summary>
public sealed class PaintOfDrawnRoadTests
{
    private const double HalfStripe = 0.075;

    /// <summary>What drawn pictures leave of an error, metres: a fifth of a pixel at 15 m.</summary>
    private const double Accuracy = 0.01;

    private static readonly PaintRoads s_roads = Roads(0);

    [Fact]
    public void Lines_have_their_place_style_and_colour()
    {
        PaintTable table = Measured(-0.3, 0.4);

        foreach (
            (double offset, MarkingStyle style, MarkingColour colour) in new[]
            {
                (-3.8, MarkingStyle.Solid, MarkingColour.White),
                (0.0, MarkingStyle.DoubleSolid, MarkingColour.Yellow),
                (3.3, MarkingStyle.Dashed, MarkingColour.White),
                (6.6, MarkingStyle.Solid, MarkingColour.White),
            }
        )
        {
            LinePaint[] own = [.. Lines(table).Where(line => Math.Abs(line.FromOffset - offset) < 0.5)];
            Assert.NotEmpty(own);
            Assert.All(
                own,
                line =>
                {
                    Assert.InRange(line.FromOffset, offset - Accuracy, offset + Accuracy);
                    Assert.InRange(line.ToOffset, offset - Accuracy, offset + Accuracy);
                    Assert.Equal((style, colour), (line.Paint.Style, line.Paint.Colour));
                }
            );
        }

        // A link of 10 m has a stretch of each line at most every 5 m, and no other line.
        Assert.All(Lines(table), line => Assert.Contains(new[] { -3.8, 0, 3.3, 6.6 }, offset => Math.Abs(line.FromOffset - offset) < 0.1));
    }

    [Theory]
    [InlineData(0.15)]
    [InlineData(-0.15)]
    public void Lines_on_a_slope_are_found_as_on_level_ground(double slope)
    {
        PaintRoads roads = Roads(slope);
        var evidence = new PaintEvidence();
        Camera camera = CameraAt(0, slope);
        new PaintScanner(roads).Scan(new PaintImage(camera, Picture(camera, slope: slope), new RoadGround(), null), 0, evidence);
        LinePaint[] lines = [.. Lines(PaintTableBuilder.Build(roads, evidence))];

        foreach (double offset in new[] { -3.8, 0, 6.6 })
        {
            LinePaint[] own = [.. lines.Where(line => Math.Abs(line.FromOffset - offset) < 0.5)];
            Assert.NotEmpty(own);
            Assert.All(own, line => Assert.InRange(line.FromOffset, offset - Accuracy, offset + Accuracy));
        }
    }

    [Fact]
    public void Dashes_have_their_length_and_period()
    {
        DashPattern[] dashes = [.. Lines(Measured(0)).Select(line => line.Dashes).OfType<DashPattern>()];

        Assert.NotEmpty(dashes);
        Assert.All(
            dashes,
            pattern =>
            {
                // The ends of a dash are known to a row.
                Assert.InRange(pattern.Period, 8 - PaintRow.Length, 8 + PaintRow.Length);
                Assert.InRange(pattern.Length, 3 - PaintRow.Length, 3 + PaintRow.Length);
            }
        );
    }

    [Fact]
    public void Hidden_ground_stays_unknown()
    {
        Camera camera = CameraAt(0);
        byte[] hidden = new byte[camera.Image.PixelCount];
        Array.Fill(hidden, (byte)1);
        var evidence = new PaintEvidence();

        new PaintScanner(s_roads).Scan(new PaintImage(camera, Picture(camera), new RoadGround(), hidden), 0, evidence);

        Assert.True(evidence.IsEmpty);
        Assert.Empty(PaintTableBuilder.Build(s_roads, evidence).Links);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void What_one_of_three_images_shows_is_left_out()
    {
        var evidence = new PaintEvidence();
        Camera camera = CameraAt(0);
        for (int i = 0; i < 3; i++)
        {
            byte[] picture = i == 0 ? Picture(camera, extraLine: 5) : Picture(camera);
            new PaintScanner(s_roads).Scan(new PaintImage(camera, picture, new RoadGround(), null), i, evidence);
        }

        Assert.DoesNotContain(Lines(PaintTableBuilder.Build(s_roads, evidence)), line => Math.Abs(line.FromOffset - 5) < 0.3);
    }

    private static IEnumerable<LinePaint> Lines(PaintTable table) => table.Links.SelectMany(link => link.Lines);

    private static PaintTable Measured(params double[] carOffsets)
    {
        var evidence = new PaintEvidence();
        for (int i = 0; i < carOffsets.Length; i++)
        {
            Camera camera = CameraAt(carOffsets[i]);
            new PaintScanner(s_roads).Scan(new PaintImage(camera, Picture(camera), new RoadGround(), null), i, evidence);
        }

        return PaintTableBuilder.Build(s_roads, evidence);
    }

    private static PaintRoads Roads(double slope)
    {
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, 21)
                .Select(i => new RoadNode(RoadNode.NoArea, i, new Vector3D(0, 10 * i, 10 * i * slope), "", RoadNodeFlags.None)),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, 20).Select(i => new RoadLink(i, i + 1, 2, 1, 0, RoadLinkFlags.None))];
        return new PaintRoads(new RoadCurves(new RoadNetwork(nodes, links)));
    }

    private static Camera CameraAt(double carOffset, double slope = 0)
    {
        var size = new ImageSize(800, 600);
        return new Camera(
            new Pose(new Vector3D(1.6 + carOffset, 60, 1.6 + (60 * slope)), Axes.FromHeading(1)),
            new CameraIntrinsics(50, size, size.Aspect, nearClip: 0.15, Lens.Ideal)
        );
    }

    /// <summary>Four rays through each pixel are averaged.</summary>
    private static byte[] Picture(Camera camera, double? extraLine = null, double slope = 0)
    {
        byte[] rgb = new byte[3 * camera.Image.PixelCount];
        for (int i = 0; i < camera.Image.PixelCount; i++)
        {
            (int row, int column) = Math.DivRem(i, camera.Image.Width);
            int[] sum = new int[3];
            for (int part = 0; part < 4; part++)
            {
                Ray ray = camera.RayThrough(column + 0.25 + (0.5 * (part & 1)), row + 0.25 + (0.25 * (part & 2)));

                // The ground is z = slope · y.
                double descent = (slope * ray.Direction.Y) - ray.Direction.Z;
                (int red, int green, int blue) =
                    descent > 0 ? GroundAt(ray.At((ray.Origin.Z - (slope * ray.Origin.Y)) / descent), extraLine) : (150, 180, 220);
                (sum[0], sum[1], sum[2]) = (sum[0] + red, sum[1] + green, sum[2] + blue);
            }

            (rgb[3 * i], rgb[(3 * i) + 1], rgb[(3 * i) + 2]) = ((byte)(sum[0] / 4), (byte)(sum[1] / 4), (byte)(sum[2] / 4));
        }

        return rgb;
    }

    /// <summary>
    /// Asphalt from -4.5 to 7.5 m between pale pavements, with lines, a crack at 1.5 m, and a shadow over the left lane.
    /// </summary>
    private static (int Red, int Green, int Blue) GroundAt(Vector3D place, double? extraLine)
    {
        bool IsStripe(double offset) => Math.Abs(place.X - offset) < HalfStripe;
        if (place.X is < -4.5 or > 7.5)
        {
            return (160, 158, 150);
        }

        bool isShaded = place.X < -1.2;
        (int, int, int) Lit(int red, int green, int blue) => isShaded ? (red / 2, green / 2, blue / 2) : (red, green, blue);
        return IsStripe(-0.15) || IsStripe(0.15) ? Lit(200, 160, 60)
            : IsStripe(-3.8) || IsStripe(6.6) || (IsStripe(3.3) && place.Y % 8 < 3) || (extraLine is { } extra && IsStripe(extra))
                ? Lit(200, 200, 196)
            : Math.Abs(place.X - 1.5) < 0.03 ? Lit(30, 30, 30)
            : Lit(80, 80, 82);
    }
}
