using System.Diagnostics;
using System.Security.Cryptography;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// Exports run as processes of their own that are killed in the middle; the same command again must give the bytes of a run that was left
/// alone.
/// </summary>
public sealed class KilledExportTests : IClassFixture<LongSession>, IDisposable
{
    private const int KilledAfterFrames = 20;
    private const int SeedThatDealsOutBothSessions = 10;

    private readonly LongSession _session;
    private readonly TemporaryFolder _folder = new();

    public KilledExportTests(LongSession session) => _session = session;

    /// <summary>
    /// Formats that write in different ways: files per frame, files per sequence, tables over all frames, staged parts, and archives.
    /// InterruptedExportTests stops all formats, within a process.
    /// </summary>
    public static TheoryData<string> Formats =>
        ["kitti", "kitti-odometry", "coco", "coco-panoptic", "cityscapes", "deepdriving", "nuscenes", "webdataset", "mcap"];

    public void Dispose() => _folder.Dispose();

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Formats))]
    public void Killed_export_resumes_to_the_same_bytes(string format)
    {
        KillInTheMiddle(format);
        foreach (string name in (string[])["killed", "whole"])
        {
            using Process export = Start(format, name, "--resume");
            export.WaitForExit();
            Assert.Equal(0, export.ExitCode);
        }

        Assert.Equal(Contents("whole"), Contents("killed"));
    }

    /// <summary>On a busy machine an export may be over before it can be killed: then another is tried.</summary>
    private void KillInTheMiddle(string format)
    {
        DateTime end = DateTime.UtcNow.AddMinutes(1);
        while (!TryKillInTheMiddle(format))
        {
            Assert.True(DateTime.UtcNow < end, "Each export was over before it could be killed.");
            Directory.Delete(_folder.PathOf("killed"), recursive: true);
        }
    }

    private bool TryKillInTheMiddle(string format)
    {
        using Process export = Start(format, "killed");
        while (FramesDone() < KilledAfterFrames && !export.HasExited)
        {
            Thread.Sleep(1);
        }

        if (export.HasExited)
        {
            Assert.Equal(0, export.ExitCode);
            return false;
        }

        export.Kill();
        export.WaitForExit();
        return FramesDone() < LongSession.Frames + LongSession.HarvestedFrames && !File.Exists(_folder.PathOf("killed/export.json"));
    }

    /// <summary>
    /// Frames that the export which is killed has noted as done; 0 before it has begun, and when it is over and has taken its notes away.
    /// </summary>
    private int FramesDone()
    {
        try
        {
            return Lines(_folder.PathOf("killed/.export/journal-1-of-1.jsonl"));
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            return 0;
        }
    }

    private Process Start(string format, string to, params string[] more)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        string[] arguments =
        [
            Path.Combine(AppContext.BaseDirectory, "harvester.dll"),
            "export",
            _session.Folder,
            _session.ShortFolder,
            "--format",
            format,
            "--out",
            _folder.PathOf(to),
            "--split",
            "train:0.7,val:0.3",
            "--seed",
            $"{SeedThatDealsOutBothSessions}",
            .. more,
        ];
        Array.ForEach(arguments, start.ArgumentList.Add);
        return Process.Start(start)!;
    }

    /// <summary>Lines of a file that another process writes and may delete.</summary>
    private static int Lines(string path)
    {
        using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        using var reader = new StreamReader(file);
        return reader.ReadToEnd().Count(character => character == '\n');
    }

    private SortedDictionary<string, string> Contents(string name)
    {
        var contents = new SortedDictionary<string, string>(StringComparer.Ordinal);
        foreach (string file in Directory.EnumerateFiles(_folder.PathOf(name), "*", SearchOption.AllDirectories))
        {
            contents.Add(Path.GetRelativePath(_folder.PathOf(name), file), Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(file))));
        }

        return contents;
    }
}
