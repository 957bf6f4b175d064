using Harvester.Exports.Formats;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Every command and every export format is among what the fuzz tests damage, or it is said here why not.</summary>
public sealed class FuzzCoverageTests
{
    /// <summary>Commands that the fuzz tests do not run, each with the reason.</summary>
    private static readonly Dictionary<string, string> NotFuzzed = new()
    {
        ["calibrate"] = "It reads no file.",
        ["counterfactual"] = "Its options are those of harvest; the file that it writes is damaged for pairs.",
        ["plan init"] = "It reads no file.",
        ["plan run"] = "The plan is read as by plan check.",
        ["scenario run"] = "The scenario is read as by scenario check.",
        ["serve"] = "Its roads are read as by roads info; what clients send is damaged by the tests of the bridge.",
        ["supervise"] = "The sign of life that it reads is damaged by HeartbeatReaderTests.",
        ["view"] = "It does not end by itself; the readers of labels and of a session's roads show frames as it does.",
    };

    [Fact]
    public void Every_command_reads_damaged_files_or_has_a_reason()
    {
        string[] commands = [.. ApplicationTests.CommandsWithin("").Where(command => !ApplicationTests.CommandsWithin(command).Any())];
        string[] lines = [.. FuzzKind.All.SelectMany(kind => kind.Commands)];
        string[] fuzzed = [.. commands.Where(command => lines.Any(line => line.StartsWith(command + " ", StringComparison.Ordinal)))];

        Assert.Equal(commands.Except(fuzzed).Order(), NotFuzzed.Keys.Order());
    }

    [Fact]
    public void Every_channel_with_files_has_one_to_damage()
    {
        string[] files = [.. FuzzKind.All.Select(kind => kind.File)];

        Assert.All(
            FrameChannels.All.Where(channel => channel.Switch is not null && channel.Folders.Count > 0),
            channel =>
                Assert.Contains(
                    files,
                    file => channel.Folders.Any(folder => file.StartsWith($"session/{folder}/", StringComparison.Ordinal))
                )
        );
    }

    [Fact]
    public void Every_export_format_has_files_to_damage()
    {
        string[] folders = [.. FuzzKind.All.Select(kind => kind.File.Split('/')[0])];

        Assert.Empty(DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name).Except(folders));
    }
}
