using Harvester.Capture.Playing;

namespace Harvester.Capture.Tests.Playing;

public sealed class FeatureSetTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("features").FullName;
    private readonly List<string> _told = [];
    private readonly List<string> _done = [];

    private readonly PlayerMessages _messages;

    public FeatureSetTests()
    {
        _messages = new PlayerMessages(_folder, _told.Add, new TestClock());
    }

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Tick_stops_and_tells_a_feature_that_fails_and_lets_the_others_work()
    {
        var set = new FeatureSet(_messages, Feature("a"), Feature("b", failsIn: "b ticks"), Feature("c"));

        set.Tick();

        Assert.Equal(["a ticks", "b ticks", "b stops", "c ticks"], _done);
        Assert.Equal("GtaDataHarvester: b failed: no more More in GtaDataHarvester.log.", Assert.Single(_told));
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Assert.Contains("InvalidOperationException", File.ReadAllText(Path.Combine(_folder, "GtaDataHarvester.log")), StringComparison.Ordinal);
    }

    [Fact]
    public void Do_stops_a_feature_whose_key_fails_also_when_it_fails_to_stop()
    {
        IFeature feature = Feature("a", failsIn: "a stops");
        var set = new FeatureSet(_messages, feature);

        set.Do(feature, () => throw new IOException("key"));

        Assert.Equal(["a stops"], _done);
        Assert.Equal(["GtaDataHarvester: a failed: key More in GtaDataHarvester.log.", "GtaDataHarvester: a failed: no more More in GtaDataHarvester.log."], _told);
    }

    [Fact]
    public void Finish_stops_all_in_the_opposite_order_before_it_waits_for_any()
    {
        var set = new FeatureSet(_messages, Feature("a"), Feature("b", failsIn: "b stops"), Feature("c"));

        set.Finish();

        Assert.Equal(["c stops", "b stops", "a stops", "a finishes", "b finishes", "c finishes"], _done);
    }

    [Fact]
    public void Try_tells_what_failed_on_another_thread_in_its_own_words()
    {
        new FeatureSet(_messages).Try("a", Task.FromException(new IOException("The disk is full.")).Wait);

        Assert.Equal(["GtaDataHarvester: a failed: The disk is full. More in GtaDataHarvester.log."], _told);
    }

    private ScriptedFeature Feature(string name, string? failsIn = null) => new(name, work =>
    {
        _done.Add(work);
        if (work == failsIn)
        {
            throw new InvalidOperationException("no more");
        }
    });

    private sealed class ScriptedFeature(string name, Action<string> work) : ILastingFeature
    {
        public string Name => name;

        public bool IsBusy => false;

        public void Tick() => work($"{name} ticks");

        public void Stop() => work($"{name} stops");

        public void Finish() => work($"{name} finishes");
    }
}
