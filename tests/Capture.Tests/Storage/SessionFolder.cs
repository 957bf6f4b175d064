using System.Text.Json;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

/// <summary>A folder for one test, and what a session in it must be like whatever happened.</summary>
internal sealed class SessionFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("harvest").FullName;

    public string Session => System.IO.Path.Combine(Path, "session");

    public string Text(string name) => File.ReadAllText(System.IO.Path.Combine(Session, name));

    public string[] LabelLines =>
        File.Exists(System.IO.Path.Combine(Session, "labels.jsonl"))
            ? File.ReadAllLines(System.IO.Path.Combine(Session, "labels.jsonl"))
            : [];

    /// <summary>Checks that each label line and its files are complete, and returns the number of lines.</summary>
    public int CheckValid()
    {
        string[] lines = LabelLines;
        for (int i = 0; i < lines.Length; i++)
        {
            JsonElement label = JsonDocument.Parse(lines[i]).RootElement;
            Assert.Equal(i, label.GetProperty("frame").GetInt32());
            foreach (string kind in new[] { "image", "mask" })
            {
                if (label.GetProperty(kind).GetString() is { } file)
                {
                    TestPngDecoder decoded = TestPngDecoder.Decode(File.ReadAllBytes(System.IO.Path.Combine(Session, file)));
                    Assert.Equal(label.GetProperty("camera").GetProperty("width").GetInt32(), decoded.Width);
                }
            }
        }

        Assert.Empty(Directory.EnumerateFiles(Session, "*.partial", SearchOption.AllDirectories));
        if (File.Exists(System.IO.Path.Combine(Session, "session.json")))
        {
            JsonDocument.Parse(Text("session.json"));
        }

        return lines.Length;
    }

    public IReadOnlyDictionary<string, byte[]> Files() =>
        Directory
            .EnumerateFiles(Session, "*", SearchOption.AllDirectories)
            .ToDictionary(file => System.IO.Path.GetRelativePath(Session, file), File.ReadAllBytes);

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
