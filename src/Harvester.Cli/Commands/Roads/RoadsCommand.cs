using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads: road networks from the files of several tools, their node database and maps.</summary>
internal static class RoadsCommand
{
    private const string Notes =
        "FROM is a file, a folder or a zip archive, plain or packed by gzip: CodeWalker's *.ynd.xml, paths.ipl, paths.xml, the JSON dump of\n"
        + "nodes, or the csv that import or the mod's survey wrote. Which one it is, is told from its content. Formats: docs/roads.md.\n\n"
        + "Examples:\n"
        + "  harvester roads import exported-ynd/ --out roads.csv.gz\n"
        + "  harvester roads info roads.csv.gz\n"
        + "  harvester roads compare paths.xml exported-ynd/\n"
        + "  harvester roads map roads.csv.gz --out map.png --size 4000\n"
        + "  harvester roads nodes roads.csv.gz --out nodes.csv";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("roads", "Import road networks, show and compare them, and write their node database.");
        command.Subcommands.Add(RoadsImportCommand.Create(terminal));
        command.Subcommands.Add(RoadsInfoCommand.Create(terminal));
        command.Subcommands.Add(RoadsCompareCommand.Create(terminal));
        command.Subcommands.Add(RoadsMapCommand.Create(terminal));
        command.Subcommands.Add(RoadsNodesCommand.Create(terminal));
        HelpWithNotes.AddTo(command, Notes);
        foreach (Command each in command.Subcommands)
        {
            HelpWithNotes.AddTo(each, Notes);
        }

        return command;
    }
}
