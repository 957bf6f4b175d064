using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Datasets.Repair;
using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester repair: recovers the whole frames of a damaged session.</summary>
internal sealed class RepairCommand
{
    private const string Notes =
        "Writes a new, valid session with every frame whose label line, image, mask and scene are whole, and lists everything that\n"
        + "was lost or corrected, one line each. The damaged session is not changed. The exit code is 1 if anything was lost.\n"
        + "docs/repair.md has details.\n\n"
        + "Examples:\n"
        + "  harvester repair out\n"
        + "  harvester repair out --out recovered --images copy";

    private Option<string?> Out { get; } =
        new("--out") { Description = "Folder to write the new session to [default: SESSION-repaired]", HelpName = "DIR" };
    private Option<ImageTransfer> Images { get; } = TransferOption.Create("files");
    private Option<SyncMode> Sync { get; } = SyncOption.Create();

    public static Command Create(Terminal terminal) => new RepairCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        Argument<string> session = SessionArgument.Create();
        var command = new Command("repair", "Recover all whole frames of a damaged session.") { session, Out, Images, Sync };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(session), parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, string session, ParseResult parsed, CancellationToken cancellation)
    {
        string damaged = Path.TrimEndingDirectorySeparator(Path.GetFullPath(session));
        string folder = parsed.GetValue(Out) ?? DefaultFolder(session, damaged);
        if (Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder)) == damaged)
        {
            throw new UsageException("--out is the damaged session itself, which stays as it is. Name another folder.");
        }

        var repairer = new SessionRepairer(session, problem => terminal.WriteQuoting(problem.ToString()));
        using var output = new SessionOutput(terminal.WriteError, folder, CommandText.Of(parsed), overwrite: null);
        SessionRepair repair = repairer.Run(output.Begin(), parsed.GetValue(Images), parsed.GetValue(Sync), cancellation);
        output.Complete();
        terminal.Out.WriteLine($"{folder}: {Counted.Of(repair.Frames, "frame")} recovered, {repair.Lost} lost");
        return repair.IsAllKept ? ExitCode.Done : ExitCode.BadData;
    }

    /// <summary>The folder beside the session, as the session is given on the command line unless that has no name, as in "..".</summary>
    private static string DefaultFolder(string session, string fullPath)
    {
        string given = Path.TrimEndingDirectorySeparator(session);
        return (Path.GetFileName(given) is "" or "." or ".." ? fullPath : given) + "-repaired";
    }
}
