using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;
using Harvester.Tapes;

namespace Harvester.Cli.Commands.Tapes;

/// <summary>harvester tape play: runs the mod's code against a tape.</summary>
internal static class TapePlayCommand
{
    public const string Examples = "Example:\n  harvester tape play tape-20260102-101530.tape";

    private const string Notes =
        "FILE was recorded in the game with Record = Natives under [Tape] in GtaDataHarvester.ini. The mod's own code, of this version,\n"
        + "runs against it on any machine: it gets the recorded answers and pictures. The first call that differs from the recorded one\n"
        + "is printed with its tick. The exit code is 1 if there is one. Sessions that the mod writes meanwhile are deleted.\n\n"
        + Examples;

    public static Command Create(Terminal terminal)
    {
        var file = new Argument<string>("FILE") { Description = "The tape" };
        var command = new ResultCommand("play", "Run the mod's code against a tape and print the first difference.") { file };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(file), cancellation)));
        return command;
    }

    private static int Run(Terminal terminal, string path, CancellationToken cancellation)
    {
        TapeResult result = Play(path, cancellation);
        string played = $"{Counted.Of(result.Ticks, "tick")}, {Counted.Of(result.Calls, "call")}, recorded by version {result.RecordedBy}";
        if (result.IsInterrupted)
        {
            terminal.Out.WriteLine("The recording was interrupted; it is played up to its last whole part.");
        }

        if (result.Difference is not { } difference)
        {
            terminal.Out.WriteLine(MessageLine.Of($"No difference: {played}"));
            return ExitCode.Done;
        }

        terminal.Out.WriteLine(MessageLine.Of($"First difference in tick {difference.Tick}, call {difference.Call}; before it {played}"));
        terminal.Out.WriteLine("  expected: " + MessageLine.Of(difference.Expected));
        terminal.Out.WriteLine("  got:      " + MessageLine.Of(difference.Got));
        return ExitCode.BadData;
    }

    /// <summary>Plays a tape in a temporary folder.</summary>
    /// <exception cref="DatasetFormatException">The file is not a tape, or is damaged.</exception>
    /// <exception cref="IOException">The file cannot be read, or the folder not written.</exception>
    internal static TapeResult Play(string path, CancellationToken cancellation)
    {
        using FileStream file = InputFile.OpenRead(path);
        DirectoryInfo folder = Directory.CreateTempSubdirectory("harvester-tape-");
        try
        {
            return TapePlayer.Play(file, folder.FullName, cancellation);
        }
        catch (InvalidDataException e)
        {
            throw new DatasetFormatException($"'{path}' cannot be played: {e.Message}");
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
