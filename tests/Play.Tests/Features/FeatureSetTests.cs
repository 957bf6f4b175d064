using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Play.Features;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Features;

public sealed class FeatureSetTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("features").FullName;
    private readonly List<string> _told = [];
    private readonly List<string> _done = [];

    private readonly TestClock _clock = new();
    private readonly TestCalls _calls = new();
    private readonly PlayerMessages _messages;

    public FeatureSetTests()
    {
        _messages = new PlayerMessages(_folder, _told.Add, _clock);
    }

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Tick_stops_and_reports_a_failing_feature_and_runs_the_others()
    {
        var set = new FeatureSet(_messages, _calls, _clock, Feature("a"), Feature("b", failsIn: "b ticks"), Feature("c"));

        set.Tick();

        Assert.Equal(["a ticks", "b ticks", "b stops", "c ticks"], _done);
        Assert.Equal("GtaDataHarvester: b failed: no more More in GtaDataHarvester.log.", Assert.Single(_told));
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.Contains(
            "InvalidOperationException",
            File.ReadAllText(Path.Combine(_folder, "GtaDataHarvester.log")),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Do_stops_a_feature_whose_key_fails_even_if_stopping_fails()
    {
        IFeature feature = Feature("a", failsIn: "a stops");
        var set = new FeatureSet(_messages, _calls, _clock, feature);

        set.Do(feature, () => throw new IOException("key"));

        Assert.Equal(["a stops"], _done);
        Assert.Equal(
            [
                "GtaDataHarvester: a failed: key More in GtaDataHarvester.log.",
                "GtaDataHarvester: a failed: no more More in GtaDataHarvester.log.",
            ],
            _told
        );
    }

    [Fact]
    public void Finish_stops_all_in_reverse_order_before_waiting_for_any()
    {
        var set = new FeatureSet(_messages, _calls, _clock, Feature("a"), Feature("b", failsIn: "b stops"), Feature("c"));

        set.Finish();

        Assert.Equal(["c stops", "b stops", "a stops", "a finishes", "b finishes", "c finishes"], _done);
    }

    [Fact]
    public void Try_reports_the_message_of_a_failure_on_another_thread()
    {
        new FeatureSet(_messages, _calls, _clock).Try("a", Task.FromException(new IOException("The disk is full.")).Wait);

        Assert.Equal(["GtaDataHarvester: a failed: The disk is full. More in GtaDataHarvester.log."], _told);
    }

    [Fact]
    public void Log_records_when_a_feature_starts_and_what_it_cost()
    {
        int ticks = 0;
        ScriptedFeature? feature = null;
        feature = new ScriptedFeature(
            "The overlay",
            work =>
            {
                if (work.EndsWith("ticks", StringComparison.Ordinal))
                {
                    ticks++;
                    feature!.IsOn = ticks is > 1 and < 102;
                    _calls.Natives += 20;
                    _calls.Rays += 3;
                    _clock.Milliseconds += ticks == 50 ? 40 : 2;
                }
            }
        );
        var set = new FeatureSet(_messages, _calls, _clock, feature);
        for (int tick = 0; tick < 110; tick++)
        {
            set.Tick();
            _calls.Natives += 1000;
            _clock.Milliseconds += 8;
        }

        string[] lines = [.. LogLines()];
        Assert.Equal(2, lines.Length);
        Assert.Equal("The overlay: on", lines[0]);
        Match figures = Regex.Match(
            lines[1],
            @"^The overlay: off after 101 ticks in 1[.]0 s, 20[.]0 natives per tick, (\d+) rays per second, tick time p50 (.*) "
                + @"ms, p99 (.*) ms$"
        );
        Assert.True(figures.Success, lines[1]);
        Assert.InRange(int.Parse(figures.Groups[1].Value, CultureInfo.InvariantCulture), 285, 310);
        Assert.InRange(double.Parse(figures.Groups[2].Value, CultureInfo.InvariantCulture), 2, 2.1);
        Assert.InRange(double.Parse(figures.Groups[3].Value, CultureInfo.InvariantCulture), 2, 2.1);
    }

    [Fact]
    public void Finish_logs_the_figures_of_a_feature_that_was_on()
    {
        ScriptedFeature? feature = null;
        feature = new ScriptedFeature("The harvest", work => feature!.IsOn = work.EndsWith("ticks", StringComparison.Ordinal));
        var set = new FeatureSet(_messages, _calls, _clock, feature);
        set.Tick();
        set.Finish();

        Assert.Equal(
            [
                "The harvest: on",
                "The harvest: off after 1 tick in 0.0 s, 0.0 natives per tick, 0 rays per second, tick time p50 0.00 ms, p99 0.00 ms",
            ],
            LogLines()
        );
    }

    private IEnumerable<string> LogLines()
    {
        const int lengthOfTheDate = 20;
        _messages.Wait(Timeout.InfiniteTimeSpan);
        return File.ReadLines(Path.Combine(_folder, "GtaDataHarvester.log")).Select(line => line[lengthOfTheDate..]);
    }

    private ScriptedFeature Feature(string name, string? failsIn = null) =>
        new(
            name,
            work =>
            {
                _done.Add(work);
                if (work == failsIn)
                {
                    throw new InvalidOperationException("no more");
                }
            }
        );

    private sealed class ScriptedFeature(string name, Action<string> work) : ILastingFeature
    {
        public string Name => name;

        public bool IsOn { get; set; }

        public bool IsBusy => false;

        public void Tick() => work($"{name} ticks");

        public void Stop() => work($"{name} stops");

        public void Finish() => work($"{name} finishes");
    }
}
