using System.CommandLine;
using System.IO;
using Harvester.Cli.Boxes;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands;

/// <summary>harvester boxes: the boxes and fractions of cuboids in an image, as JSON; the tool to debug a label with.</summary>
internal static class BoxesCommand
{
    private const string Notes =
        "The scene's fields are described in docs/boxes-schema.md; a label's camera and box3d can be pasted into it.\n\n"
        + "Example:\n"
        + "  harvester boxes scene.json";

    public static Command Create(Terminal terminal)
    {
        var scene = new Argument<FileInfo>("SCENE.json") { Description = "A camera and cuboids" };
        var command = new Command("boxes", "Write the boxes and fractions of a scene's cuboids as JSON.") { scene };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            terminal.Out.WriteLine(BoxSceneWriter.Write(BoxSceneReader.Read(parsed.GetRequiredValue(scene))));
            return ExitCode.Done;
        });
        return command;
    }
}
