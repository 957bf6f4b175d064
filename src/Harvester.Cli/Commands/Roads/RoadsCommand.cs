using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads: road networks from the files of several tools, their node database and maps.</summary>
internal static class RoadsCommand
{
    private const string Notes =
        "FROM is a file, a folder or a zip archive, plain or gzip-compressed, with one of these: CodeWalker's *.ynd.xml, paths.ipl, paths.xml, the\n"
        + "JSON dump of nodes, or a CSV file from roads import or from the mod's survey. The format is detected from the content; docs/roads.md\n"
        + "describes each.\n\n"
        + "Examples:\n"
        + "  harvester roads import exported-ynd/ --out roads.csv.gz\n"
        + "  harvester roads info roads.csv.gz\n"
        + "  harvester roads compare paths.xml exported-ynd/\n"
        + "  harvester roads map roads.csv.gz --out map.png --size 4000\n"
        + "  harvester roads nodes roads.csv.gz --out nodes.csv";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("roads", "Import, compare and draw road networks, and write their node database.");
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
