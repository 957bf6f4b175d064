using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;

namespace Harvester.Geometry.Tests.Motion;

/// <summary>Flow in worlds whose motion has a closed form.</summary>
public sealed class FlowMakerTests
{
    /// <summary>What the issue allows, pixels; the numbers of a map alone round by 1/128 along each axis.</summary>
    private const double MaxErrorPixels = 0.02;

    private static readonly ImageSize Image = new(160, 120);

    /// <summary>A camera without distortion: fx = fy = 60 / tan(25 degrees) for 120 rows and 50 degrees.</summary>
    private static readonly CameraIntrinsics Ideal = new(50, Image, 4.0 / 3, 0.1, Lens.Ideal);

    private static readonly double Focal = 60 / Math.Tan(25 * Math.PI / 180);

    private static readonly Pose North = new(Vector3D.Zero, Axes.Identity);

    [Fact]
    public void Camera_that_moves_to_the_right_sees_a_wall_move_to_the_left()
    {
        // A wall at depth 10 m; the camera moves 0.3 m to the right from the first picture to the second: u changes by -f · 0.3 / 10.
        FlowField flow = Flow(North, new Pose(new Vector3D(0.3, 0, 0), Axes.Identity), WallDepths(10), WallDepths(10));

        AssertFlow(flow, (_, _) => (-Focal * 0.3 / 10, 0));
    }

    [Fact]
    public void Camera_that_drives_forward_sees_points_leave_the_centre()
    {
        // A wall at 10 m, then at 8 m: distances from the principal point (80, 60) grow by 10 / 8.
        FlowField flow = Flow(North, new Pose(new Vector3D(0, 2, 0), Axes.Identity), WallDepths(10), WallDepths(8));

        AssertFlow(flow, (column, row) => ((column + 0.5 - 80) * 0.25, (row + 0.5 - 60) * 0.25));
    }

    [Fact]
    public void Camera_that_turns_moves_the_sky_whatever_its_depth()
    {
        // Heading is counter-clockwise: a point at the angle a to the right of the axis, tan a = (u - 80) / f, is at a + 3 degrees after a
        // turn of 3 degrees to the left. The depth along the axis changes from 1 to cos(a + t) / cos a, and v with its inverse.
        var turned = new Pose(Vector3D.Zero, Axes.FromHeading(3));
        FlowField flow = Flow(North, turned, WallDepths(float.PositiveInfinity), WallDepths(float.PositiveInfinity));
        double turn = 3 * Math.PI / 180;

        AssertFlow(
            flow,
            (column, row) =>
            {
                double angle = Math.Atan((column + 0.5 - 80) / Focal);
                double u = 80 + (Focal * Math.Tan(angle + turn));
                double v = 60 + ((row + 0.5 - 60) * Math.Cos(angle) / Math.Cos(angle + turn));
                return (u - column - 0.5, v - row - 0.5);
            }
        );
        Assert.All(flow.Flags, flags => Assert.True(((FlowFlags)flags).HasFlag(FlowFlags.Infinite)));
    }

    [Fact]
    public void Camera_that_rolls_turns_the_picture_about_its_centre()
    {
        // A roll of the camera by t turns the picture by -t about the principal point; pixels are square.
        var rolled = new Pose(Vector3D.Zero, Axes.FromEuler(new EulerAngles(0, 5, 0)));
        (double sine, double cosine) = (Math.Sin(5 * Math.PI / 180), Math.Cos(5 * Math.PI / 180));
        FlowField flow = Flow(North, rolled, WallDepths(7), WallDepths(7));

        // Right becomes (cos t, 0, -sin t): x' = x cos t - z sin t with z up, so with y down u' = u cos t + v sin t, v' = v cos t - u sin
        // t.
        AssertFlow(
            flow,
            (column, row) =>
            {
                (double u, double v) = (column + 0.5 - 80, row + 0.5 - 60);
                return ((u * cosine) + (v * sine) - u, (v * cosine) - (u * sine) - v);
            }
        );
    }

