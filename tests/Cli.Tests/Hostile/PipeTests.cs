using Harvester.Cli.Tests.Commands;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A pipe in the place of a file would block its reader forever.</summary>
public sealed class PipeTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [PosixTheory]
    [InlineData("session.json", "validate")]
    [InlineData("session.json", "stats")]
    [InlineData("labels.jsonl", "validate")]
    [InlineData("labels.jsonl", "stats")]
    [InlineData("labels.jsonl", "report")]
    [InlineData("frames/00000000.png", "validate")]
    [InlineData("frames/00000000.png", "report")]
    [InlineData("frames/00000000.png", "report", "--still", "0", "--out", "OUT.png")]
    [InlineData("frames/00000000.png", "export", "--format", "csv", "--out", "OUT")]
    [InlineData("frames/00000000.png", "export", "--format", "webdataset", "--out", "OUT")]
    [InlineData("frames/00000000.png", "relabel", "--no-report", "--out", "OUT")]
    [InlineData("frames/00000000.png", "repair", "--out", "OUT")]
    [InlineData("masks/00000000.png", "validate")]
    [InlineData("masks/00000000.png", "export", "--format", "coco", "--out", "OUT")]
    [InlineData("scenes/00000000.json", "validate")]
    [InlineData("scenes/00000000.json", "relabel", "--no-report", "--out", "OUT")]
    [InlineData("scenes/roads.csv", "validate")]
    [InlineData("scenes/spaces.csv", "validate")]
    public void Pipe_in_the_place_of_a_session_file_is_refused(string name, string command, params string[] options)
    {
        _hostile.ReplaceByPipe(name);

        HostileSession.AssertRefused(
            "pipe",
            [command, _hostile.Folder, .. options.Select(word => word.Replace("OUT", _hostile.PathOf("out"), StringComparison.Ordinal))]
        );
    }

    [PosixTheory]
    [InlineData("roads", "info", "PIPE")]
    [InlineData("spaces", "check", "PIPE")]
    [InlineData("spaces", "gallery", "PIPE", "--out", "OUT.html")]
    [InlineData("boxes", "PIPE")]
    [InlineData("contact-sheet", "--roads", "ROADS", "--list", "PIPE", "--out", "OUT.png")]
    [InlineData("contact-sheet", "--roads", "ROADS", "--props", "PIPE", "--out", "OUT.png")]
    [InlineData("doctor", "PIPE")]
    [InlineData("tape", "play", "PIPE")]
    [InlineData("lanes", "--roads", "ROADS", "--position", "0,0,0", "--heading", "0", "--vehicles", "PIPE")]
    [InlineData("project", "--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50", "--size", "80x60", "--points", "PIPE")]
    [InlineData("project", "--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50", "--size", "80x60", "--calibration", "PIPE")]
    public void Pipe_named_on_the_command_line_is_refused(params string[] command)
    {
        _hostile.ReplaceByPipe("pipe");

        HostileSession.AssertRefused(
            "pipe",
            [
                .. command.Select(word =>
                    word.Replace("OUT", _hostile.PathOf("out"), StringComparison.Ordinal)
                        .Replace("PIPE", _hostile.In("pipe"), StringComparison.Ordinal)
                        .Replace("ROADS", _hostile.In("scenes/roads.csv"), StringComparison.Ordinal)
                ),
            ]
        );
    }

    [PosixFact]
    public void Device_in_the_place_of_a_picture_is_refused()
    {
        File.Delete(_hostile.In("frames/00000000.png"));
        File.CreateSymbolicLink(_hostile.In("frames/00000000.png"), "/dev/zero");
        HostileSession.AssertRefused("points outside", "report", _hostile.Folder);

        _hostile.Replace("labels.jsonl", "frames/00000000.png", "/dev/zero");
        HostileSession.AssertRefused("must name a picture", "report", _hostile.Folder);
    }
}
