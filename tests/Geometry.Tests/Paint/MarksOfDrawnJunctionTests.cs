using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Paint;

/// <summary>
/// The stop line and crossing of one arm of a junction whose pictures are drawn ray by ray: the bar of the stop line 12.5 m to 12 m before
/// the node, the bars of the crossing 11.4 m to 8.8 m before it.
/// </summary>
public sealed class MarksOfDrawnJunctionTests
{
    /// <summary>A pixel along the road at the far edge of the crossing, metres: (d² + h²) / (f h) with d = 11.7, h = 1.4, f =
    /// 471.</summary>
    private const double Along = 0.21;

    /// <summary>Half of a column, and what the pixels at an end leave open, metres.</summary>
    private const double Across = 0.2;

    /// <summary>The arrow: its tip, the end of its head and of its shaft, metres before the node, and its middle.</summary>
    private const double Tip = -14.5;
    private const double HeadEnd = -15.6;
    private const double ShaftEnd = -17.5;
    private const double ArrowMiddle = 2.7;
    private const double HalfShaft = 0.1;

    private const double FirstBar = -4.9;
    private const double LastBar = 4.5;

    private static readonly PaintRoads s_roads = Roads();

    [Fact]
    public void Marks_have_their_place_and_class()
    {
        PaintTable table = Measured((2.7, true), (1.5, true));

        Assert.Equal(2, table.Marks.Count);
        AssertIs(table.Marks.Single(mark => mark.Mark.Kind == MarkKind.StopLine), (0.3, 5.1), (-12.5, -12));
        AssertIs(table.Marks.Single(mark => mark.Mark.Kind == MarkKind.Crossing), (FirstBar, LastBar + 0.5), (-11.4, -8.8));
        Assert.All(table.Marks, mark => Assert.Equal(2, mark.Images));
        Assert.Empty(table.Links.SelectMany(link => link.Lines));
    }

    [Fact]
    public void Marks_that_one_of_three_images_shows_are_left_out() =>
        Assert.Empty(Measured((2.7, true), (2.7, false), (2.7, false)).Marks);

    [Fact]
    public void Bare_junction_has_no_marks() => Assert.Empty(Measured((2.7, false)).Marks);

    [Theory]
    [InlineData(MarkKind.ArrowStraight, 0.45, 0.45)]
    [InlineData(MarkKind.ArrowLeft, 0.9, 0.1)]
    [InlineData(MarkKind.ArrowRight, 0.1, 0.9)]
    public void Arrows_are_told_by_their_heads(MarkKind kind, double left, double right)
    {
        // The second image is taken 1.5 m before the first, from another lane.
        PaintTable table = Measured(place => IsArrow(place, left, right), (2.7, -22), (1.9, -23.5));

        MarkPaint arrow = Assert.Single(table.Marks);
        Assert.Equal(kind, arrow.Mark.Kind);
        AssertIs(arrow, (ArrowMiddle - left, ArrowMiddle + right), (ShaftEnd, Tip));
    }

    [Theory]
    [InlineData(0.1, 0.1)]
    [InlineData(0.18, 0.1)]
    public void Stripe_without_a_head_is_no_arrow(double left, double right) =>
        Assert.DoesNotContain(
            Measured(place => IsArrow(place, left, right), (2.7, -22), (1.9, -23.5)).Marks,
            mark => mark.Mark.Kind >= MarkKind.ArrowStraight
        );

    private static void AssertIs(MarkPaint mark, (double From, double To) x, (double From, double To) y)
    {
        IReadOnlyList<Vector3D> corners = mark.Mark.Corners;
        Assert.InRange(corners.Min(corner => corner.X), x.From - Across, x.From + Across);
        Assert.InRange(corners.Max(corner => corner.X), x.To - Across, x.To + Across);
        Assert.InRange(corners.Min(corner => corner.Y), y.From - Along, y.From + Along);
        Assert.InRange(corners.Max(corner => corner.Y), y.To - Along, y.To + Along);

        // Counter-clockwise from above: the turns from side to side are to the left.
        for (int i = 0; i < corners.Count; i++)
        {
            Vector3D before = corners[(i + 1) % corners.Count] - corners[i];
            Vector3D after = corners[(i + 2) % corners.Count] - corners[(i + 1) % corners.Count];
            Assert.True((before.X * after.Y) - (before.Y * after.X) > 0);
        }
    }

