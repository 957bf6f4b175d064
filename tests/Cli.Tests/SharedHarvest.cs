using System.Collections.Concurrent;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests;

/// <summary>Small harvests that tests of other commands begin with. Each is made once for all tests, and every test gets a copy.</summary>
internal static class SharedHarvest
{
    private static readonly ConcurrentDictionary<string, Lazy<TemporaryFolder>> Made = new();

    static SharedHarvest() =>
        AppDomain.CurrentDomain.ProcessExit += (_, _) =>
        {
            foreach (Lazy<TemporaryFolder> folder in Made.Values)
            {
                folder.Value.Dispose();
            }
        };

    /// <summary>Gives a test a session as harvest --out FOLDER OPTIONS would write it.</summary>
    /// <param name="folder">Where to write it; must not exist.</param>
    /// <param name="options">The other options of the harvest; --no-report among them, because a report has the name of its folder.</param>
    public static void CopyTo(string folder, params string[] options)
    {
        Assert.Contains("--no-report", options);
        string session = Made.GetOrAdd(string.Join(' ', options), _ => new Lazy<TemporaryFolder>(() => Make(options)))
            .Value.PathOf("session");
        foreach (string file in Directory.EnumerateFiles(session, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(folder, Path.GetRelativePath(session, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
    }

    private static TemporaryFolder Make(string[] options)
    {
        var folder = new TemporaryFolder();
        CliRun run = CliRun.Of(["harvest", "--out", folder.PathOf("session"), .. options]);
        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        return folder;
    }
}
