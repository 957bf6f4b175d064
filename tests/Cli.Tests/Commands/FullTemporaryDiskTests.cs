using System.Diagnostics;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// Playbacks whose temporary folder is on a small disk of its own, which fills up. Mounting it needs Linux's user namespaces.
/// </summary>
public sealed class FullTemporaryDiskTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    // The disk is full before the playback begins, and in the midst of it.
    [MountTheory]
    [InlineData("8k")]
    [InlineData("64k")]
    public void Playback_on_a_full_disk_ends_in_one_line(string size)
    {
        string tape = Path.Combine(RepositoryFolder.Path, "tests", "Mod.Tests", "Tapes", "harvest-rays.tape");
        string script = $"mount -t tmpfs -o size={size} tmpfs \"$TMPDIR\" && exec dotnet \"$@\"";
        var start = new ProcessStartInfo("unshare") { RedirectStandardOutput = true, RedirectStandardError = true };
        string program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
        Array.ForEach(["-rm", "bash", "-c", script, "bash", program, "tape", "play", tape], start.ArgumentList.Add);
        start.Environment["TMPDIR"] = _folder.Path;

        // Otherwise the runtime makes files of its own there.
        start.Environment["DOTNET_EnableDiagnostics"] = "0";
        using Process command = Process.Start(start)!;
        Task<string> output = command.StandardOutput.ReadToEndAsync();
        string error = command.StandardError.ReadToEnd();
        command.WaitForExit();

        Assert.Equal((ExitCode.InputOutput, ""), (command.ExitCode, output.Result));
        Assert.Matches(@"^harvester: The disk is full: '.+' cannot be written\. Free some space.*\n$", error);
    }
}
