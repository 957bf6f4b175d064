using System.Text.Json.Nodes;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A session with more frames than an export can do before it is killed: a few harvested ones over and over.</summary>
public sealed class LongSession : IDisposable
{
    public const int Frames = 600;
    private const int HarvestedFrames = 8;

    private readonly TemporaryFolder _folder = new();

    public LongSession()
    {
        Assert.Equal(ExitCode.Done, CliRun.Of(
            "harvest", "--out", Folder, "--frames", $"{HarvestedFrames}", "--seed", "5", "--size", "80x60", "--masks", "--no-report").ExitCode);
        string[] lines = File.ReadAllLines(Path.Combine(Folder, "labels.jsonl"));
        for (int frame = HarvestedFrames; frame < Frames; frame++)
        {
            File.AppendAllText(Path.Combine(Folder, "labels.jsonl"), Again(lines[frame % HarvestedFrames], frame) + "\n");
        }
    }

    public string Folder => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    private string Again(string line, int frame)
    {
        JsonNode label = JsonNode.Parse(line)!;
        label["frame"] = frame;
        foreach ((string field, string folder) in (ReadOnlySpan<(string, string)>)[("image", "frames"), ("mask", "masks")])
        {
            string name = $"{folder}/{frame:D8}.png";
            File.Copy(Path.Combine(Folder, label[field]!.GetValue<string>()), Path.Combine(Folder, name));
            label[field] = name;
        }

        return label.ToJsonString();
    }
}
