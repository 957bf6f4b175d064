using Harvester.Capture.Events;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Events;

/// <summary>
/// Events that roads decide, on a road to the north with two lanes each way: the middles of its lanes lie 2.7 and 8.1 m to the right of its
/// line for traffic to the north, and as far to the left for traffic to the south.
/// </summary>
public class RoadEventTests
{
    private const double Period = 0.1;
    private const double Left = 2.7;
    private const double Right = 8.1;

    /// <summary>Time at which the readings are off the round numbers of the cases, so that rounding decides nothing.</summary>
    private const double Offset = 0.05;

    private static readonly LaneNetwork Map = MapOfRoad();

    private static readonly Vector3D Min = new(-1, -2, 0);
    private static readonly Vector3D Max = new(1, 2, 1.5);

    /// <summary>Where a car is at a time, how fast it moves to the north, and its heading, degrees from north.</summary>
    private delegate (double X, double Y, double Speed, double Heading) Way(double seconds);

    [Fact]
    public void Car_that_comes_closely_into_the_lane_cuts_in()
    {
        // From 2.7 to 8.1 m in the seconds 1 to 4: over the edge at 5.4 m with its middle at 2.5 s, with its left side (x - 1) at 3.06 s.
        DrivingEvent cut = Assert.Single(Events(North(Right), Changing(12)), each => each.Kind == EventKind.CutIn);

        Assert.Equal((2.55, 3.05), (cut.BeginSeconds, cut.EndSeconds), Close);
        Assert.Equal([7, null], cut.Participants.Select(each => each.Object));

        // 12 m from origin to origin are 8 m from rear to front, at 10 m/s.
        Assert.Equal(8, cut.Measure(EventMeasures.Gap)!.Value, 6);
        Assert.Equal(0.8, cut.Measure(EventMeasures.TimeGap)!.Value, 6);
        Assert.Equal(0, cut.Measure(EventMeasures.ClosingSpeed)!.Value, 6);
    }

    [Fact]
    public void Ego_that_comes_closely_into_the_lane_of_another_cuts_in()
    {
        DrivingEvent cut = Assert.Single(Events(Changing(12), North(Right)), each => each.Kind == EventKind.CutIn);

        Assert.Equal([null, 7], cut.Participants.Select(each => each.Object));
    }

    [Theory]
    [InlineData(25)] // A gap of 21 m is 2.1 s.
    [InlineData(-12)] // Behind the ego.
    public void Car_that_comes_into_the_lane_elsewhere_does_not_cut_in(double ahead) =>
        Assert.DoesNotContain(Events(North(Right), Changing(ahead)), each => each.Kind == EventKind.CutIn);

    [Fact]
    public void Car_whose_follower_comes_into_its_lane_does_not_cut_in() =>
        Assert.DoesNotContain(Events(Changing(-12), North(Right)), each => each.Kind == EventKind.CutIn);

    [Fact]
    public void Car_on_the_other_side_for_a_second_drives_the_wrong_way()
    {
        DrivingEvent wrong = Assert.Single(Events(North(-Left)));

        Assert.Equal((EventKind.WrongWay, 1.05), (wrong.Kind, wrong.BeginSeconds));
        Assert.Equal(10, wrong.Measure(EventMeasures.Speed));
        Assert.Equal(EventEnd.SessionEnd, wrong.End);
    }

    [Theory]
    [InlineData(-2.7, 180, 10)] // Faces its traffic's direction and reverses.
    [InlineData(-2.7, 180, -10)] // Drives on its side.
    [InlineData(-2.7, 0, 1.5)] // Manoeuvres.
    [InlineData(2.7, 0, 10)]
    [InlineData(12, 0, 10)] // On the shoulder.
    public void Car_on_its_side_does_nothing(double x, double heading, double speed) =>
        Assert.Empty(Events(seconds => (x, -90 + (speed * seconds), speed, heading)));

    [Fact]
    public void Car_beyond_the_shoulder_is_off_the_road()
    {
        // The right edge of the road lies 10.8 m beside its line.
        DrivingEvent off = Assert.Single(Events(North(15)));

        Assert.Equal(EventKind.OffRoad, off.Kind);
        Assert.Equal(4.2, off.Measure(EventMeasures.FromRoad)!.Value, 6);
    }