    [Fact]
    public void Box_that_turns_carries_the_pixels_of_its_face()
    {
        // A box whose face is at depth 10 m turns by 2 degrees to the left about the vertical axis through (0, 10) and moves 0.5 m to the
        // right: x' = x cos t + 0.5 and y' = 10 + x sin t of the points (x, 10) of its face.
        const int box = 7;
        double turn = 2 * Math.PI / 180;
        var from = new Pose(new Vector3D(0, 10, 0), Axes.Identity);
        var to = new Pose(new Vector3D(0.5, 10, 0), Axes.FromHeading(2));
        int[] entities = Enumerable.Repeat(box, Image.PixelCount).ToArray();
        var first = new SurfaceMap(North, new PixelLines(Ideal), WallDepths(10), entities);
        var second = new SurfaceMap(North, new PixelLines(Ideal), WallDepths(10), entities);

        FlowField flow = new FlowMaker(first, second, _ => BodyMotion.Rigid(from, to), hasMotion: true).Make();

        AssertFlow(
            flow,
            (column, row) =>
            {
                (double x, double z) = ((column + 0.5 - 80) / Focal * 10, -(row + 0.5 - 60) / Focal * 10);
                (double xAfter, double depth) = ((x * Math.Cos(turn)) + 0.5, 10 + (x * Math.Sin(turn)));
                return (80 + (Focal * xAfter / depth) - column - 0.5, 60 - (Focal * z / depth) - row - 0.5);
            }
        );

        // The motion map leads from the other moment to this one, so that it is the opposite: -(0.5 + x (cos t - 1)), 0, -x sin t.
        int at = (60 * Image.Width) + 120;
        double across = 40.5 / Focal * 10;
        Assert.Equal(-(0.5 + (across * (Math.Cos(turn) - 1))), flow.Motion![3 * at], 1e-5);
        Assert.Equal(0, flow.Motion[(3 * at) + 1], 1e-5);
        Assert.Equal(-across * Math.Sin(turn), flow.Motion[(3 * at) + 2], 1e-5);
        Assert.True(flow.At(at).HasFlag(FlowFlags.Moved));
    }

    [Fact]
    public void Lens_bends_both_pictures()
    {
        // The wall at 10 m moves by 0.3 m through a lens with k1 = -0.2: r' = r (1 - 0.2 r²) of normalised coordinates.
        var bent = new CameraIntrinsics(50, Image, 4.0 / 3, 0.1, new Lens(1, 0, 0, -0.2, 0));
        var lines = new PixelLines(bent);
        var first = new SurfaceMap(North, lines, WallDepths(10), new int[Image.PixelCount]);
        var second = new SurfaceMap(new Pose(new Vector3D(0.3, 0, 0), Axes.Identity), lines, WallDepths(10), new int[Image.PixelCount]);

        FlowField flow = new FlowMaker(first, second, _ => default, hasMotion: false).Make();

        AssertFlow(
            flow,
            (column, row) =>
            {
                (double shownX, double shownY) = ((column + 0.5 - 80) / Focal, (row + 0.5 - 60) / Focal);

                // The radius before the lens by fixed-point iteration, r = r' / (1 - 0.2 r²), which converges for r' < 0.8.
                double shown = Math.Sqrt((shownX * shownX) + (shownY * shownY));
                double radius = shown;
                for (int i = 0; i < 100; i++)
                {
                    radius = shown / (1 - (0.2 * radius * radius));
                }

                double scale = shown > 0 ? radius / shown : 1;
                (double x, double y) = ((shownX * scale) - 0.03, shownY * scale);
                double bend = 1 - (0.2 * ((x * x) + (y * y)));
                return (80 + (Focal * x * bend) - column - 0.5, 60 + (Focal * y * bend) - row - 0.5);
            }
        );
    }

    [Fact]
    public void Point_behind_a_surface_is_covered_and_one_outside_leaves()
    {
        // The camera moves 1 m to the right; the wall at 10 m moves by -f / 10 = -12.87 pixels. In the second picture the columns below 60
        // show an object at 5 m.
        float[] after = [.. Enumerable.Range(0, Image.PixelCount).Select(at => at % Image.Width < 60 ? 5f : 10f)];
        int[] entities = [.. after.Select(depth => depth < 6 ? 3 : 0)];
        var lines = new PixelLines(Ideal);
        var first = new SurfaceMap(North, lines, WallDepths(10), new int[Image.PixelCount]);
        var second = new SurfaceMap(new Pose(new Vector3D(1, 0, 0), Axes.Identity), lines, after, entities);

        FlowField flow = new FlowMaker(first, second, _ => default, hasMotion: false).Make();

        for (int column = 0; column < Image.Width; column++)
        {
            double there = column + 0.5 - (Focal / 10);
            FlowFlags expected =
                there < 0 ? FlowFlags.Valid | FlowFlags.LeavesPicture
                : there < 60 ? FlowFlags.Valid | FlowFlags.Covered
                : FlowFlags.Valid;
            Assert.Equal(expected, flow.At((33 * Image.Width) + column));
        }
    }

    [Fact]
    public void Slanted_ground_does_not_cover_itself()
    {
        // Ground 1.5 m below the camera: depth f · 1.5 / (v - 60). Between rows it changes by up to half near the horizon.
        float[] ground =
        [
            .. Enumerable
                .Range(0, Image.PixelCount)
                .Select(at => at / Image.Width >= 60 ? (float)(Focal * 1.5 / ((at / Image.Width) + 0.5 - 60)) : float.PositiveInfinity),
        ];
        var moved = new Pose(new Vector3D(0.05, 0.7, 0), Axes.FromHeading(0.5));

        FlowField flow = Flow(North, moved, ground, ground);

        Assert.DoesNotContain(flow.Flags.Skip(62 * Image.Width), flags => ((FlowFlags)flags).HasFlag(FlowFlags.Covered));
    }

