using System.Text.Json.Nodes;
using Harvester.Datasets.Statistics;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Statistics;

public sealed class SessionStatisticsTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Of_a_session_counts_labels_and_objects_by_class()
    {
        _session.Car(2)["id"] = 9;
        _session.Car(2)["occludedFraction"] = 1.0;

        SessionStatistics statistics = SessionStatistics.Of(_session.Open().ReadLabels());

        Assert.Equal((3, 6, 0.5, 2.5), (statistics.Frames, statistics.Labels, statistics.FirstTimeSeconds, statistics.LastTimeSeconds));
        Assert.Equal([ObjectClass.Car, ObjectClass.Pedestrian], statistics.Classes.Keys);
        ClassStatistics cars = statistics.Classes[ObjectClass.Car];
        Assert.Equal((3, 2, 11.0, 11.0), (cars.Labels, cars.Objects, cars.MinMetres, cars.MedianDistanceMetres));
        // Occluded 0.25, 0.25 and 1: the mean is 0.5.
        Assert.Equal(0.5, cars.MeanOccludedFraction);
        Assert.Null(statistics.Classes[ObjectClass.Pedestrian].MeanOccludedFraction);
        Assert.Equal(["clear"], statistics.Weathers);
    }

    [Fact]
    public void Events_are_counted_where_they_open()
    {
        // A near miss that lasts for two frames, and a collision in the third.
        string[] marks =
        [
            """[{"id": 1, "kind": "nearMiss"}]""",
            """[{"id": 1, "kind": "nearMiss"}]""",
            """[{"id": 2, "kind": "collision"}]""",
        ];
        for (int frame = 0; frame < marks.Length; frame++)
        {
            _session.Lines[frame]["events"] = JsonNode.Parse(marks[frame]);
        }

        SessionStatistics statistics = SessionStatistics.Of(_session.Open().ReadLabels());

        Assert.Equal([(EventKind.NearMiss, 1), (EventKind.Collision, 1)], statistics.Events!.Select(each => (each.Key, each.Value)));
    }

    [Fact]
    public void Session_without_events_has_no_counts() => Assert.Null(SessionStatistics.Of(_session.Open().ReadLabels()).Events);

    [Fact]
    public void Of_a_session_counts_KITTI_labels_and_parts_separately()
    {
        // In the last frame the car is the head of a light.
        _session.Car(2)["class"] = "trafficLight";
        _session.Car(2)["id"] = 9;
        _session.Car(2)["parent"] = 2;
        _session.Car(2)["space"] = JsonNode.Parse("""{ "face": 0, "mutcd": null, "facingAngleDegrees": 10, "provenance": "measured" }""");

        SessionStatistics statistics = SessionStatistics.Of(_session.Open().ReadLabels());

        Assert.Equal((6, 5), (statistics.Labels, statistics.LabelsAsKitti));
        Assert.Equal(5.0 / 3, statistics.LabelsAsKittiPerFrame, 12);
        Assert.Equal((1, 1), (statistics.Classes[ObjectClass.TrafficLight].Objects, statistics.Classes[ObjectClass.TrafficLight].Parts));
        Assert.Equal(0, statistics.Classes[ObjectClass.Car].Parts);
    }

    [Fact]
    public void Of_a_session_bins_distances_and_occlusions()
    {
        SessionStatistics statistics = SessionStatistics.Of(_session.Open().ReadLabels());

        // Three pedestrians at 7.8 m, three cars at 11 m; only the cars' occlusion, 0.25, was determined.
        Assert.Equal([3, 3, 0], statistics.Distances.Counts.Take(3));
        Assert.Equal([0, 0, 3, 0, 0, 0, 0, 0, 0, 0], statistics.OccludedFractions.Counts);
    }

    [Fact]
    public void Histogram_has_a_bin_for_what_lies_above()
    {
        Histogram histogram = Histogram.Even(100, 5);
        foreach (double value in (double[])[-1, 99.9, 100, 700])
        {
            histogram.Add(value);
        }

        Assert.Equal([0, 20, 40, 60, 80, 100], histogram.Starts);
        Assert.Equal([1, 0, 0, 0, 1, 2], histogram.Counts);
        Assert.Null(histogram.End);
    }

    [Fact]
    public void Histogram_of_fractions_ends_with_1()
    {
        Histogram histogram = Histogram.Fractions(10);
        histogram.Add(0.95);
        histogram.Add(1);

        Assert.Equal([0, 0, 0, 0, 0, 0, 0, 0, 0, 2], histogram.Counts);
        Assert.Equal(1, histogram.End);
    }

    [Fact]
    public void Histogram_bins_include_their_lower_bound()
    {
        var histogram = new Histogram(0, 64, 256);
        foreach (double value in (double[])[0, 63.9, 64, 255, 256, 1e9])
        {
            histogram.Add(value);
        }

        Assert.Equal([2, 2, 2], histogram.Counts);
        Assert.Throws<ArgumentException>(() => new Histogram(0, 64, 64));
    }

    [Fact]
    public void Of_several_sessions_counts_objects_and_frames_by_condition()
    {
        using var session = new TestSession();

        SessionStatistics statistics = SessionStatistics.Of([session.Open().ReadLabels(), session.Open().ReadLabels()]);

        // Three frames each with one car and one pedestrian; the car of id 1 is another one in the other session.
        Assert.Equal(6, statistics.Frames);
        Assert.Equal((6, 2), (statistics.Classes[ObjectClass.Car].Labels, statistics.Classes[ObjectClass.Car].Objects));
        Assert.Equal(6, statistics.FramesOfHours[13]);
        Assert.Equal(6, statistics.FramesOfWeathers["clear"]);
        // Boxes are 6 and 12 pixels high: all in the first bin of 20. Truncated fractions are 0 and 0.2: the first and the third bin of
        // 0.1.
        Assert.Equal(12, statistics.BoxHeights.Counts[0]);
        // They are 6 and 10 pixels wide: 36 and 120 square pixels.
        Assert.Equal(12, statistics.BoxWidths.Counts[0]);
        Assert.Equal((6, 6, 0), (statistics.BoxAreas.Counts[0], statistics.BoxAreas.Counts[1], statistics.BoxAreas.Counts[2]));
        Assert.Equal((6, 6), (statistics.TruncatedFractions.Counts[0], statistics.TruncatedFractions.Counts[2]));
        Assert.Empty(statistics.Indicators);
    }

    [Fact]
    public void With_widens_a_span_from_its_first_value()
    {
        IndicatorSpan span = default(IndicatorSpan).With(-3).With(2).With(-1);

        Assert.Equal(new IndicatorSpan(3, -3, 2), span);
    }
}
