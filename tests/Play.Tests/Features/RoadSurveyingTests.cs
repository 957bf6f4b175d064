using System.Diagnostics;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Features;
using Harvester.Play.Surveys.Roads;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Features;

public sealed class RoadSurveyingTests : IDisposable
{
    private static readonly TimeSpan HangingAfter = TimeSpan.FromMinutes(1);
    private readonly string _folder = Directory.CreateTempSubdirectory("surveying").FullName;
    private readonly List<string> _told = [];
    private readonly PlayerMessages _messages;
    private readonly TestClock _clock = new();
    private readonly GrowingRoads _roads = new();

    public RoadSurveyingTests()
    {
        _messages = new PlayerMessages(_folder, _told.Add, _clock);
    }

    private string FilePath => Path.Combine(_folder, "new", "roads.csv");

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Stop_saves_the_roads_and_the_next_survey_resumes_from_them()
    {
        RoadSurveying first = Surveying(new FakeRoadSource(Road()));
        first.Toggle();
        Until(first, () => first.Line!.StartsWith("SURVEY  2 nodes  1 links  0 waiting", StringComparison.Ordinal));
        first.Finish();
        Assert.Null(first.Line);
        Assert.Single(RoadSurveyFile.Load(FilePath)!.Links);

        RoadSurveying second = Surveying(new FakeRoadSource(new RoadNetwork([Node(5, 900)], [])));
        second.Start();
        Until(second, () => second.Line!.StartsWith("SURVEY  2 nodes  1 links", StringComparison.Ordinal));
    }

    [Fact]
    public void Tick_saves_twice_a_minute_even_if_only_edges_are_new()
    {
        // The edges of a link are queried in the two ticks after the one that finds it.
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()));
        surveying.Start();
        Until(surveying, () => surveying.Line!.Contains("1 links", StringComparison.Ordinal));
        _clock.Milliseconds += 31_000;
        Until(surveying, () => EdgesInFile() == 2);
        Until(surveying, () => surveying.Line!.Contains("0 waiting", StringComparison.Ordinal));

        _clock.Milliseconds += 31_000;
        Until(surveying, () => EdgesInFile() == 4);

        int? EdgesInFile() => surveying.IsBusy ? null : RoadSurveyFile.Load(FilePath)?.Edges.Count;
    }

    [Fact]
    public void Tick_offers_roads_at_once_and_calibrated_ones_seconds_later()
    {
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()) { LaneWidth = 4.5 });
        surveying.Start();

        // All edges are found, and those that were offered first are from before: the clock has stood.
        Until(surveying, () => Width() is not null && surveying.Line!.Contains("0 waiting", StringComparison.Ordinal));
        Assert.Equal(RoadGeometry.LaneWidth, Width());

        _clock.Milliseconds += 6_000;
        Until(surveying, () => Width() == 4.5);
    }

    [Fact]
    public void Tick_with_roads_from_another_source_offers_none()
    {
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()), givesLanes: false);
        surveying.Start();
        Until(surveying, () => surveying.Line!.StartsWith("SURVEY  2 nodes  1 links  0 waiting", StringComparison.Ordinal));

        Assert.False(_roads.IsPreparing);
        Assert.Null(Width());
    }

    [Fact]
    public void Tick_with_a_damaged_file_fails_and_leaves_it_unchanged()
    {
        Directory.CreateDirectory(Path.GetDirectoryName(FilePath)!);
        File.WriteAllText(FilePath, "my notes\n");
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()));
        surveying.Start();

        InvalidDataException failure = Assert.Throws<InvalidDataException>(() => Until(surveying, () => false));
        surveying.Finish();

        Assert.Contains("roads.csv: line 1", failure.Message, StringComparison.Ordinal);
        Assert.Equal("my notes\n", File.ReadAllText(FilePath));
    }

    [Fact]
    public void Tick_and_Finish_report_a_failed_save_after_the_survey()
    {
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()));
        surveying.Start();
        Until(surveying, () => surveying.Line!.Contains("1 links", StringComparison.Ordinal));
        File.WriteAllText(Path.GetDirectoryName(FilePath)!, "a file where the folder should be");

        surveying.Stop();
        WaitForDisk(surveying);
        Assert.Throws<IOException>(surveying.Tick);
        surveying.Tick();
        surveying.Start();
        surveying.Tick();
        Assert.Throws<IOException>(surveying.Finish);
    }

    [Fact]
    public void Tick_starts_it_when_lanes_are_needed_unless_switched_off()
    {
        bool areWanted = false;
        RoadSurveying surveying = Surveying(new FakeRoadSource(Road()), areLanesWanted: () => areWanted);
        surveying.Tick();
        Assert.False(surveying.IsOn);

        areWanted = true;
        surveying.Tick();
        Assert.True(surveying.IsOn);
        surveying.Toggle();
        surveying.Tick();
        Assert.False(surveying.IsOn);
    }

    private RoadSurveying Surveying(FakeRoadSource game, bool givesLanes = true, Func<bool>? areLanesWanted = null) =>
        new(game, () => new Vector3D(100, 200, 0), FilePath, _roads, _messages, _clock)
        {
            GivesLanes = givesLanes,
            AreLanesWanted = areLanesWanted ?? (() => false),
        };

    /// <summary>How wide the lanes are that are offered at the road.</summary>
    private double? Width() => _roads.Near(default)?.Lanes.Observe(new Vector3D(102, 250, 0), 0, 10, 4, [], null).Section?.LaneWidth;

    private static void Until(RoadSurveying surveying, Func<bool> isSo)
    {
        var hanging = Stopwatch.StartNew();
        while (!(surveying.Line is not null && isSo()))
        {
            Assert.True(hanging.Elapsed < HangingAfter);
            WaitForDisk(surveying);
            surveying.Tick();
        }
    }

    private static void WaitForDisk(RoadSurveying surveying)
    {
        while (surveying.IsBusy)
        {
            Thread.Sleep(1);
        }
    }

    private static RoadNetwork Road() => new([Node(0, 180.125), Node(1, 320.125)], [new RoadLink(0, 1, 1, 1, 0, RoadLinkFlags.None)]);

    private static RoadNode Node(int number, double north) => new(7, number, new Vector3D(100.125, north, 0), "", RoadNodeFlags.None);
}