    private static PaintTable Measured(params (double X, bool IsPainted)[] images)
    {
        var evidence = new PaintEvidence();
        for (int i = 0; i < images.Length; i++)
        {
            bool isPainted = images[i].IsPainted;
            Scan(evidence, i, images[i].X, -20.5, place => isPainted && IsPaint(place));
        }

        return PaintTableBuilder.Build(s_roads, evidence);
    }

    private static PaintTable Measured(Func<Vector3D, bool> isPaint, params (double X, double Y)[] cameras)
    {
        var evidence = new PaintEvidence();
        for (int i = 0; i < cameras.Length; i++)
        {
            Scan(evidence, i, cameras[i].X, cameras[i].Y, isPaint);
        }

        return PaintTableBuilder.Build(s_roads, evidence);
    }

    private static void Scan(PaintEvidence evidence, int image, double x, double y, Func<Vector3D, bool> isPaint)
    {
        var size = new ImageSize(800, 600);
        var camera = new Camera(
            new Pose(new Vector3D(x, y, 1.4), Axes.FromHeading(0)),
            new CameraIntrinsics(65, size, size.Aspect, nearClip: 0.15, Lens.Ideal)
        );
        new PaintScanner(s_roads).Scan(new PaintImage(camera, Picture(camera, isPaint), new RoadGround(), null), image, evidence);
    }

    private static PaintRoads Roads()
    {
        Vector3D[] places = [Vector3D.Zero, new(0, -60, 0), new(0, 60, 0), new(-60, 0, 0), new(60, 0, 0)];
        RoadNode[] nodes = [.. places.Select((place, i) => new RoadNode(RoadNode.NoArea, i, place, "", RoadNodeFlags.None))];
        RoadLink[] links = [.. Enumerable.Range(1, 4).Select(i => new RoadLink(0, i, 1, 1, 0, RoadLinkFlags.None))];
        return new PaintRoads(new RoadCurves(new RoadNetwork(nodes, links)));
    }

    private static byte[] Picture(Camera camera, Func<Vector3D, bool> isPaint)
    {
        byte[] rgb = new byte[3 * camera.Image.PixelCount];
        for (int i = 0; i < camera.Image.PixelCount; i++)
        {
            Ray ray = camera.RayThrough((i % camera.Image.Width) + 0.5, (i / camera.Image.Width) + 0.5);
            bool isPainted = ray.Direction.Z < 0 && isPaint(ray.At(-ray.Origin.Z / ray.Direction.Z));
            Array.Fill(rgb, isPainted ? (byte)200 : (byte)80, 3 * i, 3);
        }

        return rgb;
    }

    /// <summary>A shaft, and a head that is a triangle straight on or to a side.</summary>
    private static bool IsArrow(Vector3D place, double left, double right)
    {
        if (place.Y is < ShaftEnd or > Tip)
        {
            return false;
        }

        double part = place.Y < HeadEnd ? 1 : (Tip - place.Y) / (Tip - HeadEnd);
        double wide =
            place.Y < HeadEnd ? 0
            : left == right ? part
            : 1 - (2 * Math.Abs(part - 0.5));
        double toLeft = place.Y < HeadEnd || left > HalfShaft ? HalfShaft + ((left - HalfShaft) * wide) : HalfShaft;
        double toRight = place.Y < HeadEnd || right > HalfShaft ? HalfShaft + ((right - HalfShaft) * wide) : HalfShaft;
        return place.X > ArrowMiddle - toLeft && place.X < ArrowMiddle + toRight;
    }

    private static bool IsPaint(Vector3D place)
    {
        if (place.Y is > -12.5 and < -12)
        {
            return place.X is > 0.3 and < 5.1;
        }

        const double period = (LastBar - FirstBar) / 8;
        return place.Y is > -11.4 and < -8.8 && place.X is > FirstBar and < LastBar + 0.5 && (place.X - FirstBar) % period < 0.5;
    }
}
