using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// A session with more frames than an export can do before it is killed: a few harvested ones over and over. A second, short one is for
/// formats that keep sessions whole, so that there is one for each of two splits.
/// </summary>
public sealed class LongSession : IDisposable
{
    public const int Frames = 300;
    public const int HarvestedFrames = 8;

    private readonly TemporaryFolder _folder = new();

    public LongSession()
    {
        Assert.Equal(
            ExitCode.Done,
            CliRun
                .Of(
                    "harvest",
                    "--out",
                    Folder,
                    "--frames",
                    $"{HarvestedFrames}",
                    "--seed",
                    "5",
                    "--size",
                    "80x60",
                    "--masks",
                    "--semantics",
                    "rays",
                    "--no-report"
                )
                .ExitCode
        );
        Copy(Folder, ShortFolder);
        string[] lines = File.ReadAllLines(Path.Combine(Folder, "labels.jsonl"));
        for (int frame = HarvestedFrames; frame < Frames; frame++)
        {
            File.AppendAllText(Path.Combine(Folder, "labels.jsonl"), Again(lines[frame % HarvestedFrames], frame) + "\n");
        }
    }

    public string Folder => _folder.PathOf("session");

    public string ShortFolder => _folder.PathOf("short");

    public void Dispose() => _folder.Dispose();

    private static void Copy(string from, string to)
    {
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
    }

    private string Again(string line, int frame)
    {
        JsonNode label = JsonNode.Parse(line)!;
        label["frame"] = frame;
        CopyPicture(label, "image", $"frames/{frame:D8}.png");
        CopyPicture(label, "mask", $"masks/{frame:D8}.png");
        CopyPicture(label["classMap"]!, "file", $"classes/{frame:D8}.png");

        return label.ToJsonString();
    }

    private void CopyPicture(JsonNode label, string field, string name)
    {
        File.Copy(Path.Combine(Folder, label[field]!.GetValue<string>()), Path.Combine(Folder, name));
        label[field] = name;
    }
}
