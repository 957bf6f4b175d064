using System.Text.Json;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

public sealed class SessionWriterTests : IDisposable
{
    private static readonly SessionOrigin Origin = new()
    {
        Game = "test",
        Tool = "tests 1.0",
        Seed = 5,
    };
    private static readonly HarvestOptions Options = new()
    {
        Image = new ImageSize(64, 48),
        MaxFrames = 6,
        OcclusionSamples = 4,
        Masks = true,
    };

    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Harvest_writes_a_valid_complete_session()
    {
        using (var writer = new SessionWriter(_folder.Session, Origin))
        {
            Harvest(writer, Options);
        }

        Assert.Equal(6, _folder.CheckValid());
        Assert.Equal(6, Directory.GetFiles(Path.Combine(_folder.Session, "masks")).Length);
        JsonElement header = JsonDocument.Parse(_folder.Text("session.json")).RootElement;
        Assert.Equal("complete", header.GetProperty("state").GetString());
        Assert.Equal(6, header.GetProperty("counters").GetProperty("captured").GetInt32());
        Assert.Equal(1, header.GetProperty("formatVersion").GetInt32());
        Assert.Equal(5, header.GetProperty("seed").GetInt32());
        Assert.Equal(64, header.GetProperty("camera").GetProperty("width").GetInt32());
        Assert.DoesNotContain("\r", _folder.Text("session.json"), StringComparison.Ordinal);
        Assert.Equal((byte)'{', File.ReadAllBytes(Path.Combine(_folder.Session, "session.json"))[0]);
    }

    [Fact]
    public void Harvest_twice_gives_the_same_bytes()
    {
        using var other = new SessionFolder();
        foreach (SessionFolder folder in new[] { _folder, other })
        {
            using var writer = new SessionWriter(folder.Session, Origin);
            Harvest(writer, Options);
        }

        IReadOnlyDictionary<string, byte[]> first = _folder.Files();
        IReadOnlyDictionary<string, byte[]> second = other.Files();

        // 6 pictures, 6 masks, 6 scenes, labels, manifest and header.
        Assert.Equal(21, first.Count);
        Assert.Equal(first.Keys.Order(), second.Keys.Order());
        Assert.All(first, file => Assert.Equal(file.Value, second[file.Key]));
    }

    [Fact]
    public void Harvest_as_bitmaps_writes_bitmaps()
    {
        using (var writer = new SessionWriter(_folder.Session, Origin))
        {
            Harvest(writer, Options with { Format = ImageFormat.Bmp, Masks = false });
        }

        string[] frames = Directory.GetFiles(Path.Combine(_folder.Session, "frames"));
        Assert.Equal(6, frames.Length);
        Assert.All(frames, frame => Assert.Equal("BM"u8.ToArray(), File.ReadAllBytes(frame)[..2]));
        Assert.All(frames, frame => Assert.EndsWith(".bmp", frame, StringComparison.Ordinal));
    }

    [Fact]
    public void Constructor_refuses_an_occupied_directory_unchanged()
    {
        Directory.CreateDirectory(_folder.Session);
        File.WriteAllText(Path.Combine(_folder.Session, "notes.txt"), "mine");

        IOException refusal = Assert.Throws<IOException>(() => new SessionWriter(_folder.Session, Origin));

        Assert.Contains("is not empty", refusal.Message, StringComparison.Ordinal);
        Assert.Single(Directory.GetFileSystemEntries(_folder.Session));
    }

