using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;

namespace Harvester.Sessions.Tests.Plans;

public sealed class PlanResultsTests : IDisposable
{
    private static readonly Trial First = TrialAt("a");
    private static readonly Trial Second = TrialAt("b");

    private readonly string _folder = Directory.CreateTempSubdirectory("plan-results").FullName;
    private readonly PlanResults _results;

    public PlanResultsTests() => _results = new PlanResults(_folder, WriterLock.Take(_folder));

    public void Dispose()
    {
        _results.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Folder_is_held_until_it_is_released()
    {
        Assert.Throws<FolderLockedException>(() => WriterLock.Take(_folder));
        _results.Dispose();

        WriterLock.Take(_folder).Dispose();
    }

    [Fact]
    public void Trials_that_are_done_or_skipped_are_not_left()
    {
        Assert.Throws<InvalidOperationException>(() => _results.Status);
        _results.ReadStatus(Shard.Whole);
        Assert.Equal([First, Second], _results.Left([First, Second]));
        _results.Status.Add(new TrialResult(First.Id, TrialState.Done, 1, 4, null));
        _results.Status.Add(TrialResult.OfFailure(Second.Id, 1, 0, "stuck"));

        Assert.Equal([Second], _results.Left([First, Second]));
    }

    [Fact]
    public void Part_has_results_once_a_trial_of_it_has_ended()
    {
        var shard = new Shard(1, 2);
        Assert.False(_results.HasResults(Shard.Whole) || _results.HasResults(shard));
        _results.ReadStatus(shard);
        _results.Status.Add(new TrialResult(First.Id, TrialState.Done, 1, 4, null));
        Assert.Equal((false, true), (_results.HasResults(Shard.Whole), _results.HasResults(shard)));
        Directory.CreateDirectory(_results.FolderOf(Second));

        Assert.True(_results.HasResults(Shard.Whole));
    }

    [Fact]
    public void Sessions_that_are_set_aside_keep_their_names_with_numbers()
    {
        _results.SetAside(First);
        for (int attempt = 1; attempt <= 3; attempt++)
        {
            Directory.CreateDirectory(_results.FolderOf(First));
            File.WriteAllText(Path.Combine(_results.FolderOf(First), "attempt.txt"), $"{attempt}");
            _results.SetAside(First);
        }

        Assert.False(Directory.Exists(_results.FolderOf(First)));
        Assert.Equal(["1", "2", "3"], [TextAside(First.Id), TextAside($"{First.Id}-2"), TextAside($"{First.Id}-3")]);
    }

    private string TextAside(string name) => File.ReadAllText(Path.Combine(_folder, "unfinished", name, "attempt.txt"));

    private static Trial TrialAt(string place) =>
        new(new PlanPlace(place), "clear", TimeSpan.FromHours(8), new PlanCamera("c", new ImageSize(8, 6), 50, null), 1);
}
