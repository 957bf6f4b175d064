using System.Text.Json;
using System.Text.RegularExpressions;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Storage;

/// <summary>docs/dataset-format.md names every field of a label line.</summary>
public sealed class DatasetFormatTests
{
    [Fact]
    public void Document_names_every_field()
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        using var session = new HarvestSession(new HarvestOptions { Image = new ImageSize(64, 48), MaxFrames = 1 }, game.Ports, sink);
        game.Run(session);
        string[] fields = [.. Fields(JsonDocument.Parse(JsonLabelWriter.Line(sink.Frames[0].Label)).RootElement).Distinct()];
        string document = File.ReadAllText(Path.Combine(RepositoryFolder.Path, "docs", "dataset-format.md"));
        var named = Regex.Matches(document, "[a-zA-Z0-9]+").Select(match => match.Value).ToHashSet(StringComparer.Ordinal);

        Assert.Contains("occlusionMethod", fields);
        Assert.Empty(fields.Except(named));
    }

    private static IEnumerable<string> Fields(JsonElement element) =>
        element.ValueKind switch
        {
            JsonValueKind.Object => element.EnumerateObject().SelectMany(field => Fields(field.Value).Prepend(field.Name)),
            JsonValueKind.Array => element.EnumerateArray().SelectMany(Fields),
            _ => [],
        };
}