    // Before the first frame: the header's line in the manifest, the header, and both brought to the disk. Of each frame: picture, mask,
    // scene, these brought to the disk, its line in the manifest, its label line.
    [Theory]
    [InlineData(1, 0)]
    [InlineData(2, 0)]
    [InlineData(3, 0)]
    [InlineData(4, 0)]
    [InlineData(5, 0)]
    [InlineData(6, 0)]
    [InlineData(7, 0)]
    [InlineData(8, 0)]
    [InlineData(9, 0)]
    [InlineData(10, 1)]
    [InlineData(13, 1)]
    [InlineData(15, 1)]
    [InlineData(27, 3)]
    [InlineData(28, 4)]
    public void Harvest_to_a_disk_that_fills_up_leaves_complete_frames(int failingWrite, int wholeFrames)
    {
        var files = new FailingFiles(_folder.Session, failingWrite);
        var game = new FakeGame();
        var writer = new SessionWriter(_folder.Session, Origin, resume: false, files);
        var session = new HarvestSession(Options with { MaxFrames = 1_000, Sync = SyncMode.Always }, game.Ports, writer);
        RunToEnd(session, game, writer);
        writer.Dispose();

        Assert.Equal(HarvestPhase.Faulted, session.Status.Phase);
        Assert.Contains("No space left on device.", session.Fault, StringComparison.Ordinal);
        Assert.Contains($"The session so far is valid, with {wholeFrames} frame", session.Fault, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', session.Fault!);
        Assert.False(game.WantsFrozen);
        Assert.Equal(wholeFrames, _folder.CheckValid());
    }

    [Fact]
    public void Harvest_to_a_stalled_disk_neither_waits_nor_loses_frames()
    {
        using var files = new SlowFiles(_folder.Session);
        var game = new FakeGame();
        var writer = new SessionWriter(_folder.Session, Origin, resume: false, files);
        var session = new HarvestSession(Options with { MaxFrames = 10, QueueCapacity = 2 }, game.Ports, writer);
        IReadOnlyList<HarvestPhase> phases = game.Run(session, 300);

        // Two in the queue and none written: the writer's thread waits for the header. 300 ticks went by all the same.
        Assert.Equal((300, 2, 2, 0), (phases.Count, session.Counters.Captured, writer.Queued, writer.FramesWritten));
        Assert.Equal(HarvestPhase.WaitingForSink, phases[^1]);
        Assert.False(game.WantsFrozen);

        files.Release();
        RunToEnd(session, game, writer);
        writer.Dispose();
        Assert.Equal(10, _folder.CheckValid());
    }

    [Fact]
    public void Harvest_into_a_folder_that_is_deleted_ends_with_a_fault()
    {
        var game = new FakeGame();
        using var writer = new SessionWriter(_folder.Session, Origin);
        var session = new HarvestSession(Options with { MaxFrames = null }, game.Ports, writer);
        while (writer.FramesWritten < 2)
        {
            session.Step();
            game.Tick();
        }

        Directory.Move(_folder.Session, _folder.Session + "-moved");
        RunToEnd(session, game, writer);

        Assert.Equal(HarvestPhase.Faulted, session.Status.Phase);
        Assert.Contains("cannot be written", session.Fault, StringComparison.Ordinal);
    }

    [Fact]
    public void Resumed_harvest_continues_frame_and_object_numbers()
    {
        using (var writer = new SessionWriter(_folder.Session, Origin))
        {
            Harvest(writer, Options);
        }

        // A line that a crash cut off is no frame.
        File.AppendAllText(Path.Combine(_folder.Session, "labels.jsonl"), "{\"frame\":6,");
        using (var writer = new SessionWriter(_folder.Session, Origin, resume: true))
        {
            Assert.Equal((6, 2), (writer.FirstFrame, writer.FirstObjectId));
            Harvest(writer, Options);
            Assert.Null(writer.Fault);
        }

        Assert.Equal(12, _folder.CheckValid());
        Assert.Contains("\"id\":1,", _folder.LabelLines[0], StringComparison.Ordinal);
        Assert.Contains("\"id\":2,", _folder.LabelLines[11], StringComparison.Ordinal);
        Assert.Equal(
            12,
            JsonDocument.Parse(_folder.Text("session.json")).RootElement.GetProperty("counters").GetProperty("captured").GetInt32()
        );
    }

    [Fact]
    public void Resuming_with_other_options_fails_and_changes_nothing()
    {
        using (var writer = new SessionWriter(_folder.Session, Origin))
        {
            Harvest(writer, Options);
        }

        IReadOnlyDictionary<string, byte[]> before = _folder.Files();
        using (var writer = new SessionWriter(_folder.Session, Origin, resume: true))
        {
            Harvest(writer, Options with { RangeMetres = 50, MaxFrames = null });
            Assert.Contains("other options", writer.Fault, StringComparison.Ordinal);
        }

        JsonElement header = JsonDocument.Parse(_folder.Text("session.json")).RootElement;
        Assert.Equal(150, header.GetProperty("options").GetProperty("rangeMetres").GetInt32());
        Assert.All(_folder.Files(), file => Assert.Equal(before[file.Key], file.Value));
    }

    private static void Harvest(SessionWriter writer, HarvestOptions options)
    {
        var game = new FakeGame();
        RunToEnd(new HarvestSession(options, game.Ports, writer), game, writer);
    }

    private static void RunToEnd(HarvestSession session, FakeGame game, SessionWriter writer)
    {
        for (int tick = 0; !session.Step().IsOver; tick++)
        {
            Assert.True(tick < 100_000, "The harvest does not end.");
            writer.WaitForRoom();
            game.Tick();
        }
    }
}
