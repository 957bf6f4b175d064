using System.Diagnostics;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Harvests of a rig in processes of their own that are killed in the middle.</summary>
public sealed class KilledRigTests : IDisposable
{
    private const int Moments = 8;

    private readonly TemporaryFolder _folder = new();
    private readonly string _rig;

    public KilledRigTests() => _rig = _folder.File("rig.json", HarvestedRig.Rig);

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Killed_harvest_leaves_whole_moments_and_resumes()
    {
        int underWay = 0;
        foreach (int lines in new[] { 2, 9 })
        {
            underWay += KillAfter(lines) ? 1 : 0;
            FrameLabel[] labels = [.. new SessionReader(_folder.PathOf("killed")).ReadLabels()];
            Assert.Equal(0, labels.Length % 2);
            Assert.All(labels.Chunk(2), moment => Assert.Equal(["left", "right"], moment.Select(label => label.View)));
            Assert.All(labels.SelectMany(label => label.Files), file => Assert.True(File.Exists(_folder.PathOf($"killed/{file}")), file));
        }

        CliRun.Of(Arguments("killed")).AssertDone();
        CliRun.Of(Arguments("whole")).AssertDone();
        string[] files = [.. Files("whole")];
        Assert.Equal(files, Files("killed"));
        Assert.All(
            files,
            file => Assert.Equal(File.ReadAllBytes(_folder.PathOf($"whole/{file}")), File.ReadAllBytes(_folder.PathOf($"killed/{file}")))
        );
        Assert.NotEqual(0, underWay);
    }

    /// <summary>Starts or resumes the harvest, and kills it once this many label lines are written.</summary>
    /// <returns>Whether it was under way.</returns>
    private bool KillAfter(int lines)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "harvester.dll"));
        Array.ForEach(Arguments("killed"), start.ArgumentList.Add);
        using Process harvest = Process.Start(start)!;
        while (!harvest.HasExited && Lines() < lines)
        {
            Thread.Sleep(1);
        }

        bool isUnderWay = !harvest.HasExited;
        harvest.Kill();
        harvest.WaitForExit();
        return isUnderWay;
    }

    private string[] Arguments(string name) =>
        [
            "harvest",
            "--out",
            _folder.PathOf(name),
            "--rig",
            _rig,
            "--frames",
            $"{Moments}",
            "--hz",
            "2",
            "--seed",
            "3",
            "--places",
            "1",
            "--masks",
            "--depth",
            "--normals",
            "--flow",
            "--no-report",
            "--resume",
            "--sync",
            "always",
        ];

    private int Lines()
    {
        string labels = _folder.PathOf("killed/labels.jsonl");
        if (!File.Exists(labels))
        {
            return 0;
        }

        using var file = new FileStream(labels, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        using var reader = new StreamReader(file);
        return reader.ReadToEnd().Count(character => character == '\n');
    }

    private IEnumerable<string> Files(string name) =>
        Directory
            .GetFiles(_folder.PathOf(name), "*", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(_folder.PathOf(name), file))
            .Order();
}
