using System.Diagnostics;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A copy of a small session for one test to damage, in a folder with a secret beside it that no command may touch.</summary>
internal sealed class HostileSession : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);
    private readonly TemporaryFolder _folder = new();

    public HostileSession(SmallSession session)
    {
        Directory.CreateDirectory(_folder.PathOf("a"));
        foreach (string file in Directory.EnumerateFiles(session.Folder, "*", SearchOption.AllDirectories))
        {
            string target = Path.Combine(Folder, Path.GetRelativePath(session.Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target);
        }
    }

    public string Folder => PathOf("a/session");

    /// <summary>A place outside the session.</summary>
    public string PathOf(string name) => Path.Combine(_folder.Path, name);

    /// <summary>A place in the session.</summary>
    public string In(string name) => Path.Combine(Folder, name);

    /// <summary>Replaces text in a file of the session, which must be there.</summary>
    public void Replace(string name, string old, string with)
    {
        string text = File.ReadAllText(In(name));
        int at = text.IndexOf(old, StringComparison.Ordinal);
        Assert.True(at >= 0, $"{name} has no {old}");
        File.WriteAllText(In(name), text[..at] + with + text[(at + old.Length)..]);
    }

    public void ReplaceByPipe(string name)
    {
        File.Delete(In(name));
        using Process make = Process.Start("mkfifo", In(name));
        make.WaitForExit();
        Assert.Equal(0, make.ExitCode);
    }

    /// <summary>Runs a command that must end, with a documented code and one line of error.</summary>
    public static CliRun Run(params string[] arguments)
    {
        Task<CliRun> run = CliRun.BesideAsync(arguments);
        Assert.True(run.Wait(Patience), $"'{string.Join(' ', arguments)}' does not end");
        return run.Result;
    }

    /// <summary>Runs a command that must reject its input in one line.</summary>
    public static void AssertRefused(string message, params string[] arguments)
    {
        CliRun run = Run(arguments);
        Assert.True(
            run.ExitCode is ExitCode.BadData or ExitCode.InputOutput,
            $"'{string.Join(' ', arguments)}' ends with {run.ExitCode}: {run.Error}"
        );
        Assert.Contains(message, run.Error + run.Out, StringComparison.Ordinal);
        Assert.InRange(run.Error.Count(character => character == '\n'), 0, 1);
    }

    public void Dispose() => _folder.Dispose();
}
