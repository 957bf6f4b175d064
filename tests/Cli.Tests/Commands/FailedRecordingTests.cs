using System.Diagnostics;
using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Drives whose recording fails because a file may not grow further, as on a full disk.</summary>
public sealed class FailedRecordingTests : IDisposable
{
    /// <summary>More than the labels of the first frames, less than those of a drive.</summary>
    private const int Kilobytes = 1100;

    private readonly TemporaryFolder _folder = new();

    private string[] Plain => ["drive", "--out", _folder.PathOf("out"), "--seed", "1", "--distance", "60"];

    private string[] Recorded => [.. Plain, "--record", _folder.PathOf("session"), "--size", "80x60"];

    private byte[] Record => File.ReadAllBytes(_folder.PathOf("out/drive.json"));

    public void Dispose() => _folder.Dispose();

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Drive_up_to_the_fault_is_written_and_can_be_given_again()
    {
        RunOnFullDisk(Recorded);
        using (JsonDocument begun = JsonDocument.Parse(Record))
        {
            Assert.False(begun.RootElement.GetProperty("isWhole").GetBoolean());
            Assert.InRange(begun.RootElement.GetProperty("figures").GetProperty("metres").GetDouble(), 1, 60);
        }

        Assert.True(File.Exists(_folder.PathOf("out/report.html")));
        CliRun.Of(Recorded).AssertDone();
        using JsonDocument whole = JsonDocument.Parse(Record);
        Assert.True(whole.RootElement.GetProperty("isWhole").GetBoolean());
    }

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Drive_made_after_the_fault_is_not_replaced()
    {
        RunOnFullDisk(Recorded);
        CliRun.Of([.. Plain, "--overwrite"]).AssertDone();
        byte[] other = Record;

        CliRun.Of(Recorded).AssertFailed(ExitCode.Usage, "already has a drive");
        Assert.Equal(other, Record);
    }

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Former_drive_stays_if_the_recording_fails()
    {
        CliRun.Of(Plain).AssertDone();
        byte[] former = Record;

        RunOnFullDisk([.. Recorded, "--overwrite"]);
        Assert.Equal(former, Record);
    }

    private static void RunOnFullDisk(string[] arguments)
    {
        string script = $"trap '' XFSZ; ulimit -f {Kilobytes}; exec dotnet \"$@\"";
        var start = new ProcessStartInfo("bash") { RedirectStandardOutput = true, RedirectStandardError = true };
        string program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
        Array.ForEach(["-c", script, "bash", program, .. arguments], start.ArgumentList.Add);

        // Otherwise the runtime itself makes a larger file, of what it compiles.
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        using Process command = Process.Start(start)!;
        Task<string> output = command.StandardOutput.ReadToEndAsync();
        string error = command.StandardError.ReadToEnd();
        command.WaitForExit();
        Assert.True(command.ExitCode == ExitCode.InputOutput, output.Result + error);
        Assert.Matches(@"^harvester: The session in '.+' cannot be written: .+\n$", error);
    }
}