    [Fact]
    public void People_and_what_is_not_known_have_no_flow()
    {
        int[] entities = [.. Enumerable.Range(0, Image.PixelCount).Select(at => at % 3)];
        float[] depths = [.. Enumerable.Range(0, Image.PixelCount).Select(at => at % 3 == 0 && at % 2 == 0 ? float.NaN : 10f)];
        var map = new SurfaceMap(North, new PixelLines(Ideal), depths, entities);

        FlowField flow = new FlowMaker(
            map,
            map,
            entity => new BodyMotion(entity == 1 ? BodyMotionKind.Person : BodyMotionKind.Unknown),
            hasMotion: true
        ).Make();

        Assert.Equal(FlowFlags.Unknown, flow.At(0));
        Assert.Equal(FlowFlags.Person, flow.At(1));
        Assert.Equal(FlowFlags.Unknown, flow.At(2));
        Assert.Equal(FlowFlags.Valid, flow.At(3));
        Assert.True(float.IsNaN(flow.Motion![3]));
        Assert.Equal(0, flow.Motion[9]);
    }

    [Fact]
    public void Point_behind_the_other_camera_has_no_flow()
    {
        FlowField flow = Flow(North, new Pose(new Vector3D(0, 12, 0), Axes.Identity), WallDepths(10), WallDepths(10));

        Assert.All(flow.Flags, flags => Assert.Equal(FlowFlags.LeavesPicture, (FlowFlags)flags));
    }

    [Fact]
    public void Error_of_a_depth_becomes_an_error_of_the_flow()
    {
        // A wall at 10 m known to 1 m, the camera moves 0.3 m to the right: the flow is -f · 0.3 / d, which is farthest from its value at
        // d = 9: f · 0.3 · (1/9 - 1/10).
        var lines = new PixelLines(Ideal);
        float[] errors = [.. Enumerable.Repeat(1f, Image.PixelCount)];
        var first = new SurfaceMap(North, lines, WallDepths(10), new int[Image.PixelCount]) { ErrorMetres = errors };
        var second = new SurfaceMap(new Pose(new Vector3D(0.3, 0, 0), Axes.Identity), lines, WallDepths(10), new int[Image.PixelCount]);

        FlowField flow = new FlowMaker(first, second, _ => default, hasMotion: false).Make();

        Assert.All(flow.ErrorPixels!, error => Assert.Equal(Focal * 0.3 * ((1 / 9.0) - (1 / 10.0)), error, 1e-4));
    }

    [Fact]
    public void Error_of_the_whole_depth_reaches_from_half_of_it_to_infinity()
    {
        // At 10 m ± 10 m the flow of f · 0.3 / 10 to the left may be that of 5 m, twice as much, or none.
        var lines = new PixelLines(Ideal);
        float[] errors = [.. Enumerable.Repeat(10f, Image.PixelCount)];
        var first = new SurfaceMap(North, lines, WallDepths(10), new int[Image.PixelCount]) { ErrorMetres = errors };
        var second = new SurfaceMap(new Pose(new Vector3D(0.3, 0, 0), Axes.Identity), lines, WallDepths(10), new int[Image.PixelCount]);

        FlowField flow = new FlowMaker(first, second, _ => default, hasMotion: false).Make();

        Assert.All(flow.ErrorPixels!, error => Assert.Equal(Focal * 0.3 / 10, error, 1e-4));
    }

    [Fact]
    public void Pictures_of_two_sizes_are_refused()
    {
        var small = new CameraIntrinsics(50, new ImageSize(80, 60), 4.0 / 3, 0.1, Lens.Ideal);
        var first = new SurfaceMap(North, new PixelLines(Ideal), WallDepths(10), new int[Image.PixelCount]);
        var second = new SurfaceMap(North, new PixelLines(small), new float[4800], new int[4800]);

        Assert.Throws<ArgumentException>(() => new FlowMaker(first, second, _ => default, hasMotion: false));
    }

    private static FlowField Flow(Pose from, Pose to, float[] before, float[] after)
    {
        var lines = new PixelLines(Ideal);
        var entities = new int[Image.PixelCount];
        return new FlowMaker(
            new SurfaceMap(from, lines, before, entities),
            new SurfaceMap(to, lines, after, entities),
            _ => default,
            hasMotion: true
        ).Make();
    }

    private static float[] WallDepths(float metres) => [.. Enumerable.Repeat(metres, Image.PixelCount)];

    /// <summary>The flow that is written, which is rounded, is the expected one.</summary>
    private static void AssertFlow(FlowField flow, Func<int, int, (double U, double V)> expected)
    {
        for (int at = 0; at < flow.Flags.Length; at++)
        {
            (double u, double v) = expected(at % Image.Width, at / Image.Width);
            Assert.True(flow.At(at).HasFlag(FlowFlags.Valid));
            double writtenU = FlowUnits.PixelsOf(FlowUnits.OfPixels(flow.U[at]));
            double writtenV = FlowUnits.PixelsOf(FlowUnits.OfPixels(flow.V[at]));
            Assert.InRange(new Vector2D(writtenU - u, writtenV - v).Length, 0, MaxErrorPixels);
        }
    }
}
