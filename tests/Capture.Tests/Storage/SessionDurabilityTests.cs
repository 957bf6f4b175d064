using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

public sealed class SessionDurabilityTests : IDisposable
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
        OcclusionSamples = 4,
        Scenes = false,
    };

    private static readonly TimeSpan LongestWait = TimeSpan.FromMinutes(1);

    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(SyncMode.Always)]
    [InlineData(SyncMode.Batch)]
    public void Label_line_follows_files_on_disk_and_manifest(SyncMode sync)
    {
        List<string> calls = Harvest(Options with { MaxFrames = 20, Sync = sync });

        string[] unsafeFiles = [];
        int manifestLines = 0;
        int labelLines = 0;

        // The first line of the manifest is that of the header.
        foreach (string call in calls.Skip(1))
        {
            string[] words = call.Split(" +");
            if (words[0] == "labels.jsonl")
            {
                Assert.Empty(unsafeFiles);
                labelLines += int.Parse(words[1]);
                Assert.True(labelLines <= manifestLines, call);
            }
            else if (words[0] == Manifest.FileName)
            {
                manifestLines += int.Parse(words[1]);
            }
            else
            {
                unsafeFiles = call == "sync" ? [] : [.. unsafeFiles, call];
            }
        }

        Assert.Equal(20, labelLines);
        Assert.Equal(20, _folder.CheckValid());
    }

    [Fact]
    public void Batch_holds_back_at_most_sixteen_frames()
    {
        List<string> calls = Harvest(Options with { MaxFrames = 20 });

        string[] labels = [.. calls.Where(call => call.StartsWith("labels", StringComparison.Ordinal))];
        Assert.All(labels, call => Assert.InRange(int.Parse(call.Split(" +")[1]), 1, 16));
        Assert.Equal(20, labels.Sum(call => int.Parse(call.Split(" +")[1])));
    }

    [Fact]
    public void Line_of_a_lone_frame_is_written_while_harvest_goes_on()
    {
        var game = new FakeGame();
        using var writer = new SessionWriter(_folder.Session, Origin);
        using var session = new HarvestSession(Options with { MaxFrames = 2 }, game.Ports, writer);
        while (session.Step().Captured < 1)
        {
            game.Tick();
        }

        // No other frame comes, so the batch never fills.
        Assert.True(SpinWait.SpinUntil(() => writer.FramesWritten == 1, LongestWait));
        Assert.Single(_folder.LabelLines);
    }

    [Fact]
    public void Without_sync_nothing_waits_for_the_disk()
    {
        List<string> calls = Harvest(Options with { MaxFrames = 3, Sync = SyncMode.Never });

        Assert.DoesNotContain("sync", calls);
        Assert.Equal(3, calls.Count(call => call == "labels.jsonl +1 not durable"));
    }

    [Fact]
    public void Frames_that_the_disk_cannot_keep_are_not_counted()
    {
        // The first sync is that of the header, the fourth that of the third frame.
        var files = new OrderedFiles(_folder.Session, failingSync: 4);
        var game = new FakeGame();
        var writer = new SessionWriter(_folder.Session, Origin, resume: false, files);
        var session = new HarvestSession(Options with { MaxFrames = 1_000, Sync = SyncMode.Always }, game.Ports, writer);
        RunToEnd(session, game, writer);
        writer.Dispose();

        Assert.Contains("Input/output error. The session so far is valid, with 2 frames", session.Fault, StringComparison.Ordinal);
        Assert.Equal(2, writer.FramesWritten);
        Assert.Equal(2, _folder.CheckValid());
        Assert.Equal(2, ManifestLines().Count(line => Manifest.FrameOf(line) is not null));
    }

    [Fact]
    public void Frames_before_a_full_disk_are_kept_though_held_back()
    {
        // Manifest and header; then a picture and a mask for each frame, so that the sixth file is the mask of the second frame.
        var files = new FailingFiles(_folder.Session, failingWrite: 7, failures: 1);
        var game = new FakeGame();
        var writer = new SessionWriter(_folder.Session, Origin, resume: false, files);
        var session = new HarvestSession(Options with { MaxFrames = 1_000, Masks = true }, game.Ports, writer);
        RunToEnd(session, game, writer);
        writer.Dispose();

        Assert.Contains("The session so far is valid, with 1 frame.", session.Fault, StringComparison.Ordinal);
        Assert.Equal(1, _folder.CheckValid());
    }

    [Fact]
    public void Manifest_has_size_and_checksum_of_every_file()
    {
        Harvest(Options with { MaxFrames = 2, Scenes = true, Masks = true });

        string[] lines = ManifestLines();
        Assert.All(lines, line => Assert.True(Manifest.IsIntact(line), line));
        string all = string.Concat(lines);
        foreach ((string path, byte[] bytes) in _folder.Files().Where(file => !file.Key.EndsWith(".jsonl", StringComparison.Ordinal)))
        {
            FileDigest digest = FileDigest.Of(bytes, bytes.Length);
            string name = path.Replace('\\', '/');
            Assert.Contains($"\"path\":\"{name}\",\"bytes\":{digest.Bytes},\"sha256\":\"{digest.Sha256}\"", all, StringComparison.Ordinal);
        }

        for (int frame = 0; frame < 2; frame++)
        {
            FileDigest label = FileDigest.Of(_folder.LabelLines[frame]);
            Assert.StartsWith(
                $"{{\"frame\":{frame},\"label\":{{\"bytes\":{label.Bytes},\"sha256\":\"{label.Sha256}\"}}",
                lines[frame],
                StringComparison.Ordinal
            );
        }

        // Two frames and the header, of which the line before the harvest ended is gone.
        Assert.Equal(3, lines.Length);
    }

    [Fact]
    public void Resumed_session_has_the_manifest_of_one_harvest()
    {
        HarvestOptions options = Options with { MaxFrames = 2 };
        Harvest(options);
        File.AppendAllText(Path.Combine(_folder.Session, Manifest.FileName), Manifest.FrameLine(2, default, []) + "\n{\"frame\":3,");
        using (var writer = new SessionWriter(_folder.Session, Origin, resume: true))
        {
            var game = new FakeGame();
            RunToEnd(new HarvestSession(options, game.Ports, writer), game, writer);
        }

        string[] lines = ManifestLines();
        Assert.Equal([0, 1, 2, 3, null], lines.Select(Manifest.FrameOf));
        Assert.Equal(
            _folder.LabelLines.Select(line => FileDigest.Of(line).Sha256),
            lines.Take(4).Select(line => line.Split("\"sha256\":\"")[1][..64])
        );
        Assert.Contains("\"manifest\": true", _folder.Text(SessionDirectory.Header), StringComparison.Ordinal);
    }

    [Fact]
    public void Resumed_session_without_manifest_stays_without()
    {
        HarvestOptions options = Options with { MaxFrames = 1 };
        Harvest(options);
        File.Delete(Path.Combine(_folder.Session, Manifest.FileName));
        using (var writer = new SessionWriter(_folder.Session, Origin, resume: true))
        {
            var game = new FakeGame();
            RunToEnd(new HarvestSession(options, game.Ports, writer), game, writer);
        }

        Assert.Equal(2, _folder.CheckValid());
        Assert.False(File.Exists(Path.Combine(_folder.Session, Manifest.FileName)));
        Assert.DoesNotContain("\"manifest\"", _folder.Text(SessionDirectory.Header), StringComparison.Ordinal);
    }

    private string[] ManifestLines() => _folder.Text(Manifest.FileName).TrimEnd('\n').Split('\n');

    private List<string> Harvest(HarvestOptions options)
    {
        var files = new OrderedFiles(_folder.Session);
        var game = new FakeGame();
        using var writer = new SessionWriter(_folder.Session, Origin, resume: false, files);
        RunToEnd(new HarvestSession(options, game.Ports, writer), game, writer);
        writer.Dispose();
        return files.Calls;
    }

    private static void RunToEnd(HarvestSession session, FakeGame game, SessionWriter writer)
    {
        while (!session.Step().IsOver)
        {
            writer.WaitForRoom();
            game.Tick();
        }
    }
}
