using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>
/// Markings as the labels have them against the paint in the picture, which the simulation lays by curves of its own. The picture is
/// drawn finer than the labels' image, so that the middle of a line two pixels wide can be told. The road is a loop of straights, arcs
/// and S-bends with a node every five metres.
/// </summary>
public sealed class LaneLinesInPictureTests
{
    /// <summary>What is asked of markings from 5 to 50 m, pixels of the labels' image.</summary>
    private const double LargestErrorPixels = 1.5;

    /// <summary>How far ahead paint may be seen in the gap of a nearer line; markings themselves are told up to 60 m.</summary>
    private const double PaintInView = 200;

    private const int Fineness = 4;
    private static readonly ImageSize Image = new(800, 600);

    [Fact]
    public void Markings_lie_on_the_paint() => Judge(frames: 8);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Markings_lie_on_the_paint_all_around_the_loop() => Judge(frames: 60);

    private static void Judge(int frames)
    {
        var game = new SimulatedGame(new SimulationOptions
        {
            Roads = Loop.Network(),
            RadiusMetres = 600,
            TrafficDensity = 0.2,
            PedestrianDensity = 0,
            IsTimeOfDayFixed = true,
        });
        var curves = new RoadCurves(game.Roads);
        var lanes = new LaneModel(game.Roads);
        var observer = new LaneObserver(curves, lanes);
        RoadMatch? previous = null;
        var errors = new List<double>();
        for (int frame = 0; frame < frames; frame++)
        {
            for (int tick = 0; tick < 60; tick++)
            {
                game.Tick(0.05);
            }

            IWorld world = game.Ports.World;
            EgoState ego = world.ReadEgo();
            LaneObservation seen = observer.Observe(
                ego.Pose.Position, Angles.HeadingDegrees(ego.Pose.Axes.Forward), ego.Velocity.Length, 4, [], previous);
            previous = seen.Match.HasRoad ? seen.Match : null;
            Assert.Equal(LaneStatus.Known, seen.Status);
            errors.AddRange(ErrorsOf(game, seen, RoadStretch.Follow(curves, lanes, seen.Match, 0, PaintInView), ego.Handle));
        }

        Assert.True(errors.Count > 20 * frames, $"Only {errors.Count} points on paint were found in {frames} frames.");
        Assert.InRange(errors.Max(), 0, LargestErrorPixels);
    }

    private static IEnumerable<double> ErrorsOf(SimulatedGame game, LaneObservation seen, RoadStretch inView, int ego)
    {
        CameraState state = game.Ports.World.ReadCamera();
        var camera = new Camera(
            state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Image, state.WindowAspect, state.NearClip, Lens.Ideal));
        RenderTarget picture = game.Render(new ImageSize(Image.Width * Fineness, Image.Height * Fineness));
        var paint = new PaintedLines(picture);
        LaneLineView[] views = Views(seen.Stretch!, 60, game.Ports.Rays);
        LaneLineView[] painted = Views(inView, PaintInView, null);
        foreach (LaneLineView view in views)
        {
            for (int i = 1; i + 1 < view.Points.Count; i++)
            {
                LaneLinePoint point = view.Points[i];
                Vector2D along = view.Points[i + 1].Pixel - view.Points[i - 1].Pixel;
                if (point.IsHidden == false && point.InCamera.Y is >= 5 and <= 50 && along.Length > 0
                    && IsStraight(view, i) && IsAlone(view.Index, point.Pixel, along * (1 / along.Length), painted)
                    && paint.OffsetOfPaint(point.Pixel * Fineness, along * (1 / along.Length)) is { } offset)
                {
                    yield return Math.Abs(offset) / Fineness;
                }
            }
        }

        LaneLineView[] Views(RoadStretch stretch, double reach, IRayCaster? rays) =>
        [
            .. LaneLineTracer.Trace(stretch, seen.Match.LeftEdge + seen.Match.OffsetFromLeftEdge, 0, reach)
                .Select(line => line with { Points = AsPainted(line, stretch.PieceAt(0)!) })
                .SelectMany(line => LaneLineProjector.Project(camera, line, ego, rays)),
        ];
    }

    /// <summary>Whether no other marking, and no other part of this one, runs so near in the picture that its paint could be taken for this one's.</summary>
    private static bool IsAlone(int index, Vector2D pixel, Vector2D along, LaneLineView[] painted)
    {
        const double apart = 12;
        return painted
            .SelectMany(other => other.Points.Zip(other.Points.Skip(1), (from, to) => (other.Index, From: from.Pixel, To: to.Pixel)))
            .All(piece => piece.Index == index
                ? !Crosses(pixel, along, apart, piece.From, piece.To)
                : DistanceToPiece(pixel, piece.From, piece.To) > apart);
    }

    /// <summary>Whether a piece crosses the square to a line at a point, neither further from the point than that nor the line itself.</summary>
    private static bool Crosses(Vector2D point, Vector2D along, double furthest, Vector2D from, Vector2D to)
    {
        const double itself = 1;
        double a = (from - point).Dot(along);
        double b = (to - point).Dot(along);
        if (a * b > 0 || a == b)
        {
            return false;
        }

        Vector2D crossing = from + ((to - from) * (a / (a - b)));
        return (crossing - point).Length > itself && (crossing - point).Length < furthest;
    }

    private static double DistanceToPiece(Vector2D point, Vector2D from, Vector2D to)
    {
        Vector2D along = to - from;
        double square = along.Dot(along);
        double share = square > 0 ? Math.Clamp((point - from).Dot(along) / square, 0, 1) : 0;
        return (from + (along * share) - point).Length;
    }

    /// <summary>Whether the marking runs straight here in the picture: at the turning point of a bend paint is no measure across the line.</summary>
    private static bool IsStraight(LaneLineView view, int i)
    {
        const double largestTurn = 0.1;
        Vector2D before = view.Points[i].Pixel - view.Points[i - 1].Pixel;
        Vector2D after = view.Points[i + 1].Pixel - view.Points[i].Pixel;
        return Math.Abs(Math.Atan2(before.Cross(after), before.Dot(after))) < largestTurn;
    }

    /// <summary>Where the simulation paints a marking: edges a quarter of a metre within the carriageway; the middle of a double line is the marking.</summary>
    private static Vector3D[] AsPainted(LaneLine line, StretchPiece piece)
    {
        int lanes = piece.Section.LaneCount;
        int oncomingEdge = piece.Oncoming is { } other ? -other.Section.LaneCount - 1 : 0;
        double inward = line.Index == lanes ? -0.25 : line.Index == oncomingEdge ? 0.25 : 0;
        return Moved(line.Points, inward);
    }

    /// <summary>Moves points to the right, and up to where the simulation's paint lies: a centimetre above the asphalt.</summary>
    private static Vector3D[] Moved(IReadOnlyList<Vector3D> points, double right) =>
    [
        .. points.Select((point, i) =>
        {
            Vector3D along = points[Math.Min(i + 1, points.Count - 1)] - points[Math.Max(i - 1, 0)];
            double length = Math.Sqrt((along.X * along.X) + (along.Y * along.Y));
            return point + new Vector3D(along.Y / length * right, -along.X / length * right, 0.01);
        }),
    ];
}
