using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

/// <summary>A disk that fills up ends a harvest before it is full.</summary>
public sealed class SpaceWatchTests : IDisposable
{
    private const long Limit = 1_000_000_000;

    private static readonly SessionOrigin Origin = new()
    {
        Game = "test",
        Tool = "tests 1.0",
        Seed = 5,
    };

    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Harvest_ends_with_whole_frames_when_space_gets_low()
    {
        var game = new FakeGame();
        using var writer = new SessionWriter(
            _folder.Session,
            Origin,
            resume: false,
            new SessionDirectory(_folder.Session),
            disk: new Disk(Limit, Limit - 200_000_000)
        );
        var session = new HarvestSession(
            new HarvestOptions
            {
                Image = new ImageSize(64, 48),
                OcclusionSamples = 4,
                Scenes = false,
                MinFreeBytes = Limit,
            },
            game.Ports,
            writer
        );
        while (!session.Step().IsOver)
        {
            writer.WaitForRoom();
            game.Tick();
        }

        writer.Dispose();

        Assert.True(writer.IsSpaceLow);
        Assert.StartsWith(
            $"The disk of '{_folder.Session}' has 0.8 GB free; 1 GB must stay free. The session so far is valid, with ",
            session.Fault,
            StringComparison.Ordinal
        );
        Assert.False(game.WantsFrozen);
        Assert.Equal(writer.FramesWritten, _folder.CheckValid());
        Assert.Contains("\"The disk of 'session' has 0.8 GB free", _folder.Text(SessionDirectory.Header), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1L, 0)]
    [InlineData(Limit, Limit)]
    [InlineData(null, Limit)]
    public void Enough_or_unknown_space_is_no_fault(long? free, long limit) => new SpaceWatch("out", limit, new Disk(free)).Check();

    [Fact]
    public void Too_little_space_is_a_fault() =>
        Assert.Throws<LowSpaceException>(() => new SpaceWatch("out", Limit, new Disk(Limit - 1)).Check());

    [Fact]
    public void Disk_is_not_asked_again_at_once()
    {
        var disk = new Disk(Limit, 0);
        var watch = new SpaceWatch("out", Limit, disk);

        for (int i = 0; i < 5; i++)
        {
            watch.Check();
        }

        Assert.Equal(1, disk.Questions);
    }

    [Fact]
    public void System_knows_the_space_of_a_folder_to_be_made() =>
        Assert.True(new DriveSpace().BytesFor(Path.Combine(_folder.Session, "not", "there")) > 0);

    /// <summary>A disk with the given answers in turn; the last one stays.</summary>
    private sealed class Disk(params long?[] answers) : IFreeSpace
    {
        public int Questions { get; private set; }

        public long? BytesFor(string folder) => answers[Math.Min(Questions++, answers.Length - 1)];
    }
}
