using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Boxes;

namespace Harvester.Cli.Commands;

/// <summary>harvester boxes: prints the boxes and fractions of cuboids in an image, as JSON.</summary>
internal static class BoxesCommand
{
    private const string Notes =
        "docs/boxes-schema.md describes the file. To debug a label, paste its camera and box3d into the file.\n\n"
        + "Example:\n"
        + "  harvester boxes scene.json";

    public static Command Create(Terminal terminal)
    {
        var scene = new Argument<FileInfo>("SCENE.json") { Description = "JSON file with a camera and cuboids" };
        var command = new ResultCommand("boxes", "Print the boxes and fractions of cuboids for a camera, as JSON.") { scene };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            terminal.Out.WriteLine(BoxSceneWriter.Write(BoxSceneReader.Read(parsed.GetRequiredValue(scene))));
            return ExitCode.Done;
        });
        return command;
    }
}