    [Theory]
    [InlineData(0, true)] // Red before it comes.
    [InlineData(4.5, true)] // Red before its front is at the line, at 4.8 s.
    [InlineData(4.9, false)] // Red before its middle is at the line, at 5 s.
    [InlineData(5.1, false)]
    public void Car_that_passes_the_line_after_the_light_is_red_runs_it(double red, bool isRun)
    {
        StopLine line = LineAt(-40);
        List<DrivingEvent> events = Events(
            North(Right),
            null,
            seconds =>
            {
                line.IsRed = seconds >= red;
                line.RedSince = red;
                return [line];
            }
        );

        if (!isRun)
        {
            Assert.Empty(events);
            return;
        }

        DrivingEvent run = Assert.Single(events);
        Assert.Equal(EventKind.RedLightRun, run.Kind);

        // The rear passes the line at 5.2 s.
        Assert.Equal((5.05, 5.15), (run.BeginSeconds, run.EndSeconds), Close);
        Assert.Equal(5.05 - red, run.Measure(EventMeasures.Red)!.Value, 6);
    }

    [Theory]
    [InlineData(0.6, true)]
    [InlineData(0.4, false)]
    public void Car_that_never_stood_before_the_line_runs_the_stop_sign(double slowest, bool isRun)
    {
        // 3 m before the line with its front, it is slow for a moment.
        StopLine line = LineAt(-40);
        line.HasStopSign = true;
        List<DrivingEvent> events = Events(
            seconds => (Right, -90 + (10 * seconds), seconds is > 4.5 and < 4.6 ? slowest : 10, 0),
            null,
            _ => [line]
        );

        DrivingEvent[] runs = [.. events.Where(each => each.Kind == EventKind.StopSignRun)];
        Assert.Equal(isRun ? 1 : 0, runs.Length);
        Assert.All(runs, run => Assert.Equal(slowest, run.Measure(EventMeasures.MinSpeed)));
    }

    /// <summary>Drives to the north at 10 m/s.</summary>
    private static Way North(double x) => seconds => (x, -90 + (10 * seconds), 10, 0);

    /// <summary>Drives to the north at 10 m/s and changes from the left to the right lane.</summary>
    private static Way Changing(double ahead) =>
        seconds => (Left + ((Right - Left) * Math.Clamp((seconds - 1) / 3, 0, 1)), -90 + ahead + (10 * seconds), 10, 0);

    private static bool Close((double Begin, double End) a, (double Begin, double End) b) =>
        Math.Abs(a.Begin - b.Begin) < 1e-6 && Math.Abs(a.End - b.End) < 1e-6;

    private static StopLine LineAt(double y) => new("line", new Vector3D(0, y, 0), new Vector3D(10.8, y, 0), new Vector2D(0, 1));

    /// <summary>The events of seven seconds.</summary>
    private static List<DrivingEvent> Events(Way ego, Way? other = null, Func<double, IReadOnlyList<StopLine>>? lines = null)
    {
        var detector = new EventDetector(entity => entity.Handle, 1);
        for (double seconds = Offset; seconds < 7; seconds += Period)
        {
            double now = Math.Round(seconds, 6);
            (Pose pose, Vector3D velocity) = At(ego, now);
            EntityState[] others =
            [
                .. new[] { other }
                    .OfType<Way>()
                    .Select(way => At(way, now))
                    .Select(at => new EntityState(7, ObjectClass.Car, "blista", at.Pose, Min, Max, at.Velocity)),
            ];
            detector.Observe(
                now,
                new EgoState(1, "asea", pose, velocity) { ModelMin = Min, ModelMax = Max },
                others,
                new RoadScene(Map, lines?.Invoke(now) ?? [])
            );
        }

        detector.Book.CloseAll(EventEnd.SessionEnd, 7);
        return
        [
            .. detector.Book.Take(static _ => true).Select(static each => each.Event).Where(each => each.Kind != EventKind.HardBraking),
        ];
    }

    private static (Pose Pose, Vector3D Velocity) At(Way way, double seconds)
    {
        (double x, double y, double speed, double heading) = way(seconds);
        return (new Pose(new Vector3D(x, y, 0), Axes.FromHeading(heading)), new Vector3D(0, speed, 0));
    }

    private static LaneNetwork MapOfRoad()
    {
        RoadNode[] nodes =
        [
            .. new[] { -200.0, -100, 0, 100 }.Select(
                (y, i) => new RoadNode(RoadNode.NoArea, i, new Vector3D(0, y, 0), "", RoadNodeFlags.None)
            ),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, 3).Select(i => new RoadLink(i, i + 1, 2, 2, 0, RoadLinkFlags.None))];
        var network = new RoadNetwork(nodes, links);
        return new LaneMaps(new RoadCurves(network), new LaneModel(network)).Around(new Vector3D(0, -50, 0))!;
    }
}
